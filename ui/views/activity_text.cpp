#include "ui/views/activity_text.h"

#include <fmt/format.h>

#include <array>

#include "core/base/units.h"
#include "ui/theme/shown_number.h"

namespace gripscan::ui {
namespace {

std::string angle(double rad) {
    return fmt::format("`{}°`", shown_number(deg_from_rad(rad), 3));
}

std::string view_of(const Shot& shot) {
    if (shot.purpose == ShotPurpose::kWarmUp) return fmt::format("warm-up view `{}`", -shot.index);
    return fmt::format("capture `{}`", shot.index);
}

struct Sentence {
    std::string operator()(const activity::CheckingCell&) const {
        return "Every prerequisite of the turn is measured.";
    }
    std::string operator()(const activity::Moving& a) const {
        return fmt::format("Joint 6 turns to {}{}.", angle(a.target_rad()),
                           a.shot ? " for " + view_of(*a.shot) : std::string());
    }
    std::string operator()(const activity::AwaitingOperator& a) const {
        return fmt::format("Turn joint 6 to {} with the pendant, then capture.",
                           angle(a.target_rad));
    }
    std::string operator()(const activity::Exposing& a) const {
        return fmt::format("The cameras take {}.", view_of(a.shot));
    }
    std::string operator()(const activity::Judging& a) const {
        return fmt::format("Captures `{}` and `{}` are aligned and compared with the robot.",
                           a.from, a.to);
    }
    std::string operator()(const activity::EstimatingAxis&) const {
        return "The axis of joint 6 is found in the views of the warm-up.";
    }
    std::string operator()(const activity::Solving&) const {
        return "All views are solved together and merged.";
    }
};

}  // namespace

const Activity* activity_of(const ProcedureState& state) {
    if (const auto* busy = std::get_if<phase::Busy>(&state.phase)) return &busy->activity;
    if (const auto* halting = std::get_if<phase::Halting>(&state.phase)) return &halting->activity;
    return nullptr;
}

std::string activity_sentence(const Activity& activity) {
    return std::visit(Sentence{}, activity);
}

std::string_view activity_word(const Activity& activity) {
    constexpr std::array<std::string_view, std::variant_size_v<Activity>> kWords{
        "Checking the cell", "Moving",           "Your turn", "Capturing",
        "Aligning",          "Finding the axis", "Solving"};
    return kWords[activity.index()];
}

bool warming_up(const ProcedureState& state) {
    const Activity* activity = activity_of(state);
    if (activity == nullptr) return false;
    const auto is_warm_up = [](const Shot& shot) { return shot.purpose == ShotPurpose::kWarmUp; };
    if (const auto* moving = std::get_if<activity::Moving>(activity)) {
        return moving->shot && is_warm_up(*moving->shot);
    }
    if (const auto* exposing = std::get_if<activity::Exposing>(activity)) {
        return is_warm_up(exposing->shot);
    }
    return std::holds_alternative<activity::EstimatingAxis>(*activity);
}

}  // namespace gripscan::ui
