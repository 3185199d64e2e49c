#include "ui/panels/template_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/units.h"
#include "ui/panels/action_button.h"
#include "ui/panels/panel_parts.h"
#include "ui/theme/colour_map.h"
#include "ui/views/template_view.h"
#include "ui/widgets/button.h"
#include "ui/widgets/choice.h"
#include "ui/widgets/notices.h"
#include "ui/widgets/number_input.h"
#include "ui/widgets/rich_text.h"
#include "ui/widgets/scroll_area.h"
#include "ui/widgets/state_shape.h"

namespace gripscan::ui {
namespace {

constexpr double kFarthest_mm = 5000.0;

/// What every section needs, and where the next one begins.
struct Column {
    const Ui& ui;
    const Snapshot& snapshot;
    TemplatePageState& local;
    Requests& out;
    int x;
    int width;
    int y;

    [[nodiscard]] Rect row(float height_em) const { return {x, y, width, ui.em(height_em)}; }
    void separate() {
        y += ui.em(0.86F);
        draw_separator(ui, x - ui.em(1.0F), y, width + 2 * ui.em(1.0F));
        y += ui.em(0.71F);
    }
    void wish(const TemplateFilter& filter) { out.push_back(request::SetFilter{filter}); }
    [[nodiscard]] std::string_view why_disabled() const {
        return snapshot.shown_template ? "" : "There is no template yet.";
    }
};

State state_of(Verdict verdict) {
    return verdict == Verdict::kReject  ? State::kReject
           : verdict == Verdict::kCheck ? State::kCheck
                                        : State::kAccept;
}

void draw_count(const Column& c, const Rect& row, std::string_view label, std::size_t count,
                Align align, std::string_view note = {}) {
    const Ui& ui = c.ui;
    const float y = middle_of(row);
    const std::string number = shown_count(static_cast<long long>(count));
    const float gap = ui.scale.em(0.43F);
    if (align == Align::kLeft) {
        float x = draw_text(ui, static_cast<float>(row.x), y, FontRole::kTable,
                            ui.theme.text_second, label);
        x = draw_text(ui, x + gap, y, FontRole::kNumberTable, ui.theme.text, number);
        draw_text(ui, x + gap, y, FontRole::kNumberTable, ui.theme.text_third, note);
    } else {
        const auto right = static_cast<float>(row.right());
        const float width = text_width(ui, FontRole::kNumberTable, number);
        draw_text(ui, right, y, FontRole::kNumberTable, ui.theme.text, number, Align::kRight);
        draw_text(ui, right - width - gap, y, FontRole::kTable, ui.theme.text_second, label,
                  Align::kRight);
    }
}

void draw_head(Column& c) {
    const Ui& ui = c.ui;
    const Rect head = c.row(2.0F);
    const std::string name = c.snapshot.session ? c.snapshot.session->name : "Template";
    const auto trust = trust_text(c.snapshot);
    float right = static_cast<float>(head.right());
    if (trust) {
        const State state = state_of(trust->verdict);
        const float words = text_width(ui, FontRole::kTextStrong, trust->word);
        draw_text(ui, right, middle_of(head), FontRole::kTextStrong, colour_of(ui.theme, state),
                  trust->word, Align::kRight);
        right -= words + ui.scale.em(0.93F);
        draw_state(ui, right, middle_of(head), state, 1.0F, ui.theme.panel);
    }
    draw_text(ui, static_cast<float>(c.x), middle_of(head), FontRole::kTitle, ui.theme.text,
              fitted(ui, FontRole::kTitle, name, right - static_cast<float>(c.x) - ui.scale.em(1)));
    c.y += head.height;
    const TextStyle small{FontRole::kTable, FontRole::kNumberTable, 1.5F};
    c.y +=
        draw_rich_text(ui, c.x, c.y, c.width, ui.theme.text_second,
                       trust ? trust->sentence : "Not solved yet: finish the turn first.", small);
}

void draw_axis_inputs(Column& c, const Box& box, int axis, int label_width) {
    const Ui& ui = c.ui;
    static constexpr std::array<std::array<std::string_view, 3>, 3> kIds{
        {{"crop.x.from", "crop.x.to", "crop.x.size"},
         {"crop.y.from", "crop.y.to", "crop.y.size"},
         {"crop.z.from", "crop.z.to", "crop.z.size"}}};
    static constexpr std::array<std::string_view, 3> kNames{"x", "y", "z"};
    const std::array<Colour, 3> colours{ui.theme.axis_x, ui.theme.axis_y, ui.theme.axis_z};
    const auto k = static_cast<std::size_t>(axis);
    const Rect row = c.row(1.86F);
    draw_text(ui, static_cast<float>(row.x), middle_of(row), FontRole::kNumberTable, colours[k],
              kNames[k]);
    const int gap = ui.em(0.5F);
    const int field = (row.width - label_width - 2 * gap) / 3;
    const std::array<double, 3> values_mm{box.min_m[axis] * kMmPerM, box.max_m[axis] * kMmPerM,
                                          (box.max_m[axis] - box.min_m[axis]) * kMmPerM};
    for (std::size_t i = 0; i < 3; ++i) {
        const Rect at{row.x + label_width + static_cast<int>(i) * (field + gap), row.y, field,
                      row.height};
        const auto event = number_input(ui, at,
                                        {.id = kIds[k][i],
                                         .label = i == 2   ? "Size"
                                                  : i == 1 ? "To"
                                                           : "From",
                                         .value = values_mm[i],
                                         .unit = "mm",
                                         .decimals = 1,
                                         .min = i == 2 ? 0.1 : -kFarthest_mm,
                                         .max = kFarthest_mm,
                                         .why_disabled = c.why_disabled()});
        if (event.committed) {
            c.wish(with_crop_side(c.snapshot, axis, static_cast<CropSide>(i), *event.committed));
        }
    }
    c.y += row.height + ui.em(0.36F);
}

void draw_crop_buttons(Column& c) {
    const Ui& ui = c.ui;
    const int gap = ui.em(0.5F);
    const int width = (c.width - gap) / 2;
    const Rect fit{c.x, c.y, width, ui.row(2.0F)};
    const std::string why = why_no_fit(c.snapshot);
    if (button(ui, fit,
               {.id = "crop.fit",
                .label = "Fit to points",
                .icon = Icon::kFit,
                .why_disabled = why,
                .tooltip = "Draws the cuboid in to the points that are kept"})) {
        c.wish(fitted_crop(c.snapshot));
    }
    TemplateFilter inverted = c.snapshot.filter;
    inverted.invert_crop = !inverted.invert_crop;
    const std::string_view no_crop = !c.snapshot.shown_template ? c.why_disabled()
                                     : c.snapshot.filter.crop
                                         ? ""
                                         : "There is no cuboid yet: type one, or fit it.";
    if (button(ui, {fit.right() + gap, fit.y, width, fit.height},
               {.id = "crop.invert",
                .label = inverted.invert_crop ? "Invert" : "Inverted",
                .icon = Icon::kCompare,
                .look = inverted.invert_crop ? ButtonLook::kNormal : ButtonLook::kSecond,
                .why_disabled = no_crop,
                .tooltip = "Keeps what lies outside the cuboid"})) {
        c.wish(inverted);
    }
    c.y += fit.height + ui.em(0.43F);
}

void draw_crop(Column& c) {
    const Ui& ui = c.ui;
    const Rect head = c.row(1.86F);
    draw_section(ui, c.x, c.y, "Crop cuboid");
    if (c.snapshot.filter.crop &&
        link(ui, {head.right() - ui.em(5.0F), head.y, ui.em(5.0F), head.height}, "crop.reset",
             "Reset", Icon::kUndo)) {
        TemplateFilter whole = c.snapshot.filter;
        whole.crop.reset();
        whole.invert_crop = false;
        c.wish(whole);
    }
    c.y += head.height;
    const int label_width = ui.em(1.43F);
    const int gap = ui.em(0.5F);
    const int field = (c.width - label_width - 2 * gap) / 3;
    const Rect titles = c.row(1.2F);
    for (int i = 0; i < 3; ++i) {
        draw_text(
            ui,
            static_cast<float>(c.x + label_width + i * (field + gap) + field) - ui.scale.em(0.57F),
            middle_of(titles), FontRole::kCaption, ui.theme.text_third,
            i == 0   ? "from"
            : i == 1 ? "to"
                     : "size",
            Align::kRight);
    }
    c.y += titles.height + ui.em(0.14F);
    const Box box = edited_crop(c.snapshot).value_or(Box{});
    for (int axis = 0; axis < 3; ++axis) draw_axis_inputs(c, box, axis, label_width);
    c.y += ui.em(0.14F);
    draw_crop_buttons(c);
    if (!c.snapshot.shown_template) return;
    const FilterCounts& counts = c.snapshot.shown_template->counts;
    const Rect row = c.row(1.5F);
    draw_count(c, row, "left", counts.all - counts.cut_off, Align::kLeft);
    draw_count(c, row, "cut off", counts.cut_off, Align::kRight);
    c.y += row.height;
}

void draw_histogram(const Ui& ui, const Rect& area, const FilterCounts& counts, int min_seen,
                    int most) {
    std::size_t highest = 1;
    for (const std::size_t n : counts.seen_by) highest = std::max(highest, n);
    const int half = ui.px(5);  // as the slider's knob
    const double room = area.width - 2 * half;
    for (int n = 1; n <= most; ++n) {
        const auto k = static_cast<std::size_t>(n);
        if (k >= counts.seen_by.size() || counts.seen_by[k] == 0) continue;
        const double step = most > 1 ? room / (most - 1) : room;
        const double centre = area.x + half + (n - 1) * step;
        const int left = std::max(area.x, static_cast<int>(centre - 0.42 * step));
        const int right = std::min(area.right(), static_cast<int>(centre + 0.42 * step));
        const int height =
            std::max(1, static_cast<int>(area.height * static_cast<double>(counts.seen_by[k]) /
                                         static_cast<double>(highest)));
        const double part = most > 1 ? static_cast<double>(n - 1) / (most - 1) : 0.0;
        fill({left, area.bottom() - height, std::max(1, right - left), height},
             n < min_seen ? ui.theme.too_few : map_colour(ColourMap::kSeen, part));
    }
}

void draw_seen(Column& c) {
    const Ui& ui = c.ui;
    const int most = most_seen(c.snapshot);
    const bool known = most > 1;
    const std::string_view why = !c.snapshot.shown_template ? c.why_disabled()
                                 : known                    ? ""
                                         : "The points do not say how many views saw them.";
    const int now = c.snapshot.filter.min_seen;
    const NumberSpec spec{.id = "seen.least",
                          .label = "Seen in at least",
                          .value = static_cast<double>(now),
                          .unit = "views",
                          .decimals = 0,
                          .min = 1,
                          .max = static_cast<double>(std::max(2, most)),
                          .why_disabled = why};
    const Rect head = c.row(1.86F);
    draw_section(ui, c.x, c.y, "Seen in at least");
    std::optional<double> wanted =
        number_input(ui, {head.right() - ui.em(6.0F), head.y, ui.em(6.0F), head.height}, spec)
            .committed;
    c.y += head.height + ui.em(0.57F);
    const FilterCounts counts =
        c.snapshot.shown_template ? c.snapshot.shown_template->counts : FilterCounts{};
    const Rect bars = c.row(3.6F);
    draw_histogram(ui, bars, counts, now, most);
    c.y += bars.height;
    NumberSpec sliding = spec;
    sliding.id = "seen.slider";
    if (const auto moved = slider(ui, c.row(1.43F), sliding)) wanted = moved;
    c.y += ui.em(1.43F);
    if (known) {
        const Rect ticks = c.row(1.1F);
        draw_text(ui, static_cast<float>(c.x), middle_of(ticks), FontRole::kNumberCaption,
                  ui.theme.text_third, "1");
        draw_text(ui, static_cast<float>(ticks.right()), middle_of(ticks), FontRole::kNumberCaption,
                  ui.theme.text_third, fmt::format("{}", most), Align::kRight);
        c.y += ticks.height;
    }
    if (wanted && static_cast<int>(*wanted) != now) {
        TemplateFilter filter = c.snapshot.filter;
        filter.min_seen = static_cast<int>(*wanted);
        c.wish(filter);
    }
    if (!c.snapshot.shown_template) return;
    const std::size_t before = counts.all - counts.cut_off;
    const std::size_t left = before - counts.too_few;
    const Rect row = c.row(1.5F);
    draw_count(c, row, "kept", left, Align::kLeft,
               before > 0 ? fmt::format("{:.1f} %", 100.0 * static_cast<double>(left) /
                                                        static_cast<double>(before))
                          : "");
    draw_count(c, row, "dropped", counts.too_few, Align::kRight);
    c.y += row.height;
}

void draw_denoise_numbers(Column& c) {
    const Ui& ui = c.ui;
    const TemplateFilter& filter = c.snapshot.filter;
    const Rect row = c.row(1.86F);
    const float y = middle_of(row);
    float x = draw_text(ui, static_cast<float>(row.x), y, FontRole::kTable, ui.theme.text_second,
                        "neighbours") +
              ui.scale.em(0.5F);
    const Rect first{static_cast<int>(x), row.y, ui.em(3.6F), row.height};
    TemplateFilter wanted = filter;
    const auto neighbours = number_input(ui, first,
                                         {.id = "denoise.neighbours",
                                          .label = "Neighbours",
                                          .value = static_cast<double>(filter.denoise_neighbours),
                                          .decimals = 0,
                                          .min = 2,
                                          .max = 100})
                                .committed;
    x = draw_text(ui, static_cast<float>(first.right()) + ui.scale.em(0.86F), y, FontRole::kTable,
                  ui.theme.text_second, "limit") +
        ui.scale.em(0.5F);
    const auto limit = number_input(ui, {static_cast<int>(x), row.y, ui.em(4.8F), row.height},
                                    {.id = "denoise.limit",
                                     .label = "Limit",
                                     .value = filter.denoise_sigmas,
                                     .unit = "σ",
                                     .decimals = 2,
                                     .min = 0.1,
                                     .max = 10.0})
                           .committed;
    if (neighbours) wanted.denoise_neighbours = static_cast<int>(std::lround(*neighbours));
    if (limit) wanted.denoise_sigmas = c.local.last_sigmas = *limit;
    if (neighbours || limit) c.wish(wanted);
    const std::size_t outliers =
        c.snapshot.shown_template ? c.snapshot.shown_template->counts.outliers : 0;
    draw_text(ui, static_cast<float>(row.right()), y, FontRole::kNumberTable, ui.theme.text,
              "− " + shown_count(static_cast<long long>(outliers)), Align::kRight);
    c.y += row.height;
}

void draw_denoise(Column& c) {
    const Ui& ui = c.ui;
    const Rect head = c.row(1.86F);
    draw_section(ui, c.x, c.y, "Denoise");
    const std::string_view why = c.why_disabled();
    const std::array<Option, 2> options{
        {{"denoise.off", "Off", Icon::kNone, {}, why},
         {"denoise.statistical", "Statistical", Icon::kNone, {}, why}}};
    const bool on = c.snapshot.filter.denoise_sigmas > 0.0;
    const int width = ui.em(12.0F);
    if (const auto chosen =
            segments(ui, {head.right() - width, head.y, width, head.height}, options, on ? 1 : 0)) {
        TemplateFilter filter = c.snapshot.filter;
        if (on) c.local.last_sigmas = filter.denoise_sigmas;
        filter.denoise_sigmas = *chosen == 1 ? c.local.last_sigmas : 0.0;
        if ((*chosen == 1) != on) c.wish(filter);
    }
    c.y += head.height;
    if (on) {
        c.y += ui.em(0.57F);
        draw_denoise_numbers(c);
    }
}

void draw_result(Column& c) {
    const Ui& ui = c.ui;
    c.y = draw_section(ui, c.x, c.y, "Result");
    const auto line = [&](std::string_view label, const std::string& value,
                          std::string_view unit = {}) {
        draw_value_row(ui, c.row(1.57F), label, value, unit);
        c.y += ui.em(1.57F);
    };
    if (!c.snapshot.shown_template) {
        line("Points", "–");
        return;
    }
    const TemplateFacts& facts = c.snapshot.shown_template->kept_facts;
    line("Points", shown_count(static_cast<long long>(facts.points)));
    if (facts.bounds) {
        const Eigen::Vector3d size = (facts.bounds->max_m - facts.bounds->min_m) * kMmPerM;
        line("Size", fmt::format("{:.0f} × {:.0f} × {:.0f}", size.x(), size.y(), size.z()), "mm");
    }
    line("Normals", facts.has_normals ? "all" : "none");
    line("Median spacing", shown_number(facts.spacing_m * kMmPerM, 2), "mm");
    if (facts.sigma_m) {
        line("Standard deviation, median", shown_number(*facts.sigma_m * kMmPerM, 2), "mm");
    }
}

void draw_export_button(Column& c, const Rect& area) {
    const Ui& ui = c.ui;
    const bool computing =
        c.snapshot.shown_template && !(c.snapshot.shown_template->filter == c.snapshot.filter);
    const float y = static_cast<float>(area.y) + ui.scale.em(0.9F);
    const std::string note = computing                         ? "The counts are being computed …"
                             : !c.snapshot.last_export.empty() ? c.snapshot.last_export
                                                               : "Nothing is written yet.";
    draw_text(ui, static_cast<float>(area.x), y, FontRole::kSmall, ui.theme.text_third,
              fitted(ui, FontRole::kSmall, note, static_cast<float>(area.width)));
    const bool open = c.snapshot.dialog == Dialog::kExport;
    const std::string_view why = !c.snapshot.shown_template ? "There is no template yet."
                                 : open                     ? "The dialog is open."
                                 : c.snapshot.shown_template->counts.kept == 0
                                     ? "The filter keeps no point."
                                     : "";
    if (button(ui, {area.x, area.y + ui.em(1.86F), area.width, ui.row(3.43F)},
               {.id = "template.export",
                .label = "Export…",
                .icon = Icon::kExport,
                .look = ButtonLook::kNext,
                .why_disabled = why})) {
        c.out.push_back(request::Show{Dialog::kExport});
    }
}

}  // namespace

TemplatePageLayout template_page_layout(const Rect& page, Scale scale) {
    const int width = std::min(static_cast<int>(scale.px(380.0F)), page.width * 6 / 10);
    return {{page.x, page.y, page.width - width, page.height},
            {page.right() - width, page.y, width, page.height}};
}

void draw_template_column(const Ui& ui, const Rect& column, const Snapshot& snapshot,
                          TemplatePageState& local, Requests& out) {
    fill(column, ui.theme.panel);
    fill({column.x, column.y, static_cast<int>(ui.scale.line()), column.height}, ui.theme.bg0);
    const int side = ui.em(1.0F);
    const int more = ui.row(2.57F) + ui.em(0.57F);  // library, object
    const int foot = ui.em(1.86F) + ui.row(3.43F) + side + more;
    const Rect region{column.x + static_cast<int>(ui.scale.line()), column.y,
                      column.width - static_cast<int>(ui.scale.line()),
                      std::max(1, column.height - foot)};
    ScrollArea scroll(ui, region, "template.column");
    Column c{ui,
             snapshot,
             local,
             out,
             column.x + side,
             column.width - 2 * side,
             scroll.rect().y + ui.em(0.57F)};
    draw_head(c);
    c.separate();
    draw_crop(c);
    c.separate();
    draw_seen(c);
    c.separate();
    draw_denoise(c);
    c.separate();
    draw_result(c);
    scroll.end(c.y + ui.em(0.57F));
    draw_separator(ui, column.x, column.bottom() - foot, column.width);
    const int gap = ui.em(0.57F);
    const int half = (c.width - gap) / 2;
    const Rect left{c.x, column.bottom() - foot + gap, half, ui.row(2.57F)};
    action_button(ui, left, action("library.add"), snapshot, {}, out);
    action_button(ui, {left.right() + gap, left.y, c.width - half - gap, left.height},
                  action("object.register"), snapshot, {}, out);
    draw_export_button(c, {c.x, column.bottom() - foot + more, c.width, foot - more});
}

}  // namespace gripscan::ui
