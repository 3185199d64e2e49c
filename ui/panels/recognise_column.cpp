#include "ui/panels/recognise_column.h"

#include <fmt/format.h>

#include <array>

#include "ui/panels/action_button.h"
#include "ui/panels/evidence_of.h"
#include "ui/panels/panel_parts.h"
#include "ui/views/recognition_text.h"
#include "ui/widgets/choice.h"
#include "ui/widgets/rich_text.h"
#include "ui/widgets/scroll_area.h"
#include "ui/widgets/verdict_card.h"

namespace gripscan::ui {
namespace {

constexpr float kRow_em = 1.64F;

/// What every section needs, and where the next one begins.
struct Column {
    const Ui& ui;
    const Snapshot& snapshot;
    RecognisePageState& local;
    Requests& out;
    int x;
    int width;
    int y;

    [[nodiscard]] Rect row(float height_em = kRow_em) const {
        return {x, y, width, ui.em(height_em)};
    }
    void separate() {
        y += ui.em(0.71F);
        draw_separator(ui, x - ui.em(1.0F), y, width + 2 * ui.em(1.0F));
        y += ui.em(0.57F);
    }
};

void draw_heading(Column& c) {
    const Ui& ui = c.ui;
    const auto& shown = c.snapshot.recognition;
    const Rect head = c.row(2.0F);
    draw_text(ui, static_cast<float>(c.x), middle_of(head), FontRole::kTitle, ui.theme.text,
              shown ? fmt::format("View {}", shown->view) : "Recognise");
    c.y += head.height;
    std::string how = "Templates of the library, looked for in one view.";
    if (shown) {
        const std::string from = shown->capture
                                     ? fmt::format("Capture {} of the session", *shown->capture)
                                     : std::string("One view, captured for this");
        how = fmt::format("{}, recognised in `{}` s.", from, shown_number(shown->seconds, 2));
    }
    c.y += draw_rich_text(ui, c.x, c.y, c.width, ui.theme.text_second, how,
                          {FontRole::kTable, FontRole::kNumberTable, 1.5F});
    c.y += ui.em(0.57F);
}

void draw_verdict(Column& c) {
    const RecognitionVerdict v = recognition_verdict(c.snapshot);
    c.ui.log.record({"recognise.verdict", v.word, {c.x, c.y, c.width, 1}, true, v.sentence});
    c.y += draw_verdict_card(c.ui, c.x, c.y, c.width, {v.state, v.word, {}, false, v.sentence});
}

void draw_found(Column& c, std::size_t i) {
    const Ui& ui = c.ui;
    const ShownRecognition& shown = *c.snapshot.recognition;
    const FoundTemplate& found = shown.found[i];
    c.separate();
    const Rect head = c.row(1.86F);
    const std::string title = fmt::format(
        "{} {}", found.kind == TemplateKind::kGripper ? "Gripper" : "Object", found.name);
    const int side = ui.em(0.79F);
    const std::string score = shown_number(found.score, 2);
    const float score_px = text_width(ui, FontRole::kNumberTable, score);
    draw_text(ui, static_cast<float>(c.x), middle_of(head), FontRole::kTextStrong, ui.theme.text,
              fitted(ui, FontRole::kTextStrong, title,
                     static_cast<float>(c.width - side) - score_px - ui.scale.em(1.0F)));
    draw_text(ui, static_cast<float>(head.right()), middle_of(head), FontRole::kNumberTable,
              ui.theme.text, score, Align::kRight);
    fill({head.right() - static_cast<int>(score_px) - side - ui.em(0.57F),
          head.y + (head.height - side) / 2, side, side},
         ui.theme.*colour_of_found(shown, i));
    ui.log.record({fmt::format("found.{}", i), title, head, true, found.explained});
    c.y += head.height;
    for (const EvidenceText& e : found_evidence(shown, i)) {
        const std::string id = fmt::format("{}.{}", e.id, i);
        Evidence row = evidence_of(e);
        row.id = id;
        (void)evidence_row(ui, c.row(), row);
        c.y += c.row().height;
    }
    for (const auto& [label, words] : found_remarks(found)) {
        draw_value_row(ui, c.row(), label, words);
        c.y += c.row().height;
    }
}

void draw_witness(Column& c) {
    const auto witness = witness_of(c.snapshot);
    if (!witness) return;
    const Ui& ui = c.ui;
    c.separate();
    const Rect head = c.row(1.86F);
    draw_text(ui, static_cast<float>(c.x), middle_of(head), FontRole::kTextStrong, ui.theme.text,
              "Witness");
    draw_text(ui, static_cast<float>(head.right()), middle_of(head), FontRole::kSmall,
              ui.theme.text_third, "independent of the match", Align::kRight);
    c.y += head.height;
    const std::array<std::pair<std::string_view, const std::string*>, 3> rows{
        {{"J6 from the robot", &witness->robot_deg},
         {"J6 from the gripper", &witness->gripper_deg},
         {"Difference", &witness->difference_deg}}};
    for (const auto& [label, value] : rows) {
        draw_value_row(ui, c.row(), label, *value, "°");
        c.y += c.row().height;
    }
}

/// In place of a template's row: a file is deleted, which nothing takes back.
void ask_before_removing(Column& c, std::size_t i) {
    const Ui& ui = c.ui;
    const LibraryEntry& entry = c.snapshot.library[i];
    const Rect row = c.row(1.86F);
    const int wide = ui.em(4.0F);
    const int gap = ui.em(0.36F);
    const Rect keep{row.right() - wide, row.y, wide, row.height - ui.em(0.14F)};
    const Rect erase{keep.x - gap - wide, row.y, wide, keep.height};
    draw_text(ui, static_cast<float>(row.x), middle_of(row), FontRole::kTable, ui.theme.text,
              fitted(ui, FontRole::kTable, fmt::format("Delete {}?", entry.name),
                     static_cast<float>(erase.x - row.x - gap)));
    const std::string erase_id = fmt::format("library.delete.{}", i);
    const std::string keep_id = fmt::format("library.keep.{}", i);
    ButtonSpec spec{erase_id, "Delete"};
    spec.look = ButtonLook::kStop;
    const bool erased = button(ui, erase, spec).clicked;
    if (erased) c.out.push_back(request::LibraryRemove{entry.name});
    if (button(ui, keep, {keep_id, "Keep"}) || erased) c.local.to_remove.clear();
    c.y += row.height;
}

/// A template of the library with its marks, and the button that takes it out.
void draw_entry(Column& c, std::size_t i) {
    const Ui& ui = c.ui;
    const LibraryEntry& entry = c.snapshot.library[i];
    if (entry.name == c.local.to_remove) return ask_before_removing(c, i);
    const Rect row = c.row(1.86F);
    const bool gripper = entry.kind == TemplateKind::kGripper;
    const int side = ui.em(0.57F);
    fill({row.x, row.y + (row.height - side) / 2, side, side},
         gripper ? ui.theme.gripper : ui.theme.object);
    const int button_side = ui.em(1.71F);
    const Rect remove{row.right() - button_side, row.y + (row.height - button_side) / 2,
                      button_side, button_side};
    const std::string id = fmt::format("library.remove.{}", i);
    ButtonSpec spec{id, {}, Icon::kClose};
    spec.tooltip = "Delete this template from the library; the session it came from stays";
    if (icon_button(ui, remove, spec)) c.local.to_remove = entry.name;
    const std::string note = entry.stale.empty()
                                 ? shown_count(static_cast<long long>(entry.points)) + " points"
                                 : "stale";
    const auto right = static_cast<float>(remove.x) - ui.scale.em(0.57F);
    draw_text(ui, right, middle_of(row), FontRole::kSmall,
              entry.stale.empty() ? ui.theme.text_third : ui.theme.check, note, Align::kRight);
    const float room = right - text_width(ui, FontRole::kSmall, note) -
                       static_cast<float>(row.x + side) - ui.scale.em(1.3F);
    draw_text(ui, static_cast<float>(row.x + side) + ui.scale.em(0.57F), middle_of(row),
              FontRole::kTable, ui.theme.text, fitted(ui, FontRole::kTable, entry.name, room));
    ui.log.record({fmt::format("library.{}", i), entry.name, row, true,
                   entry.stale.empty() ? entry.lineage : entry.stale});
    c.y += row.height;
}

void draw_library(Column& c) {
    const Ui& ui = c.ui;
    c.separate();
    const Rect head = c.row(1.86F);
    draw_text(ui, static_cast<float>(c.x), middle_of(head), FontRole::kTextStrong, ui.theme.text,
              "Library");
    draw_text(ui, static_cast<float>(head.right()), middle_of(head), FontRole::kSmall,
              ui.theme.text_third, fmt::format("{} templates", c.snapshot.library.size()),
              Align::kRight);
    c.y += head.height;
    for (std::size_t i = 0; i < c.snapshot.library.size(); ++i) draw_entry(c, i);
    c.y += ui.em(0.43F);
    action_button(ui, c.row(2.14F), action("library.add"), c.snapshot, {}, c.out);
    c.y += ui.em(2.14F);
}

}  // namespace

void draw_recognise_column(const Ui& ui, const Rect& column, const Snapshot& snapshot,
                           RecognisePageState& local, Requests& out) {
    fill(column, ui.theme.panel);
    const int side = ui.em(1.0F);
    const int gap = ui.em(0.57F);
    const int x = column.x + side;
    const int width = column.width - 2 * side;

    // From the bottom: what a hand finds without looking.
    const int small = ui.row(2.57F);
    const int large = ui.row(3.43F);
    int bottom = column.bottom() - ui.em(0.86F) - small;
    const int half = (width - gap) / 2;
    const bool live = !snapshot.session || !snapshot.session->recorded;
    action_button(ui, {x, bottom, half, small},
                  action(live ? "recognise.capture" : "recognise.now"), snapshot, {}, out);
    action_button(ui, {x + half + gap, bottom, width - half - gap, small}, action("step.stop"),
                  snapshot, {ButtonLook::kStop}, out);
    bottom -= gap + large;
    const Action& next = snapshot.session && snapshot.session->recorded
                             ? action("recognise.capture")
                             : action("recognise.now");
    const bool can = !next.refusal(snapshot);
    action_button(ui, {x, bottom, width, large}, next, snapshot,
                  {can ? ButtonLook::kNext : ButtonLook::kNormal}, out);

    ScrollArea area(ui, {column.x, column.y, column.width, bottom - gap - column.y},
                    "recognise.column");
    Column c{ui, snapshot, local, out, x, width, area.rect().y + ui.em(0.57F)};
    draw_heading(c);
    draw_verdict(c);
    if (snapshot.recognition) {
        for (std::size_t i = 0; i < snapshot.recognition->found.size(); ++i) draw_found(c, i);
        draw_witness(c);
    }
    draw_library(c);
    area.end(c.y + ui.em(0.57F));
}

}  // namespace gripscan::ui
