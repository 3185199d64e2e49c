// A frame that stands out from its neighbours is named; frames that vary as a turning part does are
// not.
#include "core/registration/image_health.h"

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace gripscan {
namespace {

const ImageHealth kUsual{.fill = 0.8, .glare = 0.002, .contrast = 10.0, .sharpness = 0.6};

std::vector<ImageHealth> neighbours() {
    std::vector<ImageHealth> others(6, kUsual);
    others[1].contrast = 8.0;
    others[2].sharpness = 0.7;
    others[3].fill = 0.7;
    others[4].glare = 0.006;
    return others;
}

struct Case {
    std::string name;
    ImageHealth health;
    Cause cause;
    bool hurts;
    std::string says;
};

ImageHealth changed(double ImageHealth::*field, double value, double fill = 0.8) {
    ImageHealth health = kUsual;
    health.fill = fill;
    health.*field = value;
    return health;
}

class ImageFaults : public testing::TestWithParam<Case> {};

TEST_P(ImageFaults, AsTheTableSays) {
    const Case& c = GetParam();
    const auto fault = image_fault(c.health, neighbours());
    ASSERT_EQ(fault.has_value(), c.cause != Cause::kNone) << (fault ? fault->sentence : "");
    if (!fault) return;
    EXPECT_EQ(word(fault->cause), word(c.cause));
    EXPECT_EQ(fault->hurts, c.hurts);
    EXPECT_GT(fault->excess, 1.0);
    EXPECT_THAT(fault->sentence, testing::HasSubstr(c.says));
}

INSTANTIATE_TEST_SUITE_P(
    Table, ImageFaults,
    testing::Values(
        Case{"AsTheOthers", kUsual, Cause::kNone, false, ""},
        Case{"AnotherSideOfThePart",
             {.fill = 0.65, .glare = 0.012, .contrast = 6.5, .sharpness = 0.45},
             Cause::kNone,
             false,
             ""},
        Case{"Glare", changed(&ImageHealth::glare, 0.09), Cause::kExposure, false, "9.0 %"},
        Case{"GlareThatHidesTheSurface", changed(&ImageHealth::glare, 0.3, 0.3), Cause::kExposure,
             true, "stereo fills 30 %"},
        Case{"OutOfFocus", changed(&ImageHealth::sharpness, 0.2), Cause::kTexture, false,
             "out of focus"},
        Case{"OutOfFocusSoThatNothingMatches", changed(&ImageHealth::sharpness, 0.2, 0.2),
             Cause::kTexture, true, "out of focus"},
        Case{"Flat", changed(&ImageHealth::contrast, 3.0), Cause::kTexture, false, "contrast"},
        Case{"LowFillAloneIsNoFaultOfTheImages", changed(&ImageHealth::fill, 0.3), Cause::kNone,
             false, ""}),
    [](const auto& test) { return test.param.name; });

TEST(ImageFaultsAlone, OnlyWhatIsWrongByItselfCounts) {
    const std::vector<ImageHealth> one(1, kUsual);
    EXPECT_FALSE(image_fault(changed(&ImageHealth::sharpness, 0.2), one));
    EXPECT_FALSE(image_fault(changed(&ImageHealth::glare, 0.1), {}));
    ASSERT_TRUE(image_fault(changed(&ImageHealth::glare, 0.3), {}));
    ASSERT_TRUE(image_fault(changed(&ImageHealth::contrast, 1.0), one));
    EXPECT_EQ(image_fault(changed(&ImageHealth::contrast, 1.0), one)->cause, Cause::kTexture);
}

}  // namespace
}  // namespace gripscan
