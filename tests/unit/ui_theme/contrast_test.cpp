// Every pair of text and surface of the window can be read (WCAG 2.1 AA), in both themes.
#include <gtest/gtest.h>

#include <vector>

#include "ui/theme/on_plate.h"
#include "ui/theme/theme.h"

namespace gripscan::ui {
namespace {

using Member = Colour Theme::*;
struct Use {
    Member colour;
    double least;  ///< 4.5 for text, 3 for borders and marks
    std::vector<Member> on;
};

const std::vector<Use>& uses() {
    static const std::vector<Use> all{
        {&Theme::text,
         4.5,
         {&Theme::bg0, &Theme::panel, &Theme::raised, &Theme::hover, &Theme::select,
          &Theme::accent_bg, &Theme::ok_bg, &Theme::check_bg, &Theme::reject_bg, &Theme::sim_bg,
          &Theme::view_top, &Theme::view_bottom, &Theme::input}},
        {&Theme::text_second,
         4.5,
         {&Theme::bg0, &Theme::panel, &Theme::raised, &Theme::hover, &Theme::select,
          &Theme::accent_bg, &Theme::ok_bg, &Theme::check_bg, &Theme::reject_bg,
          &Theme::view_bottom}},
        {&Theme::text_third,
         4.5,
         {&Theme::bg0, &Theme::panel, &Theme::raised, &Theme::select, &Theme::input,
          &Theme::view_bottom}},
        {&Theme::accent, 3.0, {&Theme::panel, &Theme::accent_bg, &Theme::select}},
        {&Theme::accent_on, 4.5, {&Theme::accent}},
        {&Theme::accent_text,
         4.5,
         {&Theme::panel, &Theme::accent_bg, &Theme::select, &Theme::view_top, &Theme::view_bottom}},
        {&Theme::ok, 4.5, {&Theme::panel, &Theme::ok_bg, &Theme::select}},
        {&Theme::check, 4.5, {&Theme::panel, &Theme::check_bg, &Theme::select}},
        {&Theme::reject, 4.5, {&Theme::panel, &Theme::raised, &Theme::reject_bg}},
        {&Theme::live_on, 4.5, {&Theme::live}},
        {&Theme::sim, 4.5, {&Theme::panel, &Theme::sim_bg}},
        {&Theme::axis, 4.5, {&Theme::view_top, &Theme::view_bottom}},
        {&Theme::gripper, 4.5, {&Theme::view_top, &Theme::view_bottom}},
        {&Theme::object, 4.5, {&Theme::view_top, &Theme::view_bottom}},
        {&Theme::edge, 3.0, {&Theme::panel, &Theme::input}},
        {&Theme::axis_x, 3.0, {&Theme::panel, &Theme::view_bottom}},
        {&Theme::axis_y, 3.0, {&Theme::panel, &Theme::view_bottom}},
        {&Theme::axis_z, 3.0, {&Theme::panel, &Theme::view_bottom}},
        {&Theme::target, 3.0, {&Theme::view_top, &Theme::view_bottom}},
        {&Theme::source, 3.0, {&Theme::view_top, &Theme::view_bottom}},
        {&Theme::plate_text, 4.5, {&Theme::plate}},
    };
    return all;
}

std::string_view name_of(Member colour) {
    for (const ThemeToken& token : theme_tokens()) {
        if (token.colour == colour) return token.name;
    }
    return "?";
}

class Contrast : public testing::TestWithParam<ThemeChoice> {};

TEST_P(Contrast, OfEveryPairThatIsUsedIsEnough) {
    const auto theme = load_theme(GetParam());
    ASSERT_TRUE(theme.has_value()) << theme.error().message;
    for (const Use& use : uses()) {
        for (const Member surface : use.on) {
            EXPECT_GE(contrast((*theme).*use.colour, (*theme).*surface), use.least)
                << name_of(use.colour) << " on " << name_of(surface);
        }
    }
}

TEST_P(Contrast, OfLabelsOnTheBrightestImageIsEnough) {
    const auto theme = load_theme(GetParam());
    ASSERT_TRUE(theme.has_value());
    const Colour surface = over(theme->plate, {255, 255, 255});
    EXPECT_GE(contrast(theme->plate_text, surface), 4.5);
    for (const Member colour : {&Theme::axis, &Theme::gripper, &Theme::object, &Theme::target_safe,
                                &Theme::source_safe, &Theme::ok, &Theme::check, &Theme::reject}) {
        EXPECT_GE(contrast(on_plate(*theme, (*theme).*colour), surface), 4.5) << name_of(colour);
    }
}

TEST(OnPlate, KeepsAColourThatCanBeReadAndTheHueOfOneThatCannot) {
    const auto dark = load_theme(ThemeChoice::kDark);
    const auto light = load_theme(ThemeChoice::kLight);
    ASSERT_TRUE(dark && light);
    EXPECT_EQ(on_plate(*dark, dark->axis), dark->axis);
    const Colour axis = on_plate(*light, light->axis);
    EXPECT_NE(axis, light->axis);
    EXPECT_TRUE(axis.r > axis.g && axis.g > axis.b) << "still a warm one";
}

INSTANTIATE_TEST_SUITE_P(Themes, Contrast, testing::Values(ThemeChoice::kDark, ThemeChoice::kLight),
                         [](const auto& choice) {
                             return choice.param == ThemeChoice::kDark ? "Dark" : "Light";
                         });

TEST(ContrastRatio, IsThatOfTheStandard) {
    EXPECT_NEAR(contrast({0, 0, 0}, {255, 255, 255}), 21.0, 1e-9);
    EXPECT_NEAR(contrast({119, 119, 119}, {255, 255, 255}), 4.48, 0.005);  // the well-known #777
    EXPECT_EQ(contrast({1, 2, 3}, {1, 2, 3}), 1.0);
}

}  // namespace
}  // namespace gripscan::ui
