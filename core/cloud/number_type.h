// The kinds of numbers binary point files hold, and how they become doubles.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace gripscan {

enum class NumberType {
    kInt8,
    kUint8,
    kInt16,
    kUint16,
    kInt32,
    kUint32,
    kInt64,
    kUint64,
    kFloat32,
    kFloat64,
};

[[nodiscard]] constexpr std::size_t size_of(NumberType type) {
    switch (type) {
        case NumberType::kInt8:
        case NumberType::kUint8:
            return 1;
        case NumberType::kInt16:
        case NumberType::kUint16:
            return 2;
        case NumberType::kInt32:
        case NumberType::kUint32:
        case NumberType::kFloat32:
            return 4;
        default:
            return 8;
    }
}

enum class ByteOrder { kLittle, kBig };

template <typename T>
[[nodiscard]] T number_at(const char* bytes, ByteOrder order) {
    std::array<char, sizeof(T)> raw{};
    std::memcpy(raw.data(), bytes, sizeof(T));
    if (order == ByteOrder::kBig) std::reverse(raw.begin(), raw.end());
    T value;
    std::memcpy(&value, raw.data(), sizeof(T));
    return value;
}

/// The number of this type that starts at `bytes`; size_of(type) bytes are read.
[[nodiscard]] inline double number_at(const char* bytes, NumberType type,
                                      ByteOrder order = ByteOrder::kLittle) {
    switch (type) {
        case NumberType::kInt8:
            return number_at<std::int8_t>(bytes, order);
        case NumberType::kUint8:
            return number_at<std::uint8_t>(bytes, order);
        case NumberType::kInt16:
            return number_at<std::int16_t>(bytes, order);
        case NumberType::kUint16:
            return number_at<std::uint16_t>(bytes, order);
        case NumberType::kInt32:
            return number_at<std::int32_t>(bytes, order);
        case NumberType::kUint32:
            return number_at<std::uint32_t>(bytes, order);
        case NumberType::kInt64:
            return static_cast<double>(number_at<std::int64_t>(bytes, order));
        case NumberType::kUint64:
            return static_cast<double>(number_at<std::uint64_t>(bytes, order));
        case NumberType::kFloat32:
            return static_cast<double>(number_at<float>(bytes, order));
        case NumberType::kFloat64:
            return number_at<double>(bytes, order);
    }
    return 0.0;
}

}  // namespace gripscan
