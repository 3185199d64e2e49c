#include "ui/views/scene_words.h"

#include <fmt/format.h>

#include "core/base/units.h"
#include "ui/theme/shown_number.h"
#include "ui/views/recognition_text.h"

namespace gripscan::ui {
namespace {

bool linked(const ProcedureState& state) {
    return !std::holds_alternative<phase::Offline>(state.phase) &&
           !std::holds_alternative<phase::Connecting>(state.phase);
}

}  // namespace

EmptyText empty_scene_text(const Snapshot& snapshot) {
    if (!snapshot.session || snapshot.procedure == nullptr) {
        return {"No session is open", "Begin or open one on the start page."};
    }
    if (snapshot.page == Page::kRecognise) {
        return {"No view yet", "Capture one, or recognise a capture of the session."};
    }
    const ProcedureState& state = *snapshot.procedure;
    if (!state.data.used().empty()) {
        return {"The clouds are not here yet",
                "They are computed from the images; the job bar shows how far it is."};
    }
    if (snapshot.session->recorded) {
        return {"This recording has no clouds", "None of its captures is in use."};
    }
    if (!linked(state)) {
        return {"No cloud yet", "Connect, check the cell, take the first view."};
    }
    if (!state.cell) return {"No cloud yet", "Check the cell, then take the first view."};
    return {"No cloud yet", "Take the first view."};
}

std::string scene_caption(const Snapshot& snapshot, const SceneParts& parts) {
    std::string caption = snapshot.session ? snapshot.session->name : std::string("gripscan");
    switch (parts.kind) {
        case SceneKind::kPair:
            caption += fmt::format(", captures {} and {}", parts.pair_from, parts.pair_to);
            break;
        case SceneKind::kTemplate:
            caption += fmt::format(", template of {} steps", parts.steps_done);
            break;
        case SceneKind::kGrowing:
            caption += fmt::format(", step {} of {}, {}°", parts.steps_done, parts.steps_total,
                                   shown_number(deg_from_rad(parts.turn.turned_rad), 1));
            break;
        case SceneKind::kFound:
            caption += ", " + view_words(*snapshot.recognition);
            break;
        case SceneKind::kEmpty:
            return caption;
    }
    return caption + ", " + shown_count(static_cast<long long>(visible_points(parts))) + " points";
}

}  // namespace gripscan::ui
