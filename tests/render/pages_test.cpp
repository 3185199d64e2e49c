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

Snapshot template_snapshot() {
    Snapshot snapshot;
    snapshot.page = ui::Page::kTemplate;
    ui::SessionFacts facts;
    facts.folder = "/sessions/valve-T20";
    facts.name = "valve-T20";
    snapshot.session = facts;
    snapshot.filter.crop = Box{{-0.05, -0.05, 0.55}, {0.05, 0.05, 0.65}};
    snapshot.filter.min_seen = 8;
    snapshot.filter.denoise_sigmas = 1.5;
    snapshot.shown_template = sample_template(snapshot.filter);
    auto solved = std::make_shared<ComputedTurn>();
    for (int i = 1; i <= 36; ++i) {
        TurnStep step;
        step.index = i;
        step.verdict = i == 11 ? Verdict::kCheck : Verdict::kAccept;
        solved->report.steps.push_back(step);
    }
    solved->report.closure_before = solved->report.closure_after =
        Closure{rad_from_deg(0.07), 0.24e-3};
    solved->report.axis = AxisEstimate{};
    snapshot.solved = solved;
    return snapshot;
}

void template_column(const Look& look, const Snapshot& snapshot) {
    ui::TemplatePageState local;
    expect_look(look, [&](const Ui& ui, const Rect& rect) {
        Requests out;
        draw_template_column(ui, rect, snapshot, local, out);
    });
}

TEST(TemplateColumnLook, InItsStates) {
    const Snapshot full = template_snapshot();
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
    const Snapshot snapshot = template_snapshot();
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

/// A gripper and an object found in one view.
Snapshot recognised_snapshot() {
    Snapshot snapshot;
    snapshot.page = ui::Page::kRecognise;
    snapshot.session =
        ui::SessionFacts{"/data/valve-T20", "valve-T20", "simulated cell", false, {}};
    static const ProcedureState kState = sample_cell_state(SampleCell::kPassed);
    snapshot.procedure = &kState;
    snapshot.cell = sample_cell_frame();
    snapshot.library = {
        {"gripper-G2", ui::TemplateKind::kGripper, 41180, "none", "", ""},
        {"valve-T18", ui::TemplateKind::kObject, 18210, "none", "held by gripper-G2",
         "valve-T18 was registered with another template of gripper-G2"},
        {"valve-T20", ui::TemplateKind::kObject, 21604, "2-fold", "held by gripper-G2", ""}};
    auto shown = std::make_shared<ui::ShownRecognition>();
    shown->view = 3;
    shown->seconds = 0.42;
    shown->looked_for = 3;
    shown->least_score = 0.45;
    shown->least_found = 0.25;
    const auto found = [&](const char* name, ui::TemplateKind kind, double x_m) {
        ui::FoundTemplate f;
        f.name = name;
        f.kind = kind;
        f.T_camera_template.linear() = rotation_from_euler({0.4, -0.2, 0.1});
        f.T_camera_template.translation() = Eigen::Vector3d(x_m, 0.01, 0.74);
        f.T_robot_template = turn_about(Axis{}, 1.2) * f.T_camera_template;
        f.T_gripper_template = turn_about(Axis{}, 0.2);
        f.score = 0.91;
        f.support = 0.97;
        f.found = 0.87;
        f.outline = 0.82;
        f.rms_m = 0.27e-3;
        f.tolerance_m = 1.0e-3;
        f.box = {{-0.03, -0.04, -0.03}, {0.03, 0.04, 0.03}};
        shown->found.push_back(f);
    };
    found("gripper-G2", ui::TemplateKind::kGripper, 0.09);
    found("valve-T20", ui::TemplateKind::kObject, 0.0);
    shown->found[1].symmetry = "2-fold";
    shown->joint6_robot_rad = rad_from_deg(60.004);
    shown->joint6_gripper_rad = rad_from_deg(60.020);
    shown->grasp = ui::ShownGrasp{"valve-T20", turn_about(Axis{}, 0.7), true,
                                  "The arm reaches it with J1 12.5°, J5 −62.0°."};
    auto picture = std::make_shared<ui::StereoPicture>();
    picture->left = cv::Mat(960, 1280, CV_8U);
    for (int y = 0; y < 960; ++y) {
        for (int x = 0; x < 1280; ++x) {
            picture->left.at<std::uint8_t>(y, x) =
                static_cast<std::uint8_t>(90 + (x * 7 + y * 13) % 40);
        }
    }
    picture->right = picture->left;
    shown->picture = std::move(picture);
    snapshot.recognition = std::move(shown);
    return snapshot;
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
    recognise_page({"recognise-dark_100", 1600, 880}, recognised_snapshot());
    recognise_page({"recognise-light_100", 1280, 730, 1.0F, kLight}, recognised_snapshot());
}

TEST(RecognisePageLook, BeforeTheFirstView) {
    Snapshot snapshot = recognised_snapshot();
    snapshot.recognition.reset();
    recognise_page({"recognise-empty-dark_100", 1280, 730}, snapshot);
}

TEST(RecognisePageLook, WithSomethingInTheWay) {
    Snapshot snapshot = recognised_snapshot();
    auto shown = std::make_shared<ui::ShownRecognition>(*snapshot.recognition);
    shown->strangers = {"something is in the way: 150 x 26 x 11 mm at x 12, y 83, z 640 mm"};
    shown->found.pop_back();
    snapshot.recognition = shown;
    recognise_page({"recognise-strange-dark_200", 800, 500, 2.0F}, snapshot);
}

}  // namespace
}  // namespace gripscan::test
