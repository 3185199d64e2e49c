// The whole window of a frame: bars, the page between them, the dialog in front. Puts panels into
// the rectangles of the layout and nothing else.
#pragma once

#include <memory>
#include <string_view>

#include "ui/layout/window_layout.h"
#include "ui/panels/cell_page.h"
#include "ui/panels/close_dialog.h"
#include "ui/panels/error_dialog.h"
#include "ui/panels/export_dialog.h"
#include "ui/panels/keys_overlay.h"
#include "ui/panels/log_list.h"
#include "ui/panels/new_session_dialog.h"
#include "ui/panels/note_dialog.h"
#include "ui/panels/open_dialog.h"
#include "ui/panels/picture_cache.h"
#include "ui/panels/recognise_page.h"
#include "ui/panels/settings_dialog.h"
#include "ui/panels/start_page.h"
#include "ui/panels/step_card.h"
#include "ui/panels/stereo_panel.h"
#include "ui/panels/table_dock.h"
#include "ui/panels/template_page.h"
#include "ui/panels/view3d_panel.h"

namespace gripscan::ui {

/// What the panels remember from frame to frame.
struct ScreenState {
    Splits splits;
    StartPageState start;
    StepCardState step_card;
    TableDockState dock;
    LogListState log;
    StereoPanelState stereo;
    View3dState view3d;
    TemplatePageState template_page;
    RecognisePageState recognise;
    CellPageState cell;
    NewSessionState new_session;
    OpenDialogState open;
    NoteDialogState note;
    ExportDialogState export_dialog;
    SettingsState settings;
    KeysOverlayState keys;
    ErrorDialogState error;
    CloseDialogState close;
    Dialog last_dialog = Dialog::kNone;
    bool quit = false;
};

/// What needs OpenGL; without it (tests of the layout) those panels stay empty.
struct ScreenParts {
    std::unique_ptr<View3d> view3d;
    std::unique_ptr<PictureCache> pictures;
    std::unique_ptr<StereoTextures> stereo;
    std::unique_ptr<StereoTextures> recognised;
    /// The picture is not complete yet.
    [[nodiscard]] bool wants_another_frame() const;
};
/// Needs a current OpenGL context.
[[nodiscard]] Result<ScreenParts> make_screen_parts();

/// `caption`: of a guided tour; empty: none. `last_frame_ms`: what the frame before took.
void draw_screen(const Ui& ui, int width_px, int height_px, const Snapshot& snapshot,
                 std::string_view caption, double last_frame_ms, ScreenState& state,
                 ScreenParts& parts, Requests& out);

}  // namespace gripscan::ui
