// Every page of the window in each of its states, dark and light, at 100 % in a window of the usual
// size and at 200 % in the smallest one: the four of a state side by side, made smaller. Layout,
// colours and what is shown; single pixels are looked at by the tests of the pages.
#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>
#include <opencv2/imgproc.hpp>

#include "tests/support/egl_context.h"
#include "tests/support/golden_image.h"
#include "tests/support/sample_pages.h"
#include "tests/support/sample_scene.h"
#include "tests/support/sample_snapshot.h"
#include "tests/support/ui_driver.h"
#include "ui/gl/render_target.h"
#include "ui/panels/screen.h"
#include "ui/shell/imgui_painter.h"

namespace gripscan::test {
namespace {

using namespace gripscan::ui;

struct Size {
    float scale;
    int width;
    int height;
};
constexpr Size kUsual{1.0F, 1600, 1000};
constexpr Size kSmallest{2.0F, 2048, 1280};
constexpr int kShownWidth = 576;  ///< of each
constexpr int kShownHeight = 360;
constexpr int kMostFrames = 60;  ///< a large cloud is drawn over several

/// The window as it is at rest.
cv::Mat window_picture(const Snapshot& snapshot, ThemeChoice theme, const Size& size) {
    const float scale = size.scale;
    const int width = size.width;
    const int height = size.height;
    ScreenState state;
    state.splits = default_splits(width, height, Scale(scale));
    Requests out;
    ScreenParts parts;
    UiDriver driver(
        width, height,
        [&](const Ui& ui) { draw_screen(ui, width, height, snapshot, {}, 0.0, state, parts, out); },
        Scale(scale), theme);
    auto made = make_screen_parts();
    auto painter = ImGuiPainter::make();
    auto target = RenderTarget::make(width, height, DepthTexture::kNone);
    if (!made || !painter || !target) {
        ADD_FAILURE() << "no picture without OpenGL";
        return {};
    }
    parts = *std::move(made);
    for (int i = 0; i < 3 || (parts.wants_another_frame() && i < kMostFrames); ++i) {
        (*painter)->begin_frame(driver.session().fonts_changed());
        driver.frame();
    }
    EXPECT_TRUE(out.empty()) << "panels ask for nothing by themselves";
    target->bind();
    (*painter)->paint();
    std::vector<std::uint8_t> rgba = target->read_rgba();
    return cv::Mat(height, width, CV_8UC4, rgba.data()).clone();
}

void expect_matrix(Snapshot snapshot, const std::string& name) {
    ::setenv("TZ", "UTC", 1);  // times of day are shown
    ::tzset();
    const auto context = EglContext::make();
    ASSERT_NE(context, nullptr);
    std::vector<cv::Mat> rows;
    for (const Size& size : {kUsual, kSmallest}) {
        std::vector<cv::Mat> row;
        for (const ThemeChoice theme : {ThemeChoice::kDark, ThemeChoice::kLight}) {
            snapshot.preferences.theme = theme;
            const cv::Mat whole = window_picture(snapshot, theme, size);
            ASSERT_FALSE(whole.empty());
            cv::Mat small;
            cv::resize(whole, small, {kShownWidth, kShownHeight}, 0, 0, cv::INTER_AREA);
            row.push_back(small);
        }
        rows.emplace_back();
        cv::hconcat(row, rows.back());
    }
    cv::Mat all;
    cv::vconcat(rows, all);
    expect_golden({all.cols, all.rows, {all.datastart, all.dataend}}, "window-" + name);
}

/// A turn's state with the cloud and the images of a part that was turned as far.
Snapshot with_scene(const Sample& sample, const SampleScene& scene) {
    Snapshot snapshot = sample.snapshot;
    snapshot.page = Page::kProcedure;
    snapshot.captures = scene.snapshot.captures;
    snapshot.cell = scene.snapshot.cell;
    snapshot.live = scene.snapshot.live;
    snapshot.keys = sample_keys();
    return snapshot;
}

TEST(WindowMatrix, StartPage) {
    expect_matrix({}, "start-empty");
    Snapshot recent;
    recent.recent = sample_recent();
    expect_matrix(recent, "start-recent");
}

TEST(WindowMatrix, ProcedureEmpty) {
    expect_matrix(with_scene(sample_empty(), empty_scene()), "procedure-empty");
}

TEST(WindowMatrix, ProcedureRunning) {
    const SampleScene scene = growing_scene(14);
    expect_matrix(with_scene(sample_running(), scene), "procedure-running");
    expect_matrix(with_scene(sample_aligning(), scene), "procedure-aligning");
}

TEST(WindowMatrix, ProcedureRejected) {
    const SampleScene scene = rejected_scene(6, 0.25);
    expect_matrix(with_scene(sample_rejected(), scene), "procedure-rejected");
}

TEST(WindowMatrix, ProcedureWithAnError) {
    const SampleScene scene = growing_scene(9);
    const Sample sample = sample_link_lost();
    Snapshot snapshot = with_scene(sample, scene);
    expect_matrix(snapshot, "procedure-interrupted");
    if (!snapshot.error) {
        snapshot.error = ShownError{"The robot does not answer",
                                    "192.168.0.10:18735 has been silent for 2.0 s.",
                                    "Check the cable and the pendant, then connect again.",
                                    "Connect again",
                                    {request::Give{command::Connect{}}}};
    }
    snapshot.dialog = Dialog::kError;
    expect_matrix(snapshot, "procedure-error");
}

TEST(WindowMatrix, TemplatePage) {
    const SampleScene scene = template_scene();
    const Snapshot full = sample_template_page();
    Snapshot snapshot = scene.snapshot;
    snapshot.page = Page::kTemplate;
    snapshot.session = full.session;
    snapshot.filter = full.filter;
    snapshot.shown_template = full.shown_template;
    expect_matrix(snapshot, "template");
    snapshot.dialog = Dialog::kExport;
    expect_matrix(snapshot, "template-export");
    const SampleScene nothing = empty_scene();
    Snapshot empty = nothing.snapshot;
    empty.page = Page::kTemplate;
    expect_matrix(empty, "template-empty");
}

TEST(WindowMatrix, RecognisePage) {
    Snapshot snapshot = sample_recognised();
    expect_matrix(snapshot, "recognise");
    snapshot.recognition.reset();
    snapshot.library.clear();
    expect_matrix(snapshot, "recognise-empty");
}

TEST(WindowMatrix, CellPage) {
    for (const auto& [outcome, name] : {std::pair{SampleCell::kNotChecked, "cell-empty"},
                                        {SampleCell::kPassed, "cell-passed"},
                                        {SampleCell::kFailed, "cell-failed"}}) {
        const ProcedureState state = sample_cell_state(outcome);
        Snapshot snapshot;
        snapshot.page = Page::kCell;
        snapshot.session =
            SessionFacts{"/data/valve-T20", "valve-T20", "simulated cell", false, {}};
        snapshot.procedure = &state;
        snapshot.cell = sample_cell_frame();
        expect_matrix(snapshot, name);
    }
}

}  // namespace
}  // namespace gripscan::test
