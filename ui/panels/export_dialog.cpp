#include "ui/panels/export_dialog.h"

#include <fmt/format.h>

#include <array>

#include "ui/panels/panel_parts.h"
#include "ui/views/path_listing.h"
#include "ui/views/template_view.h"
#include "ui/widgets/choice.h"
#include "ui/widgets/dialog_frame.h"
#include "ui/widgets/interact.h"
#include "ui/widgets/text_input.h"

namespace gripscan::ui {
namespace {

void begin(const Snapshot& snapshot, ExportDialogState& local) {
    local.wish.file = with_format(suggested_file(snapshot), format_of(local.wish.file));
    local.file = local.wish.file.string();
    if (!snapshot.solved || !snapshot.solved->report.axis) local.wish.axis_frame = false;
}

void draw_format(Form& form, ExportDialogState& local) {
    const std::array<Option, 3> formats{
        {{"export.pcd", "PCD"}, {"export.ply", "PLY"}, {"export.xyz", "XYZ"}}};
    const CloudFormat format = format_of(local.wish.file);
    if (const auto chosen =
            segments(form.ui, form.row("Format"), formats, static_cast<std::size_t>(format))) {
        local.wish.file = with_format(local.wish.file, static_cast<CloudFormat>(*chosen));
        local.file = local.wish.file.string();
    }
    const std::string_view xyz = format == CloudFormat::kXyz ? "An XYZ file is always text." : "";
    const std::string_view only_pcd = format == CloudFormat::kPcd ? ""
                                      : format == CloudFormat::kPly
                                          ? "Only a PCD can be compressed."
                                          : xyz;
    const std::array<Option, 3> encodings{
        {{"export.ascii", "ascii"},
         {"export.binary", "binary", Icon::kNone, {}, xyz},
         {"export.compressed", "compressed", Icon::kNone, {}, only_pcd}}};
    if (format == CloudFormat::kXyz) local.wish.encoding = PcdEncoding::kAscii;
    if (format == CloudFormat::kPly && local.wish.encoding == PcdEncoding::kCompressed) {
        local.wish.encoding = PcdEncoding::kBinary;
    }
    if (const auto chosen = segments(form.ui, form.row("Encoding"), encodings,
                                     static_cast<std::size_t>(local.wish.encoding))) {
        local.wish.encoding = static_cast<PcdEncoding>(*chosen);
    }
}

void draw_unit_and_frame(Form& form, const Snapshot& snapshot, ExportDialogState& local) {
    const Ui& ui = form.ui;
    const Rect unit = form.row("Unit");
    const std::array<Option, 2> units{{{"export.m", "m"}, {"export.mm", "mm"}}};
    const Rect first{unit.x, unit.y, ui.em(8.0F), unit.height};
    if (const auto chosen = segments(ui, first, units, local.wish.millimetres ? 1 : 0)) {
        local.wish.millimetres = *chosen == 1;
    }
    draw_text(ui, static_cast<float>(first.right()) + ui.scale.em(0.71F), middle_of(unit),
              FontRole::kSmall, ui.theme.text_third, "of coordinates and deviations");
    const bool axis = snapshot.solved && snapshot.solved->report.axis;
    const std::array<Option, 2> frames{{{"export.camera", "camera, first view"},
                                        {"export.axis",
                                         "z along joint 6",
                                         Icon::kNone,
                                         {},
                                         axis ? "" : "The axis of joint 6 is not known."}}};
    if (const auto chosen =
            segments(ui, form.row("Frame"), frames, local.wish.axis_frame ? 1 : 0)) {
        local.wish.axis_frame = *chosen == 1;
    }
}

struct Field {
    std::string_view id;
    std::string_view label;
    bool ExportWish::*on;
    bool known;
};

void draw_fields(Form& form, const Snapshot& snapshot, ExportDialogState& local) {
    const Cloud none;
    const Cloud& cloud = snapshot.shown_template ? *snapshot.shown_template->kept : none;
    const std::array<Field, 4> fields{
        {{"export.normals", "normals", &ExportWish::normals, cloud.has_normals()},
         {"export.intensity", "intensity", &ExportWish::intensity, !cloud.intensity.empty()},
         {"export.seen", "seen count", &ExportWish::seen, !cloud.seen.empty()},
         {"export.sigma", "standard deviation", &ExportWish::sigma, !cloud.sigma.empty()}}};
    const Rect area = form.row("Fields", 3.3F);
    const int width = area.width / 2;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const Field& field = fields[i];
        const Rect at{area.x + static_cast<int>(i % 2) * width,
                      area.y + static_cast<int>(i / 2) * form.ui.em(1.64F), width,
                      form.ui.em(1.64F)};
        bool& on = local.wish.*field.on;
        if (check_box(form.ui, at, field.id, field.label, on && field.known,
                      field.known ? "" : "The template does not know it.")) {
            on = !on;
        }
    }
}

void draw_summary(Form& form, const Snapshot& snapshot, const ExportDialogState& local) {
    const Ui& ui = form.ui;
    const Rect box{form.body.x, form.y, form.body.width, ui.em(5.4F)};
    fill(box, ui.theme.raised, ui.scale.em(0.36F));
    const std::size_t points = snapshot.shown_template ? snapshot.shown_template->counts.kept : 0;
    const Cloud none;
    const Cloud& cloud = snapshot.shown_template ? *snapshot.shown_template->kept : none;
    const double megabytes =
        static_cast<double>(export_bytes(points, cloud, local.wish)) / (1024.0 * 1024.0);
    const float left = static_cast<float>(box.x) + ui.scale.em(0.86F);
    const float value = left + ui.scale.em(6.5F) - ui.scale.em(0.86F);
    const float right = static_cast<float>(box.right()) - ui.scale.em(0.86F);
    float y = static_cast<float>(box.y) + ui.scale.em(1.1F);
    const auto row = [&](std::string_view label, FontRole role, const std::string& text) {
        draw_text(ui, left, y, FontRole::kTable, ui.theme.text_second, label);
        draw_text(ui, value, y, role, ui.theme.text, fitted(ui, role, text, right - value));
        y += ui.scale.em(1.6F);
    };
    const std::string size = megabytes < 0.1
                                 ? fmt::format("about {:.0f} KB", std::max(1.0, 1024 * megabytes))
                                 : fmt::format("about {:.1f} MB", megabytes);
    draw_text(ui, right, y, FontRole::kNumberTable, ui.theme.text, size, Align::kRight);
    row("Will write", FontRole::kNumberTable,
        shown_count(static_cast<long long>(points)) + " points");
    row("Then", FontRole::kTable, "read back and compared; a sidecar beside it");
    row("Last export", FontRole::kTable,
        snapshot.last_export.empty()
            ? "none yet"
            : fitted_middle(ui, FontRole::kTable, snapshot.last_export, right - value));
    form.y = box.bottom();
}

}  // namespace

void draw_export_dialog(const Ui& ui, const Rect& beside, const Snapshot& snapshot,
                        ExportDialogState& local, Requests& out) {
    DialogFrame frame(ui, beside,
                      {.id = "dialog.export",
                       .title = "Export template",
                       .body_height = ui.em(27.6F),
                       .modal = false});
    if (frame.appeared()) begin(snapshot, local);
    Form form(ui, frame.body());
    draw_format(form, local);
    draw_unit_and_frame(form, snapshot, local);
    draw_fields(form, snapshot, local);
    const std::string problem = export_problem(snapshot, local.wish);
    const TextEvent typed = text_input(ui, form.row("File"),
                                       {.id = "export.file",
                                        .label = "File",
                                        .placeholder = "template.pcd",
                                        .icon = Icon::kFolder,
                                        .numbers = true,
                                        .wrong = !problem.empty()},
                                       local.file);
    if (typed.changed) local.wish.file = expanded(local.file);
    form.y -= ui.em(0.36F);
    if (problem.empty()) {
        // The field shows where a long path begins; what the file is called stands at its end.
        form.words("Nothing is overwritten:", ui.theme.text_third, true);
        const int left = form.body.x + ui.em(form.label_em);
        draw_text(ui, static_cast<float>(left), static_cast<float>(form.y) + ui.scale.em(0.64F),
                  FontRole::kNumberSmall, ui.theme.text_second,
                  fitted_middle(ui, FontRole::kNumberSmall, local.wish.file.string(),
                                static_cast<float>(form.body.right() - left)));
        form.y += ui.em(1.29F);
    } else {
        form.words(problem, ui.theme.reject, true);
    }
    form.gap(0.57F);
    draw_summary(form, snapshot, local);
    frame.end_body(form.y);

    const std::array<ButtonSpec, 2> buttons{{{.id = "export.cancel", .label = "Cancel"},
                                             {.id = "export.write",
                                              .label = "Export",
                                              .icon = Icon::kExport,
                                              .key = "Enter",
                                              .look = ButtonLook::kNext,
                                              .why_disabled = problem}}};
    const auto pressed = dialog_buttons(ui, frame, buttons);
    const bool write = pressed == 1U || (typed.entered && problem.empty());
    frame.end();
    if (write) {
        local.wish.filter = snapshot.filter;
        out.push_back(request::Export{local.wish});
    }
    if (write || pressed == 0U || frame.closed()) out.push_back(request::Show{Dialog::kNone});
}

}  // namespace gripscan::ui
