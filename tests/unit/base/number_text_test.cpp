#include "core/base/number_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "core/base/seeded_random.h"
#include "tests/support/comma_locale.h"

namespace gripscan {
namespace {

TEST(NumberText, ReadsBackTheSameDouble) {
    SeededRandom random(1);
    int finite = 0;
    for (int i = 0; i < 20000; ++i) {
        const std::uint64_t bits = random.next();  // any double there is
        double value = 0.0;
        std::memcpy(&value, &bits, sizeof value);
        if (!std::isfinite(value)) continue;
        ++finite;
        const auto read = number_from_text(text_from_number(value));
        ASSERT_TRUE(read.has_value()) << text_from_number(value);
        ASSERT_EQ(std::memcmp(&*read, &value, sizeof value), 0) << text_from_number(value);
    }
    EXPECT_GT(finite, 19000);
}

TEST(NumberText, IsShortAndInTheCLocale) {
    const test::CommaLocale comma;
    EXPECT_EQ(text_from_number(0.1), "0.1");
    EXPECT_EQ(text_from_number(-7.66), "-7.66");
    EXPECT_EQ(text_from_number(1e-300), "1e-300");
    EXPECT_EQ(text_from_number(1234567.5), "1234567.5");
    EXPECT_EQ(number_from_text("0.5"), 0.5);
}

TEST(NumberText, TellsWhatIsNoNumber) {
    EXPECT_EQ(text_from_number(std::nan("")), "nan");
    EXPECT_EQ(text_from_number(std::numeric_limits<double>::infinity()), "inf");
    EXPECT_EQ(text_from_number(-std::numeric_limits<double>::infinity()), "-inf");
}

TEST(NumberText, TakesWholeFiniteNumbersOnly) {
    EXPECT_EQ(number_from_text(" 12.5\t"), 12.5);
    EXPECT_EQ(number_from_text("+3"), 3.0);
    EXPECT_EQ(number_from_text("-1e3\r"), -1000.0);
    for (const char* text : {"", "  ", "abc", "1.5x", "1,5", "1 2", "nan", "inf", "-inf", "1e999",
                             "0x10", "+", "-", "--1", "+-1", "."}) {
        EXPECT_FALSE(number_from_text(text).has_value()) << "'" << text << "'";
    }
}

}  // namespace
}  // namespace gripscan
