// Any value of a type that a journal holds: goes through its `fields(io, value)` as reader and
// writer do, and fills in what is hard on them.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "core/procedure/field_path.h"
#include "core/procedure/field_words.h"
#include "tests/support/random_pose.h"

namespace gripscan::test {

class RandomFields {
  public:
    explicit RandomFields(SeededRandom& random) : random_(random) {}

    void operator()(std::string_view, double& value) { value = number(); }
    void operator()(std::string_view, bool& value) { value = chance(); }
    void operator()(std::string_view, int& value) {
        value = static_cast<int>(static_cast<std::uint32_t>(random_.next()));
    }
    void operator()(std::string_view, std::size_t& value) { value = random_.next(); }
    void operator()(std::string_view, std::string& value) { value = kTexts[below(kTexts.size())]; }
    void operator()(std::string_view, std::array<double, 6>& values) {
        for (double& value : values) value = number();
    }
    void operator()(std::string_view, Eigen::Vector3d& value) {
        value = {number(), number(), number()};
    }
    void operator()(std::string_view, Pose& T) { T = random_pose(random_, 3.1); }

    template <typename T>
    void operator()(std::string_view name, T& value) {
        if constexpr (kIsOptional<T>) {
            value.reset();
            if (chance()) (*this)(name, value.emplace());
        } else if constexpr (kIsList<T>) {
            value.resize(below(4));
            for (auto& item : value) (*this)(name, item);
        } else if constexpr (std::is_enum_v<T>) {
            value = static_cast<T>(below(static_cast<std::size_t>(kLastOf<T>) + 1));
        } else {
            fields(*this, value);
        }
    }

  private:
    static constexpr std::array<std::string_view, 8> kTexts{
        "",    "plain", "two\nlines\r\n", "Würfel \u6f22 \U0001f916", " blanks ", "a=\"b\\\";,{}",
        "3.5", "\t"};

    bool chance() { return random_.uniform() < 0.5; }
    std::size_t below(std::size_t count) { return random_.next() % count; }

    /// Half of them from all finite bit patterns: subnormal, huge, −0.
    double number() {
        if (random_.uniform() < 0.05) return -0.0;
        if (chance()) return random_.normal();
        for (;;) {
            const auto value = std::bit_cast<double>(random_.next());
            if (std::isfinite(value)) return value;
        }
    }

    SeededRandom& random_;
};

}  // namespace gripscan::test
