#include "ui/panels/screen.h"

#include "ui/panels/history_panel.h"
#include "ui/panels/keyboard.h"
#include "ui/panels/stage_bar.h"
#include "ui/panels/status_bar.h"
#include "ui/panels/toasts.h"
#include "ui/panels/top_bar.h"
#include "ui/widgets/draw.h"
#include "ui/widgets/splitter.h"

namespace gripscan::ui {
namespace {

/// One frame of the window.
struct Screen {
    const Ui& ui;
    const Snapshot& snapshot;
    const WindowLayout& layout;
    double last_frame_ms;
    ScreenState& state;
    ScreenParts& parts;
    Requests& out;

    void view(const Rect& rect) const {
        if (!parts.view3d) return;
        parts.view3d->draw(ui, rect, snapshot, state.view3d, out, last_frame_ms);
    }

    void procedure() const {
        draw_stage_bar(ui, layout.stage_bar, snapshot, layout.detail, out);
        if (!layout.stereo.empty()) {
            draw_stereo_panel(ui, layout.stereo, snapshot, parts.stereo.get(), state.stereo, out);
        }
        view(layout.view3d);
        draw_step_card(ui, layout.step_card, snapshot, layout.detail, state.step_card, out);
        draw_table_dock(ui, layout.table, snapshot, layout.detail, state.dock, state.log,
                        parts.pictures.get(), out);
        if (!layout.history.empty()) {
            draw_history_panel(ui, layout.history, snapshot, layout.detail, state.log, out);
        }
        draw_toasts(ui, layout.view3d, snapshot, out);
    }

    /// Between stage bar and status bar.
    [[nodiscard]] Rect page() const {
        const int top = layout.stage_bar.bottom();
        return {0, top, layout.top_bar.width, layout.status_bar.y - top};
    }

    void template_page() const {
        draw_stage_bar(ui, layout.stage_bar, snapshot, layout.detail, out);
        const TemplatePageLayout places = template_page_layout(page(), ui.scale);
        view(places.view);
        draw_template_column(ui, places.column, snapshot, state.template_page, out);
        if (snapshot.dialog == Dialog::kExport) {
            draw_export_dialog(ui, places.view, snapshot, state.export_dialog, out);
        }
        draw_toasts(ui, places.view, snapshot, out);
    }

    void recognise_page() const {
        draw_stage_bar(ui, layout.stage_bar, snapshot, layout.detail, out);
        const RecognisePageLayout places = recognise_page_layout(page(), state.splits, ui.scale);
        view(places.view);
        draw_recognise_page(ui, places, snapshot, parts.recognised.get(), state.recognise, out);
        draw_toasts(ui, places.view, snapshot, out);
    }

    void cell_page() const {
        draw_stage_bar(ui, layout.stage_bar, snapshot, layout.detail, out);
        draw_cell_page(ui, page(), snapshot, state.cell, out);
        draw_toasts(ui, page(), snapshot, out);
    }

    void start_page() const {
        const int top = layout.top_bar.bottom();
        const Rect rect{0, top, layout.top_bar.width, layout.status_bar.y - top};
        draw_start_page(ui, rect, snapshot, state.start, out);
        draw_toasts(ui, rect, snapshot, out);
    }

    void dialog(const Rect& whole) const {
        switch (snapshot.dialog) {
            case Dialog::kNewSession:
                return draw_new_session_dialog(ui, whole, snapshot, state.new_session, out);
            case Dialog::kOpen:
                return draw_open_dialog(ui, whole, snapshot, state.open, out);
            case Dialog::kNote:
                return draw_note_dialog(ui, whole, snapshot, state.note, out);
            case Dialog::kSettings:
                return draw_settings_dialog(ui, whole, snapshot, state.settings, out);
            case Dialog::kKeys:
                return draw_keys_overlay(ui, whole, snapshot, state.keys, out);
            case Dialog::kError:
                return draw_error_dialog(ui, whole, snapshot, state.error, out);
            case Dialog::kClose:
                return draw_close_dialog(ui, whole, snapshot, state.close, out);
            case Dialog::kExport:  // beside the template, drawn with its page
            case Dialog::kNone:
                return;
        }
    }

    void splitters(int width_px, int height_px) const {
        const auto drag = [&](const Rect& rect, std::string_view id, SplitterWay way,
                              Splitter which) {
            if (rect.empty()) return;
            const SplitterEvent event = splitter(ui, rect, id, way);
            if (event.reset) state.splits = default_splits(width_px, height_px, ui.scale);
            if (event.moved_px == 0) return;
            state.splits =
                dragged(state.splits, which, event.moved_px, width_px, height_px, ui.scale);
        };
        drag(layout.splitter_stereo, "splitter.stereo", SplitterWay::kLeftRight, Splitter::kStereo);
        drag(layout.splitter_right, "splitter.right", SplitterWay::kLeftRight, Splitter::kRight);
        drag(layout.splitter_bottom, "splitter.bottom", SplitterWay::kUpDown, Splitter::kBottom);
    }
};

/// A line of a guided tour, over the bottom of the window.
void draw_caption(const Ui& ui, const WindowLayout& layout, std::string_view caption) {
    if (caption.empty()) return;
    const auto width = static_cast<int>(text_width(ui, FontRole::kVerdict, caption));
    const int height = ui.em(2.6F);
    const Rect plate{(layout.top_bar.width - width) / 2 - ui.em(1.2F),
                     layout.status_bar.y - height - ui.em(1.0F), width + 2 * ui.em(1.2F), height};
    fill(plate, ui.theme.accent, ui.scale.em(0.43F));
    draw_text(ui, static_cast<float>(plate.x + plate.width / 2),
              static_cast<float>(plate.y + plate.height / 2), FontRole::kVerdict,
              ui.theme.accent_on, caption, Align::kCentre);
}

}  // namespace

bool ScreenParts::wants_another_frame() const {
    return view3d != nullptr && !view3d->complete();
}

Result<ScreenParts> make_screen_parts() {
    auto view3d = View3d::make();
    if (!view3d) return forward_error(view3d.error());
    ScreenParts parts;
    parts.view3d = std::move(*view3d);
    parts.pictures = std::make_unique<PictureCache>();
    parts.stereo = std::make_unique<StereoTextures>();
    parts.recognised = std::make_unique<StereoTextures>();
    return parts;
}

void draw_screen(const Ui& ui, int width_px, int height_px, const Snapshot& snapshot,
                 std::string_view caption, double last_frame_ms, ScreenState& state,
                 ScreenParts& parts, Requests& out) {
    const WindowLayout layout = layout_window(width_px, height_px, state.splits, ui.scale);
    const Screen screen{ui, snapshot, layout, last_frame_ms, state, parts, out};
    const bool measuring = state.view3d.measuring.on;
    draw_top_bar(ui, layout.top_bar, snapshot, out);
    switch (snapshot.page) {
        case Page::kStart:
            screen.start_page();
            break;
        case Page::kProcedure:
            screen.procedure();
            screen.splitters(width_px, height_px);
            break;
        case Page::kTemplate:
            screen.template_page();
            break;
        case Page::kRecognise:
            screen.recognise_page();
            break;
        case Page::kCell:
            screen.cell_page();
            break;
    }
    draw_status_bar(ui, layout.status_bar, snapshot, layout.detail, state.view3d.cursor, out);
    take_keys(snapshot, measuring && !state.view3d.measuring.on, out);
    screen.dialog({0, 0, width_px, height_px});
    state.last_dialog = snapshot.dialog;
    draw_caption(ui, layout, caption);
}

}  // namespace gripscan::ui
