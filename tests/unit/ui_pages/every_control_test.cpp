// Every control of every page and dialog, in every state, pressed once: what it asks for, or why it
// cannot be pressed, compared with the approved texts in controls/.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <cstdlib>
#include <set>

#include "core/base/atomic_file.h"
#include "tests/support/replaced.h"
#include "tests/support/request_text.h"
#include "tests/support/sample_pages.h"
#include "tests/support/sample_snapshot.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/ui_driver.h"
#include "ui/panels/screen.h"

namespace gripscan::ui {
namespace {

namespace fs = std::filesystem;
using test::Sample;
using test::SampleCell;

constexpr int kWidth = 1600;
constexpr int kHeight = 1000;

/// The whole window but for what needs OpenGL.
class Window {
  public:
    Window(const Snapshot& snapshot, const ScreenState& start)
        : snapshot_(snapshot), start_(start) {
        begin_anew();
    }

    /// As it was before anything was pressed.
    void begin_anew() {
        if (GImGui->OpenPopupStack.Size > 0) ImGui::ClosePopupToLevel(0, false);
        ImGui::ClearActiveID();
        ImGui::FocusWindow(nullptr);
        driver_.mouse(-1.0F, -1.0F);
        state_ = start_;
        for (int i = 0; i < 3; ++i) driver_.frame();  // what is opened takes the keyboard after two
        out_.clear();
    }
    [[nodiscard]] std::vector<WidgetRecord> records() const { return driver_.log().records(); }

    struct Answer {
        bool shown = false;
        std::vector<std::string> asks;
        std::vector<std::string> opens;  ///< controls that were not there before
    };
    Answer press(const std::string& id, ImGuiMouseButton which) {
        begin_anew();
        const std::set<std::string> before = ids();
        Answer answer;
        answer.shown = driver_.click(id, which);
        driver_.frame();
        driver_.frame();
        for (const Request& r : out_) answer.asks.push_back(test::request_text(r));
        for (const std::string& now : ids()) {
            if (!before.contains(now)) answer.opens.push_back(now);
        }
        return answer;
    }

  private:
    [[nodiscard]] std::set<std::string> ids() const {
        std::set<std::string> all;
        for (const WidgetRecord& r : driver_.log().records()) all.insert(r.id);
        return all;
    }

    const Snapshot& snapshot_;
    ScreenState start_;
    ScreenState state_ = start_;
    ScreenParts parts_;
    Requests out_;
    test::UiDriver driver_{kWidth, kHeight, [this](const Ui& ui) {
                               draw_screen(ui, kWidth, kHeight, snapshot_, {}, 0.0, state_, parts_,
                                           out_);
                           }};
};

std::string joined(const std::vector<std::string>& words) {
    return fmt::format("{}", fmt::join(words, ", "));
}

void add_line(const std::string& name, const Window::Answer& answer, std::string& text) {
    text += name;
    if (!answer.asks.empty()) text += " -> " + joined(answer.asks);
    if (!answer.opens.empty()) text += " shows " + joined(answer.opens);
    text += '\n';
}

/// What stands behind a dialog, which takes its mouse.
std::set<std::string> behind_the_dialog(Snapshot snapshot, const ScreenState& start) {
    std::set<std::string> ids;
    if (snapshot.dialog == Dialog::kNone) return ids;
    snapshot.dialog = Dialog::kNone;
    const Window window(snapshot, start);
    for (const WidgetRecord& r : window.records()) ids.insert(r.id);
    return ids;
}

/// One line a control, in the order in which they are drawn.
std::string pressed_one_by_one(const Snapshot& snapshot, const ScreenState& start) {
    const std::set<std::string> behind = behind_the_dialog(snapshot, start);
    Window window(snapshot, start);
    std::string text;
    std::set<std::string> done;
    for (const WidgetRecord& r : window.records()) {
        if (behind.contains(r.id)) continue;
        if (!done.insert(r.id).second) {
            ADD_FAILURE() << r.id << " is the name of two controls";
            continue;
        }
        if (r.rect.empty()) continue;  // words that are told to whoever reads the list
        const Window::Answer left = window.press(r.id, ImGuiMouseButton_Left);
        EXPECT_TRUE(left.shown) << r.id << " has gone";
        if (!r.enabled) {
            EXPECT_TRUE(left.asks.empty()) << r.id << " is grey and asks for " << joined(left.asks);
            EXPECT_FALSE(r.reason.empty()) << r.id << " is grey and does not say why";
            text += fmt::format("{} is grey: {}\n", r.id, r.reason);
            continue;
        }
        add_line(r.id, left, text);
        const Window::Answer right = window.press(r.id, ImGuiMouseButton_Right);
        if (!right.asks.empty() || !right.opens.empty()) add_line("  right button", right, text);
    }
    return text;
}

void expect_approved(const std::string& name, const std::string& text) {
    const fs::path file =
        fs::path(GRIPSCAN_SOURCE_DIR) / "tests/unit/ui_pages/controls" / (name + ".txt");
    if (const char* update = std::getenv("GRIPSCAN_UPDATE_GOLDEN"); update && *update == '1') {
        fs::create_directories(file.parent_path());
        ASSERT_TRUE(write_file_atomically(file, text));
        GTEST_SKIP() << "wrote " << file << ": read it";
    }
    const auto approved = read_whole_file(file);
    ASSERT_TRUE(approved) << file << " is missing; GRIPSCAN_UPDATE_GOLDEN=1 writes it";
    EXPECT_EQ(text, *approved) << name;
}

void expect_controls(const std::string& name, const Snapshot& snapshot,
                     const ScreenState& start = {}) {
    expect_approved(name, pressed_one_by_one(snapshot, start));
}

TEST(EveryControl, StartPageEmpty) {
    expect_controls("start-empty", {});
}

TEST(EveryControl, StartPageRecent) {
    Snapshot snapshot;
    snapshot.recent = test::sample_recent();
    expect_controls("start-recent", snapshot);
}

struct Turn {
    const char* name;
    Sample (*make)();
};

class EveryControlOfATurn : public testing::TestWithParam<Turn> {};

TEST_P(EveryControlOfATurn, AsksForWhatWasApproved) {
    Sample sample = GetParam().make();
    sample.snapshot.page = Page::kProcedure;
    expect_controls(fmt::format("procedure-{}", GetParam().name), sample.snapshot);
}

Sample live() {
    Sample sample = test::sample_running();
    test::set_mode(sample, MotionMode::kLive);
    return sample;
}

Sample by_hand() {
    Sample sample = test::sample_cell_checked();
    test::set_mode(sample, MotionMode::kManual);
    return sample;
}

INSTANTIATE_TEST_SUITE_P(States, EveryControlOfATurn,
                         testing::Values(Turn{"empty", test::sample_empty},
                                         Turn{"checked", test::sample_cell_checked},
                                         Turn{"running", test::sample_running},
                                         Turn{"rejected", test::sample_rejected},
                                         Turn{"finished", test::sample_finished},
                                         Turn{"link_lost", test::sample_link_lost},
                                         Turn{"aligning", test::sample_aligning},
                                         Turn{"live", live}, Turn{"by_hand", by_hand}),
                         [](const auto& turn) { return std::string(turn.param.name); });

TEST(EveryControl, TemplatePageEmpty) {
    Sample sample = test::sample_running();
    sample.snapshot.page = Page::kTemplate;
    expect_controls("template-empty", sample.snapshot);
}

TEST(EveryControl, TemplatePageAndItsExport) {
    Snapshot snapshot = test::sample_template_page();
    expect_controls("template", snapshot);
}

TEST(EveryControl, ExportDialog) {
    Snapshot snapshot = test::sample_template_page();
    snapshot.dialog = Dialog::kExport;
    expect_controls("export", snapshot);
}

TEST(EveryControl, RecognisePageEmpty) {
    Snapshot snapshot = test::sample_recognised();
    snapshot.recognition.reset();
    snapshot.library.clear();
    expect_controls("recognise-empty", snapshot);
}

TEST(EveryControl, RecognisePageWithWhatWasFound) {
    expect_controls("recognise", test::sample_recognised());
}

void expect_cell_page(const std::string& name, SampleCell outcome) {
    const ProcedureState state = test::sample_cell_state(outcome);
    Snapshot snapshot;
    snapshot.page = Page::kCell;
    snapshot.session = SessionFacts{"/data/valve-T20", "valve-T20", "simulated cell", false, {}};
    snapshot.procedure = &state;
    snapshot.cell = test::sample_cell_frame();
    expect_controls(name, snapshot);
}

TEST(EveryControl, CellPageBeforeTheCheck) {
    expect_cell_page("cell-empty", SampleCell::kNotChecked);
}
TEST(EveryControl, CellPagePassed) {
    expect_cell_page("cell-passed", SampleCell::kPassed);
}
TEST(EveryControl, CellPageFailed) {
    expect_cell_page("cell-failed", SampleCell::kFailed);
}

/// The dialog over the page of a running turn.
void expect_dialog(const std::string& name, Dialog dialog, const ScreenState& start = {}) {
    Sample sample = test::sample_running();
    sample.snapshot.page = Page::kProcedure;
    sample.snapshot.dialog = dialog;
    sample.snapshot.keys = test::sample_keys();
    sample.snapshot.error = ShownError{
        "Lost", "No answer.", "Look.", "Connect again", {request::Give{command::Connect{}}}};
    expect_controls(name, sample.snapshot, start);
}

TEST(EveryControl, NewSessionInTheSimulation) {
    expect_dialog("new-sim", Dialog::kNewSession);
}

TEST(EveryControl, NewSessionOfACellFile) {
    ScreenState start;
    start.new_session.typed.simulated = false;
    start.new_session.typed.cell_file = "/cells/none.yaml";
    expect_dialog("new-cell", Dialog::kNewSession, start);
}

TEST(EveryControl, NoteDialog) {
    expect_dialog("note", Dialog::kNote);
}

TEST(EveryControl, Settings) {
    expect_dialog("settings", Dialog::kSettings);
}

TEST(EveryControl, SettingsOfKeys) {
    ScreenState start;
    start.settings.tab = 1;
    expect_dialog("settings-keys", Dialog::kSettings, start);
}

TEST(EveryControl, KeysOverlay) {
    expect_dialog("keys", Dialog::kKeys);
}

TEST(EveryControl, ErrorDialog) {
    expect_dialog("error", Dialog::kError);
}

TEST(EveryControl, CloseDialog) {
    expect_dialog("close", Dialog::kClose);
}

TEST(EveryControl, OpenDialog) {
    const test::TemporaryFolder folder;
    test::write_text(folder / "monday/session.yaml", "x");
    test::write_text(folder / "part.pcd", "x");
    Snapshot snapshot;
    snapshot.dialog = Dialog::kOpen;
    ScreenState start;
    start.open.path = folder.path().string() + "/";
    const std::string text = pressed_one_by_one(snapshot, start);
    expect_approved("open", test::replaced(text, folder.path().string(), "FOLDER"));
}

}  // namespace
}  // namespace gripscan::ui
