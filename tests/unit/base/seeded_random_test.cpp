#include "core/base/seeded_random.h"

#include <gtest/gtest.h>

namespace gripscan {
namespace {

TEST(SeededRandom, GivesTheNumbersOfSplitMix64) {
    // First numbers of the published algorithm for these seeds.
    SeededRandom zero(0);
    EXPECT_EQ(zero.next(), 0xe220a8397b1dcdafULL);
    EXPECT_EQ(zero.next(), 0x6e789e6aa1b965f4ULL);
    EXPECT_EQ(zero.next(), 0x06c45d188009454fULL);
    SeededRandom other(1234567);
    EXPECT_EQ(other.next(), 6457827717110365317ULL);
    EXPECT_EQ(other.next(), 3203168211198807973ULL);
}

TEST(SeededRandom, HasTheMomentsItPromises) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        SeededRandom random(seed);
        constexpr int kDraws = 200000;
        double sum = 0.0;
        double square = 0.0;
        double uniform = 0.0;
        for (int i = 0; i < kDraws; ++i) {
            const double n = random.normal();
            sum += n;
            square += n * n;
            const double u = random.uniform(-2.0, 4.0);
            ASSERT_GE(u, -2.0);
            ASSERT_LT(u, 4.0);
            uniform += u;
        }
        // Five standard errors: 1/√N, √(2/N) and (6/√12)/√N.
        EXPECT_NEAR(sum / kDraws, 0.0, 0.012);
        EXPECT_NEAR(square / kDraws, 1.0, 0.016);
        EXPECT_NEAR(uniform / kDraws, 1.0, 0.020);
    }
}

}  // namespace
}  // namespace gripscan
