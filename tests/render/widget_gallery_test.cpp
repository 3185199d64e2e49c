#include "tests/render/widget_gallery.h"

#include <gtest/gtest.h>

#include "tests/render/screen_picture.h"
#include "tests/support/egl_context.h"

namespace gripscan::test {
namespace {

struct Look {
    const char* name;
    ui::ThemeChoice theme;
    float scale;
};

class WidgetGallery : public testing::TestWithParam<Look> {};

TEST_P(WidgetGallery, LooksAsItWasApproved) {
    const auto context = EglContext::make();
    ASSERT_NE(context, nullptr);
    const auto& [name, theme, factor] = GetParam();
    const auto size = [f = factor](int px) { return static_cast<int>(f * static_cast<float>(px)); };
    const Picture picture = screen_picture(size(kGalleryWidth), size(kGalleryHeight),
                                           ui::Scale(factor), theme, draw_widget_gallery);
    expect_golden(picture, std::string("widgets-") + name);
}

INSTANTIATE_TEST_SUITE_P(Looks, WidgetGallery,
                         testing::Values(Look{"dark_100", ui::ThemeChoice::kDark, 1.0F},
                                         Look{"light_100", ui::ThemeChoice::kLight, 1.0F},
                                         Look{"dark_200", ui::ThemeChoice::kDark, 2.0F},
                                         Look{"light_200", ui::ThemeChoice::kLight, 2.0F}),
                         [](const auto& look) { return std::string(look.param.name); });

TEST(GoldenImages, TellPicturesApart) {
    Picture one{2, 1, {10, 10, 10, 255, 200, 200, 200, 255}};
    Picture other = one;
    EXPECT_EQ(different_pixels(one, other), 0U);
    other.rgba[0] = 10 + ImageTolerance::kChannel;
    EXPECT_EQ(different_pixels(one, other), 1U);
    other.width = 1;
    EXPECT_EQ(different_pixels(one, other), 2U);
}

}  // namespace
}  // namespace gripscan::test
