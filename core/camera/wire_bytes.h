// Numbers as little-endian bytes, whatever the machine's order is.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace gripscan::frames {

class ByteWriter {
  public:
    void u32(std::uint32_t value) { put(value, 4); }
    void i32(std::int32_t value) { put(static_cast<std::uint32_t>(value), 4); }
    void f64(double value) { put(std::bit_cast<std::uint64_t>(value), 8); }
    void raw(std::string_view bytes) { bytes_ += bytes; }

    [[nodiscard]] std::string take() { return std::move(bytes_); }

  private:
    void put(std::uint64_t value, int bytes) {
        for (int i = 0; i < bytes; ++i) {
            bytes_.push_back(static_cast<char>(static_cast<unsigned char>(value >> (8 * i))));
        }
    }
    std::string bytes_;
};

/// Once it has run short it gives zeros; ask is_short() or is_at_end() at the end.
class ByteReader {
  public:
    explicit ByteReader(std::string_view bytes) : left_(bytes) {}

    std::uint32_t u32() { return static_cast<std::uint32_t>(get(4)); }
    std::int32_t i32() { return static_cast<std::int32_t>(u32()); }
    double f64() { return std::bit_cast<double>(get(8)); }
    std::string_view raw(std::size_t count) {
        if (count > left_.size()) {
            short_ = true;
            left_ = {};
            return {};
        }
        const std::string_view bytes = left_.substr(0, count);
        left_.remove_prefix(count);
        return bytes;
    }

    [[nodiscard]] bool is_short() const { return short_; }
    [[nodiscard]] bool is_at_end() const { return left_.empty() && !short_; }
    [[nodiscard]] std::size_t left() const { return left_.size(); }

  private:
    std::uint64_t get(std::size_t count) {
        const std::string_view bytes = raw(count);
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            value |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
        }
        return value;
    }
    std::string_view left_;
    bool short_ = false;
};

}  // namespace gripscan::frames
