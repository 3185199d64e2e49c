#include <gtest/gtest.h>

#include <limits>

#include "tests/support/ui_driver.h"
#include "ui/imgui_compat.h"
#include "ui/widgets/draw.h"
#include "ui/widgets/rich_text.h"

namespace gripscan::ui {
namespace {

using test::UiDriver;

TEST(ShownNumber, HasATrueMinusAndFixedDecimals) {
    EXPECT_EQ(shown_number(-0.0214, 3), "−0.021");
    EXPECT_EQ(shown_number(0.0889, 3, Sign::kAlways), "+0.089");
    EXPECT_EQ(shown_number(-0.0001, 2), "0.00") << "no minus before nothing";
    EXPECT_EQ(shown_number(12, 0), "12");
    EXPECT_EQ(shown_number(std::numeric_limits<double>::quiet_NaN(), 2), "–");
}

TEST(ShownCount, PartsThousands) {
    EXPECT_EQ(shown_count(0), "0");
    EXPECT_EQ(shown_count(999), "999");
    EXPECT_EQ(shown_count(412870), "412\u00a0870");
    EXPECT_EQ(shown_count(-1234567), "−1\u00a0234\u00a0567");
}

TEST(Fitted, CutsWholeLettersAndNeverExceedsTheWidth) {
    UiDriver driver(400, 100, [](const Ui& ui) {
        const std::string text = "Gripper müde, größer als nötig";
        for (float width = 0.0F; width < 260.0F; width += 3.0F) {
            const std::string cut = fitted(ui, FontRole::kTable, text, width);
            EXPECT_LE(text_width(ui, FontRole::kTable, cut), width);
            if (cut != text && !cut.empty()) {
                const std::string kept = cut.substr(0, cut.size() - 3);
                EXPECT_EQ(text.substr(0, kept.size()), kept);
                const bool inside_letter =
                    (static_cast<unsigned char>(text[kept.size()]) & 0xC0U) == 0x80U;
                EXPECT_FALSE(inside_letter) << cut;
            }
        }
    });
    driver.frame();
}

TEST(FittedMiddle, KeepsTheEndOfAPath) {
    UiDriver driver(400, 100, [](const Ui& ui) {
        const std::string path = "/Anlagen/Prüf/gripscan/object-2026/exports/Größe_v12.pcd";
        EXPECT_EQ(fitted_middle(ui, FontRole::kTable, path, 2000.0F), path);
        for (float width = 60.0F; width < 360.0F; width += 7.0F) {
            const std::string cut = fitted_middle(ui, FontRole::kTable, path, width);
            EXPECT_LE(text_width(ui, FontRole::kTable, cut), width);
            const std::size_t gap = cut.find("…");
            if (cut == path) continue;
            ASSERT_NE(gap, std::string::npos) << cut;
            EXPECT_TRUE(path.starts_with(cut.substr(0, gap))) << cut;
            EXPECT_TRUE(path.ends_with(cut.substr(gap + std::string("…").size()))) << cut;
        }
        const std::string cut = fitted_middle(ui, FontRole::kTable, path, 200.0F);
        EXPECT_TRUE(cut.ends_with("_v12.pcd")) << cut;
    });
    driver.frame();
}

TEST(RichText, TakesMoreLinesInLessWidth) {
    UiDriver driver(800, 200, [](const Ui& ui) {
        const auto height = [&](int width) {
            return rich_text_height(ui, width, "ICP turned `9.977°`, the robot `9.998°`: error");
        };
        EXPECT_EQ(height(2000), ui.em(1.5F));
        EXPECT_EQ(height(180), 2 * ui.em(1.5F));
        EXPECT_EQ(draw_rich_text(ui, 0, 0, 180, ui.theme.text,
                                 "ICP turned `9.977°`, the robot `9.998°`: error"),
                  height(180));
    });
    driver.frame();
}

TEST(Fonts, HaveEveryLetterAndIconTheWindowWrites) {
    UiDriver driver(100, 100, [](const Ui& ui) {
        for (const FontRole role : {FontRole::kText, FontRole::kTable, FontRole::kNumberTable,
                                    FontRole::kNumberCaption, FontRole::kDial}) {
            for (const ImWchar letter : {u'A', u'9', u'−', u'–', u'…', u'≤', u'≥', u'±', u'°', u'½',
                                         u'×', u'Δ', u'σ', u'→', u'·', u'ü', u'µ'}) {
                EXPECT_NE(ui.fonts[role]->FindGlyphNoFallback(letter), nullptr)
                    << static_cast<int>(role) << " " << static_cast<int>(letter);
            }
        }
        for (const Icon icon : kIcons) {
            const auto* glyph =
                ui.fonts[FontRole::kIcon]->FindGlyphNoFallback(static_cast<ImWchar>(icon));
            ASSERT_NE(glyph, nullptr) << static_cast<unsigned>(icon);
            EXPECT_TRUE(glyph->Visible) << static_cast<unsigned>(icon);
        }
    });
    driver.frame();
}

TEST(Fonts, NumbersStandInColumns) {
    UiDriver driver(100, 100, [](const Ui& ui) {
        const float one = text_width(ui, FontRole::kNumberTable, "1");
        for (const char* letter : {"0", "8", ".", "−", "+", "°"}) {
            EXPECT_FLOAT_EQ(text_width(ui, FontRole::kNumberTable, letter), one) << letter;
        }
    });
    driver.frame();
}

TEST(Session, AScaleChangeBakesTheFontsAnewBetweenFrames) {
    float em = 0.0F;
    UiDriver driver(400, 200,
                    [&](const Ui& ui) { em = text_width(ui, FontRole::kText, "gripscan"); });
    EXPECT_TRUE(driver.session().fonts_changed());
    driver.frame();
    const float at_100 = em;
    ASSERT_TRUE(driver.session().set_scale(Scale(1.0F)).has_value());
    EXPECT_FALSE(driver.session().fonts_changed()) << "the same scale";
    ASSERT_TRUE(driver.session().set_scale(Scale(2.0F)).has_value());
    EXPECT_TRUE(driver.session().fonts_changed());
    EXPECT_FALSE(driver.session().fonts_changed()) << "told once";
    driver.frame();
    EXPECT_NEAR(em, 2.0F * at_100, 1.0F);
    EXPECT_EQ(ImGui::GetStyle().FrameBorderSize, 2.0F);
    ASSERT_TRUE(driver.session().set_scale(Scale(1.0F)).has_value());
    driver.frame();
    EXPECT_EQ(em, at_100);
    EXPECT_EQ(ImGui::GetStyle().FrameBorderSize, 1.0F);
}

}  // namespace
}  // namespace gripscan::ui
