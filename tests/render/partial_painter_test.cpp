// What is drawn again bit by bit is the same picture as one drawn at once.
#include "ui/shell/partial_painter.h"

#include <gtest/gtest.h>

#include "core/base/seeded_random.h"
#include "tests/support/egl_context.h"
#include "tests/support/ui_driver.h"
#include "ui/gl/image_texture.h"
#include "ui/imgui_compat.h"
#include "ui/shell/opaque_picture.h"
#include "ui/widgets/draw.h"

namespace gripscan::test {
namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 400;

struct Patch {
    ui::Rect rect;
    ImU32 colour;
    bool words;
    GLuint picture;  ///< 0: a rectangle of that colour instead
};

/// Rectangles and words, a few of which change from frame to frame.
void draw(const ui::Ui& ui, const std::vector<Patch>& patches) {
    for (const Patch& p : patches) {
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImVec2 from(static_cast<float>(p.rect.x) + 0.3F, static_cast<float>(p.rect.y) + 0.7F);
        if (p.picture != 0) {
            const auto x = static_cast<float>(p.rect.x);
            const auto y = static_cast<float>(p.rect.y);
            list.AddImage(ui::imgui_texture(p.picture), {x, y}, {x + 300.0F, y + 230.0F});
            continue;
        }
        list.PushClipRect({from.x + 1.6F, from.y}, {from.x + static_cast<float>(p.rect.width),
                                                    from.y + static_cast<float>(p.rect.height)});
        list.AddRectFilled(from, {from.x + 200.0F, from.y + 90.0F}, p.colour, 7.0F);
        if (p.words) {
            ui::draw_text(ui, from.x + 5.0F, from.y + 12.0F, ui::FontRole::kText, ui.theme.text,
                          "0.021° Grüße");
        }
        list.PopClipRect();
    }
}

Patch random_patch(SeededRandom& random, GLuint picture) {
    const auto below = [&](int n) {
        return static_cast<int>(random.next() % static_cast<unsigned>(n));
    };
    return {{below(kWidth), below(kHeight), 20 + below(200), 10 + below(90)},
            IM_COL32(below(256), below(256), below(256), 60 + below(196)),
            below(2) == 0,
            below(4) == 0 ? picture : 0};
}

TEST(PartialPainter, DrawsWhatDrawingAllWouldShow) {
    const auto context = EglContext::make();
    if (!context) GTEST_SKIP() << "no OpenGL without a screen here";
    for (const std::uint64_t seed : {1, 2, 3}) {
        SeededRandom random(seed);
        ui::ImageTexture texture;
        std::vector<std::uint8_t> pixels(64 * 64);
        for (std::uint8_t& pixel : pixels) pixel = static_cast<std::uint8_t>(random.next());
        texture.upload_grey(64, 64, pixels.data(), 64);
        std::vector<Patch> patches;
        for (int i = 0; i < 12; ++i) patches.push_back(random_patch(random, texture.name()));
        UiDriver driver(
            kWidth, kHeight, [&](const ui::Ui& ui) { draw(ui, patches); }, ui::Scale(),
            ui::ThemeChoice::kDark);
        auto painter = ui::ImGuiPainter::make();
        ASSERT_TRUE(painter);
        ui::ImGuiPainter& whole = **painter;
        auto bit_by_bit = ui::RenderTarget::make(kWidth, kHeight, ui::DepthTexture::kNone);
        auto at_once = ui::RenderTarget::make(kWidth, kHeight, ui::DepthTexture::kNone);
        ASSERT_TRUE(bit_by_bit && at_once);
        std::uint64_t version = 0;
        const auto is_texture = [&](ImTextureID id) {
            return id == ui::imgui_texture(texture.name());
        };
        ui::Damage damage([&](ImTextureID id) { return is_texture(id) ? version : 0; }, is_texture);
        std::size_t drawn_px = 0;
        std::size_t covered = 0;
        constexpr int kFrames = 40;
        for (int frame = 0; frame < kFrames; ++frame) {
            whole.begin_frame(driver.session().fonts_changed());
            driver.frame();
            at_once->bind();
            whole.paint();
            bit_by_bit->bind();
            const ImDrawData& data = *ImGui::GetDrawData();
            for (const ui::Piece& piece : damage.next(data)) {
                const ui::ClippedFrame clipped(data, piece.rect, piece.first_command);
                whole.paint();
                covered += piece.first_command > 0 ? 1 : 0;
                drawn_px += static_cast<std::size_t>(piece.rect.width) *
                            static_cast<std::size_t>(piece.rect.height);
            }
            ASSERT_EQ(bit_by_bit->read_rgba(), at_once->read_rgba()) << "frame " << frame;
            if (frame % 3 == 0) {  // the picture is painted anew, now and then together with others
                for (std::uint8_t& pixel : pixels) {
                    pixel = static_cast<std::uint8_t>(random.next());
                }
                texture.upload_grey(64, 64, pixels.data(), 64);
                ++version;
            }
            if (frame % 4 == 0) continue;
            patches[random.next() % patches.size()] = random_patch(random, texture.name());
        }
        EXPECT_GT(covered, 0U);  // a picture hid what lies under it
        EXPECT_LT(drawn_px, static_cast<std::size_t>(kFrames) * kWidth * kHeight * 6 / 10);
    }
}

TEST(Damage, IsNothingWhereNothingChangedAndAllAfterItWasForgotten) {
    UiDriver driver(kWidth, kHeight, [](const ui::Ui& ui) {
        ui::fill({10, 10, 40, 40}, ui.theme.accent);
    });
    std::uint64_t version = 0;
    ui::Damage damage([&](ImTextureID) { return version; }, {});
    const std::vector<ui::Piece> all{{{0, 0, kWidth, kHeight}, 0}};
    driver.frame();
    EXPECT_EQ(damage.next(*ImGui::GetDrawData()), all);
    driver.frame();
    EXPECT_TRUE(damage.next(*ImGui::GetDrawData()).empty());
    version = 1;  // another picture in the same texture
    EXPECT_FALSE(damage.next(*ImGui::GetDrawData()).empty());
    damage.forget();
    EXPECT_EQ(damage.next(*ImGui::GetDrawData()), all);
}

TEST(Damage, IsTheWholePictureWhereAnotherTextureTakesItsPlace) {
    // Textures have small names, and change a small number of times: all pairs of both.
    GLuint name = 1;
    std::uint64_t version = 0;
    const ui::Rect place{64, 64, 160, 128};
    UiDriver driver(kWidth, kHeight, [&](const ui::Ui&) {
        ImGui::GetWindowDrawList()->AddImage(ui::imgui_texture(name), {64.0F, 64.0F},
                                             {224.0F, 192.0F});
    });
    for (GLuint other = 2; other < 6; ++other) {
        for (std::uint64_t before = 1; before < 8; ++before) {
            for (std::uint64_t after = 1; after < 8; ++after) {
                ui::Damage damage([&](ImTextureID) { return version; }, {});
                name = 1;
                version = before;
                driver.frame();
                (void)damage.next(*ImGui::GetDrawData());
                name = other;
                version = after;
                driver.frame();
                const auto pieces = damage.next(*ImGui::GetDrawData());
                ASSERT_EQ(pieces.size(), 1U) << other << ", " << before << " and " << after;
                EXPECT_TRUE(place.inside(pieces[0].rect));
            }
        }
    }
}

}  // namespace
}  // namespace gripscan::test
