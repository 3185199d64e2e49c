// The pages beside the procedure and the dialogs, in their states, as they were looked at.
#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>

#include "core/base/units.h"
#include "tests/render/screen_picture.h"
#include "tests/support/egl_context.h"
#include "tests/support/sample_pages.h"
#include "tests/support/temporary_folder.h"
#include "ui/panels/cell_page.h"
#include "ui/panels/close_dialog.h"
#include "ui/panels/error_dialog.h"
#include "ui/panels/export_dialog.h"
#include "ui/panels/keys_overlay.h"
#include "ui/panels/new_session_dialog.h"
#include "ui/panels/note_dialog.h"
#include "ui/panels/open_dialog.h"
#include "ui/panels/recognise_page.h"
#include "ui/panels/settings_dialog.h"
#include "ui/panels/start_page.h"
#include "ui/panels/template_page.h"
#include "ui/widgets/draw.h"

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

void template_column(const Look& look, const Snapshot& snapshot) {
    ui::TemplatePageState local;
    expect_look(look, [&](const Ui& ui, const Rect& rect) {
        Requests out;
        draw_template_column(ui, rect, snapshot, local, out);
    });
}

TEST(TemplateColumnLook, InItsStates) {
    const Snapshot full = sample_template_page();
    template_column({"template-dark_100", 380, 876}, full);
    template_column({"template-light_200", 380, 876, 2.0F, kLight}, full);
    template_column({"template-empty-dark_100", 380, 730}, {});
}

void cell_page(const Look& look, SampleCell outcome) {
    const ProcedureState state = sample_cell_state(outcome);
    Snapshot snapshot;
    snapshot.page = ui::Page::kCell;
    snapshot.procedure = &state;
    snapshot.cell = sample_cell_frame();
    ui::CellPageState local;
    expect_look(look, [&](const Ui& ui, const Rect& rect) {
        Requests out;
        draw_cell_page(ui, rect, snapshot, local, out);
    });
}

TEST(CellPageLook, InItsStates) {
    cell_page({"cell-passed-dark_100", 1280, 730}, SampleCell::kPassed);
    cell_page({"cell-failed-light_100", 1280, 730, 1.0F, kLight}, SampleCell::kFailed);
    cell_page({"cell-failed-dark_200", 800, 500, 2.0F}, SampleCell::kFailed);
    cell_page({"cell-empty-dark_100", 1280, 730}, SampleCell::kNotChecked);
}

/// A dialog over an empty page.
template <typename Draw>
void dialog(const Look& look, const Draw& draw) {
    expect_look(look, [&](const Ui& ui, const Rect& rect) {
        fill(rect, ui.theme.bg0);
        Requests out;
        draw(ui, rect, out);
    });
}

constexpr Look small(const char* name, ui::ThemeChoice theme = ui::ThemeChoice::kDark) {
    return {name, 640, 400, 2.0F, theme};  // 200 % on 1280 x 800
}

TEST(ExportDialogLook, DarkAndLight) {
    const Snapshot snapshot = sample_template_page();
    ui::ExportDialogState local;
    const auto draw = [&](const Ui& ui, const Rect& rect, Requests& out) {
        draw_export_dialog(ui, rect, snapshot, local, out);
    };
    dialog({"export-dark_100", 560, 620}, draw);
    dialog({"export-light_100", 560, 620, 1.0F, kLight}, draw);
    dialog(small("export-dark_200"), draw);
}

TEST(NewSessionDialogLook, SimulatedAndLive) {
    ui::NewSessionState local;
    local.typed.wish.faults = {"slip", "glare"};
    const auto draw = [&](const Ui& ui, const Rect& rect, Requests& out) {
        draw_new_session_dialog(ui, rect, {}, local, out);
    };
    dialog({"new-sim-dark_100", 640, 520}, draw);
    dialog(small("new-sim-dark_200"), draw);
    local.typed.simulated = false;
    local.typed.wish.live = true;
    local.typed.cell_file = "~/cells/cell-3.yaml";
    dialog({"new-live-light_100", 640, 520, 1.0F, kLight}, draw);
}

TEST(OpenDialogLook, WithAFolderOfSessions) {
    const std::filesystem::path folder = "golden-open";
    for (const char* name : {"monday", "tuesday"}) {
        write_text(folder / name / "session.yaml", "format: gripscan-session/1\n");
    }
    std::filesystem::create_directories(folder / "older");
    write_text(folder / "gripper.pcd", "");
    ui::OpenDialogState local;
    local.path = (folder / "").string();
    const auto draw = [&](const Ui& ui, const Rect& rect, Requests& out) {
        draw_open_dialog(ui, rect, {}, local, out);
    };
    dialog({"open-dark_100", 700, 480}, draw);
    dialog(small("open-light_200", kLight), draw);
    std::filesystem::remove_all(folder);
}

TEST(SmallDialogsLook, NoteErrorAndClose) {
    const ProcedureState state = sample_cell_state(SampleCell::kFailed);
    Snapshot snapshot;
    snapshot.procedure = &state;
    ui::NoteDialogState note;
    dialog({"note-dark_100", 560, 330}, [&](const Ui& ui, const Rect& rect, Requests& out) {
        draw_note_dialog(ui, rect, snapshot, note, out);
    });
    snapshot.error = ui::ShownError{
        "The link to the robot is lost",
        "192.168.0.20:18740 did not answer for 2 s while joint 6 was turning to 140.0 deg. Whether "
        "it still turns is not known.",
        "Look whether the arm stands still. Check cable and controller, then connect again: the "
        "joint is read before anything else is asked.",
        "Connect again",
        {ui::request::Give{command::Connect{}}}};
    ui::ErrorDialogState error;
    const auto draw_error = [&](const Ui& ui, const Rect& rect, Requests& out) {
        draw_error_dialog(ui, rect, snapshot, error, out);
    };
    dialog({"error-dark_100", 560, 330}, draw_error);
    dialog(small("error-light_200", kLight), draw_error);
    snapshot.job = ui::ShownJob{"Joint refinement"};
    ui::CloseDialogState close;
    dialog({"close-light_100", 560, 300, 1.0F, kLight},
           [&](const Ui& ui, const Rect& rect, Requests& out) {
               draw_close_dialog(ui, rect, snapshot, close, out);
           });
}

TEST(SettingsLook, LooksAndKeys) {
    Snapshot snapshot;
    snapshot.keys = sample_keys();
    snapshot.keys[2].key = std::string("T");
    ui::SettingsState local;
    const auto draw = [&](const Ui& ui, const Rect& rect, Requests& out) {
        draw_settings_dialog(ui, rect, snapshot, local, out);
    };
    dialog({"settings-dark_100", 640, 460}, draw);
    dialog(small("settings-light_200", kLight), draw);
    local.tab = 1;
    dialog({"settings-keys-dark_100", 640, 460}, draw);
    ui::KeysOverlayState overlay;
    dialog({"keys-dark_100", 740, 540}, [&](const Ui& ui, const Rect& rect, Requests& out) {
        draw_keys_overlay(ui, rect, snapshot, overlay, out);
    });
}

void recognise_page(const Look& look, const Snapshot& snapshot) {
    ui::RecognisePageState local;
    expect_look(look, [&](const Ui& ui, const Rect& rect) {
        Requests out;
        const auto places = ui::recognise_page_layout(rect, {}, ui.scale);
        ui::fill(places.view, ui.theme.view_bottom);
        draw_recognise_page(ui, places, snapshot, nullptr, local, out);
    });
}

TEST(RecognisePageLook, WithGripperAndObject) {
    recognise_page({"recognise-dark_100", 1600, 880}, sample_recognised());
    recognise_page({"recognise-light_100", 1280, 730, 1.0F, kLight}, sample_recognised());
}

TEST(RecognisePageLook, BeforeTheFirstView) {
    Snapshot snapshot = sample_recognised();
    snapshot.recognition.reset();
    recognise_page({"recognise-empty-dark_100", 1280, 730}, snapshot);
}

TEST(RecognisePageLook, WithSomethingInTheWay) {
    Snapshot snapshot = sample_recognised();
    auto shown = std::make_shared<ui::ShownRecognition>(*snapshot.recognition);
    shown->strangers = {"something is in the way: 150 x 26 x 11 mm at x 12, y 83, z 640 mm"};
    shown->found.pop_back();
    snapshot.recognition = shown;
    recognise_page({"recognise-strange-dark_200", 800, 500, 2.0F}, snapshot);
}

}  // namespace
}  // namespace gripscan::test
