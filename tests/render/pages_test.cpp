// The pages beside the procedure and the dialogs, in their states, as they were looked at.
#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>

#include "tests/render/screen_picture.h"
#include "tests/support/egl_context.h"
#include "tests/support/sample_pages.h"
#include "ui/panels/start_page.h"

namespace gripscan::test {
namespace {

using ui::Rect;
using ui::Requests;
using ui::Snapshot;
using ui::Ui;

/// One look at one thing: size in px at 100 %.
struct Look {
    const char* name;
    int width;
    int height;
    float scale = 1.0F;
    ui::ThemeChoice theme = ui::ThemeChoice::kDark;
};

void expect_look(const Look& look, const std::function<void(const Ui&, const Rect&)>& draw) {
    ::setenv("TZ", "UTC", 1);  // times of day are shown
    ::tzset();
    const auto context = EglContext::make();
    ASSERT_NE(context, nullptr);
    const int width = static_cast<int>(look.scale * static_cast<float>(look.width));
    const int height = static_cast<int>(look.scale * static_cast<float>(look.height));
    const Picture picture =
        screen_picture(width, height, ui::Scale(look.scale), look.theme, [&](const Ui& ui) {
            draw(ui, {0, 0, width, height});
        });
    expect_golden(picture, look.name);
}

constexpr auto kLight = ui::ThemeChoice::kLight;

void start_page(const Look& look, const Snapshot& snapshot) {
    ui::StartPageState local;
    expect_look(look, [&](const Ui& ui, const Rect& rect) {
        Requests out;
        draw_start_page(ui, rect, snapshot, local, out);
    });
}

TEST(StartPageLook, WithRecentSessions) {
    Snapshot snapshot;
    snapshot.recent = sample_recent();
    start_page({"start-dark_100", 1600, 930}, snapshot);
    start_page({"start-light_100", 1600, 930, 1.0F, kLight}, snapshot);
    start_page({"start-small_100", 1280, 730}, snapshot);
    start_page({"start-dark_200", 640, 365, 2.0F}, snapshot);
}

TEST(StartPageLook, AtTheFirstStart) {
    start_page({"start-empty-dark_100", 1280, 730}, {});
    start_page({"start-empty-light_100", 1280, 730, 1.0F, kLight}, {});
}

}  // namespace
}  // namespace gripscan::test
