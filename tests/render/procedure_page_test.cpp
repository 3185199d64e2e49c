#include "tests/render/procedure_page.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/render/screen_picture.h"
#include "tests/support/egl_context.h"

namespace gripscan::test {
namespace {

using namespace gripscan::ui;

struct Look {
    const char* name;
    Sample (*sample)();
    ThemeChoice theme = ThemeChoice::kDark;
    float scale = 1.0F;
    int width = 1600;
    int height = 1000;
    DockTab tab = DockTab::kTable;
    MotionMode mode = MotionMode::kSim;
};

/// Everything but the fields of the 3D view and the stereo images, which other tests look at: the
/// bars, the right column and the dock, put together.
Picture without_fields(const Picture& whole, const Rect& column, const Rect& dock, int bars) {
    const int width = whole.width;
    const auto row = [&](int y) { return whole.rgba.begin() + 4L * width * y; };
    Picture kept{width, 0, {}};
    const auto add = [&](int y) {
        kept.rgba.insert(kept.rgba.end(), row(y), row(y + 1));
        ++kept.height;
    };
    for (int y = 0; y < bars; ++y) add(y);
    for (int y = dock.y; y < whole.height; ++y) add(y);
    // The card stands alone below.
    for (int y = column.y; y < column.bottom(); ++y) {
        kept.rgba.insert(kept.rgba.end(), row(y) + 4L * column.x, row(y) + 4L * column.right());
        kept.rgba.insert(kept.rgba.end(), 4UL * static_cast<unsigned>(width - column.width), 0);
        ++kept.height;
    }
    return kept;
}

class ProcedurePage : public testing::TestWithParam<Look> {};

TEST_P(ProcedurePage, LooksAsItWasApproved) {
    const auto context = EglContext::make();
    ASSERT_NE(context, nullptr);
    const Look& look = GetParam();
    Sample sample = look.sample();
    set_mode(sample, look.mode);
    sample.snapshot.preferences.theme = look.theme;
    const auto px = [&](int length) {
        return static_cast<int>(look.scale * static_cast<float>(length));
    };
    const int width = px(look.width);
    const int height = px(look.height);
    ProcedurePageState local;
    local.dock.tab = look.tab;
    Requests out;
    PictureCache pictures;
    const Picture whole =
        screen_picture(width, height, Scale(look.scale), look.theme, [&](const Ui& ui) {
            draw_procedure_page(ui, width, height, sample, local, &pictures, out);
        });
    EXPECT_TRUE(out.empty()) << "panels ask for nothing by themselves";
    const Scale scale(look.scale);
    const WindowLayout at =
        layout_window(width, height, default_splits(width, height, scale), scale);
    expect_golden(without_fields(whole, at.step_card, at.table, at.stage_bar.bottom()),
                  std::string("procedure-") + look.name);
}

INSTANTIATE_TEST_SUITE_P(
    Looks, ProcedurePage,
    testing::Values(Look{"empty-dark", sample_empty},
                    Look{"checked-light", sample_cell_checked, ThemeChoice::kLight},
                    Look{"running-dark", sample_running},
                    Look{"running-light", sample_running, ThemeChoice::kLight},
                    Look{"running-dark-200", sample_running, ThemeChoice::kDark, 2.0F},
                    Look{"running-small", sample_running, ThemeChoice::kDark, 1.0F, 1280, 800},
                    Look{"rejected-dark", sample_rejected},
                    Look{"rejected-light-200", sample_rejected, ThemeChoice::kLight, 2.0F},
                    Look{"rejected-small", sample_rejected, ThemeChoice::kDark, 1.0F, 1280, 800,
                         DockTab::kLog},
                    Look{"aligning-live", sample_aligning, ThemeChoice::kDark, 1.0F, 1600, 1000,
                         DockTab::kTable, MotionMode::kLive},
                    Look{"images-dark", sample_rejected, ThemeChoice::kDark, 1.0F, 1600, 1000,
                         DockTab::kImages},
                    Look{"link-lost-dark", sample_link_lost, ThemeChoice::kDark, 1.0F, 1600, 1000,
                         DockTab::kAttempts},
                    Look{"finished-light", sample_finished, ThemeChoice::kLight}),
    [](const auto& look) {
        std::string name = look.param.name;
        std::replace(name.begin(), name.end(), '-', '_');
        return name;
    });

}  // namespace
}  // namespace gripscan::test
