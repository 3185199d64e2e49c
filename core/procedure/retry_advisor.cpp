#include "core/procedure/retry_advisor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/units.h"
#include "core/procedure/angle_pattern.h"
#include "core/procedure/remedy.h"
#include "core/procedure/step_evidence_text.h"

namespace gripscan {
namespace {

/// Angles that were halved down to the floor have lost some last bits.
constexpr double kRounding_rad = 1e-9;
constexpr int kAnyNumber = std::numeric_limits<int>::max();

struct Diagnosis {
    Cause cause = Cause::kNone;
    Certainty certainty = Certainty::kFirstLook;
    std::string evidence;  ///< from the pattern over rows and attempts; may be empty
};

bool shifts_the_gripper(const TurnStep& row) {
    return !trusted(row) && (row.cause == Cause::kSlip || row.cause == Cause::kLoose);
}

/// One slip is a slip; again in the next step it is a gripper that does not hold.
Diagnosis diagnose_slip(const AdvisorCase& c) {
    if (c.before.empty() || !shifts_the_gripper(c.before.back().row))
        return {Cause::kSlip, Certainty::kFirstLook, {}};
    return {Cause::kLoose, Certainty::kEstablished,
            "the gripper has shifted in two steps in a row"};
}

/// The row's cause, sharpened by what other rows and attempts say.
Diagnosis diagnose(const AdvisorCase& c, const TurnLimits& limits) {
    const TurnStep& row = c.step.row;
    // What stands in the area spoils the angle as well: no pattern of angles says what it is.
    if (c.step.foreign) return {row.cause, Certainty::kEstablished, {}};
    if (row.cause == Cause::kSlip) return diagnose_slip(c);
    // Set from a pattern over the whole table: no accident.
    if (row.cause == Cause::kSign || row.cause == Cause::kRatio) {
        return {row.cause, Certainty::kEstablished, {}};
    }
    if (row.cause != Cause::kMislabelled) return {row.cause, Certainty::kFirstLook, {}};
    // An angle that the surface does not show is no witness against the robot's.
    if (!c.turn_not_seen.empty()) {
        return {Cause::kSymmetry, Certainty::kEstablished, c.turn_not_seen};
    }
    AnglePattern pattern = angle_pattern(c, limits);
    return {pattern.cause, pattern.certainty, std::move(pattern.evidence)};
}

struct Retakes {
    int all = 0;    ///< pictures at this angle before this one
    int alike = 0;  ///< of them, those with the same trouble
};

Retakes retakes_made(const AdvisorCase& c) {
    Retakes made;
    for (const JudgedStep& attempt : c.attempts) {
        if (!at_same_angle(c.step.row, attempt.row)) continue;
        ++made.all;
        if (attempt.row.cause == c.step.row.cause) ++made.alike;
    }
    return made;
}

/// Rejected rows in a row, this one among them.
int rejected_in_a_row(const AdvisorCase& c) {
    int count = 1;
    for (auto row = c.before.rbegin(); row != c.before.rend(); ++row, ++count) {
        if (row->row.verdict != Verdict::kReject) break;
    }
    return count;
}

/// The step before was not accepted for the same cause: it will not go away.
bool persists(const AdvisorCase& c, Cause cause) {
    return !c.before.empty() && !trusted(c.before.back().row) && c.before.back().row.cause == cause;
}

/// One decision, with what all decisions need to say.
class Adviser {
  public:
    Adviser(const AdvisorCase& c, const TurnPlan& plan)
        : c_(c), plan_(plan), diagnosis_(diagnose(c, plan.limits)), retakes_(retakes_made(c)) {}

    [[nodiscard]] Advice advice() const {
        const TurnStep& row = c_.step.row;
        if (c_.step.foreign) {
            return say(AdvisedAction::kStop,
                       fmt::format("Stop and ask: {}; clear the registration area and retake",
                                   description(*c_.step.foreign)));
        }
        if (trusted(row)) return go_on("the step is accepted");
        if (not_independent_only()) {
            return go_on("the angle is taken from the robot; nothing contradicts it");
        }
        if (may_retake()) return retake();
        if (may_halve()) return halve();
        return last_resort();
    }

  private:
    [[nodiscard]] const Remedy& remedy() const { return remedy_for(diagnosis_.cause); }
    [[nodiscard]] bool check() const { return c_.step.row.verdict == Verdict::kCheck; }

    [[nodiscard]] bool not_independent_only() const {
        return check() && (diagnosis_.cause == Cause::kNone ||
                           (diagnosis_.cause == Cause::kSymmetry && c_.axis_locked));
    }

    [[nodiscard]] int retakes_worth_making() const {
        if (diagnosis_.certainty >= Certainty::kReproduced) return 0;
        // What changes while the robot stands deserves all the pictures there are.
        if (diagnosis_.certainty == Certainty::kUnsteady) return plan_.retakes_an_angle;
        return std::min({remedy().retakes, plan_.retakes_an_angle, check() ? 1 : kAnyNumber});
    }
    [[nodiscard]] bool may_retake() const {
        return retakes_.alike < retakes_worth_making() && retakes_.all < plan_.retakes_an_angle;
    }

    /// A smaller step tells a ratio from play: the ratio's error follows it.
    [[nodiscard]] bool experiment() const {
        return diagnosis_.certainty == Certainty::kReproduced && !check();
    }
    [[nodiscard]] bool may_halve() const {
        const bool worth =
            diagnosis_.certainty == Certainty::kFirstLook ? remedy().halving_helps : experiment();
        return worth && 0.5 * c_.step_rad >= least_halved_rad() - kRounding_rad;
    }
    /// Floor and budget.
    [[nodiscard]] double least_halved_rad() const {
        if (!plan_.halvings_a_turn) return plan_.least_step_rad;
        return std::max(plan_.least_step_rad, std::ldexp(plan_.step_rad, -*plan_.halvings_a_turn));
    }

    [[nodiscard]] Advice retake() const {
        return say(AdvisedAction::kRetake,
                   fmt::format("Retake at the same angle ({} of {}): {}", retakes_.all + 1,
                               retakes_.all - retakes_.alike + retakes_worth_making(), why()));
    }
    [[nodiscard]] Advice halve() const {
        return say(
            AdvisedAction::kHalve,
            fmt::format("Halve the step to {:.2f} deg{}: {}", deg_from_rad(0.5 * c_.step_rad),
                        experiment() ? ", which tells a ratio from play" : "", why()));
    }
    [[nodiscard]] Advice go_on(std::string_view because) const {
        return say(AdvisedAction::kGoOn, fmt::format("Go on: {}", because));
    }
    [[nodiscard]] Advice stop() const {
        return say(AdvisedAction::kStop,
                   fmt::format("Stop and ask: {}; {}", why(), remedy().what_to_do));
    }

    [[nodiscard]] Advice last_resort() const {
        switch (remedy().last) {
            case LastResort::kLockAxis:
                if (c_.axis_locked) return go_on_while_few_are_rejected();
                return say(
                    AdvisedAction::kLockAxis,
                    fmt::format("Lock to the axis and take the angle from the robot: {}", why()));
            case LastResort::kGatherRows:
                return go_on_while_few_are_rejected();
            case LastResort::kStopIfBad:
            case LastResort::kStop:
                return may_be_shown() ? go_on_while_few_are_rejected() : stop();
        }
        return stop();
    }

    /// Slightly over a limit, in this step alone: the row is merged and marked.
    [[nodiscard]] bool may_be_shown() const {
        if (!check() || diagnosis_.certainty == Certainty::kEstablished) return false;
        if (diagnosis_.certainty == Certainty::kReproduced) return true;
        return remedy().last == LastResort::kStopIfBad && !persists(c_, diagnosis_.cause);
    }

    [[nodiscard]] Advice go_on_while_few_are_rejected() const {
        if (check()) {
            return go_on(
                fmt::format("little is wrong and the row is marked to be checked; {}", why()));
        }
        const int rejected = rejected_in_a_row(c_);
        if (rejected < plan_.rejected_in_a_row) {
            return go_on(
                fmt::format("the view is left out, and the steps that follow will show "
                            "what it is; {}",
                            why()));
        }
        return say(AdvisedAction::kStop,
                   fmt::format("Stop and ask: {} steps in a row are rejected, this one because "
                               "{}; {}",
                               rejected, why(), remedy().what_to_do));
    }

    /// What is wrong, and the number that says so.
    [[nodiscard]] std::string why() const {
        const std::string& number =
            diagnosis_.evidence.empty() ? c_.step.row.sentence : diagnosis_.evidence;
        return number.empty() ? std::string(remedy().what_is_wrong)
                              : fmt::format("{} ({})", remedy().what_is_wrong, number);
    }

    [[nodiscard]] Advice say(AdvisedAction action, std::string sentence) const {
        Advice advice{action, diagnosis_.cause, std::move(sentence), {}};
        if (!diagnosis_.evidence.empty()) advice.evidence.push_back(diagnosis_.evidence);
        for (std::string& line : evidence_of(c_.step, plan_.limits)) {
            advice.evidence.push_back(std::move(line));
        }
        return advice;
    }

    const AdvisorCase& c_;
    const TurnPlan& plan_;
    Diagnosis diagnosis_;
    Retakes retakes_;
};

}  // namespace

Advice advise(const AdvisorCase& c, const TurnPlan& plan) {
    return Adviser(c, plan).advice();
}

}  // namespace gripscan
