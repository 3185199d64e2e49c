#include "core/recognition/symmetry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/units.h"
#include "core/recognition/shape_match.h"
#include "core/recognition/template_model.h"

namespace gripscan {
namespace {

/// Shares of the surface that must lie on itself again.
constexpr double kSame = 0.985;
constexpr double kNearlySame = 0.75;
constexpr double kBodyTheSame = 0.7;
/// Smaller turns are none.
constexpr double kSmallestTurn_rad = 12.0 * kRadPerDeg;

double angle_rad(const Pose& T) {
    return rotation_angle_rad(T.linear());
}

Axis axis_of(const Pose& T) {
    const Eigen::AngleAxisd turn(T.linear());
    const Eigen::Matrix3d A = Eigen::Matrix3d::Identity() - T.linear();
    // The point of the axis nearest to the origin; A has the axis as its null space.
    const Eigen::Vector3d a = turn.axis();
    const Eigen::Vector3d t = T.translation() - a * a.dot(T.translation());
    const Eigen::Vector3d p = (A + a * a.transpose()).inverse() * t;
    return {p, a};
}

/// The line about which every turn leaves that share of the part the same.
std::optional<Axis> revolution(const TemplateModel& model, const ShapeMatcher& self,
                               const std::vector<ShapeMatch>& turns, double least_same) {
    for (const ShapeMatch& turn : turns) {
        if (turn.same < least_same) continue;
        const Axis axis = axis_of(turn.T_still_moving);
        bool every = true;
        for (int k = 1; k <= 7 && every; ++k) {
            // Angles that no small number of equal turns has in common.
            every = self.same(model, turn_about(axis, rad_from_deg(17.0 + 47.0 * k))) >=
                    least_same - 0.01;
        }
        if (every) return axis;
    }
    return std::nullopt;
}

/// A jug is the same after no turn, but only its handle tells: every so many degrees is a pose that
/// may be taken for the right one.
void add_turns_of_a_body_with_a_handle(const TemplateModel& model, const ShapeMatcher& self,
                                       const std::vector<ShapeMatch>& turns, Symmetry& symmetry) {
    // Turns that fit much better than any other angle are those of a prism, not of a body.
    const double best = turns.empty() ? 0.0 : turns.front().same;
    const auto axis = revolution(model, self, turns, std::max(kBodyTheSame, best - 0.08));
    if (!axis) return;
    constexpr int kTurns = 18;
    std::erase_if(symmetry.near_turns, [&](const Pose& T) {
        return (T.linear() * axis->direction).dot(axis->direction) > 0.98;
    });
    for (int k = 1; k < kTurns; ++k) {
        symmetry.near_turns.push_back(turn_about(*axis, 2.0 * std::numbers::pi * k / kTurns));
    }
}

std::string name_of(const Symmetry& symmetry) {
    if (symmetry.revolution) {
        return symmetry.turns.empty() ? "revolution" : "revolution and ends alike";
    }
    if (symmetry.turns.empty()) return "none";
    const Eigen::Vector3d first = Eigen::AngleAxisd(symmetry.turns.front().linear()).axis();
    const bool one_axis =
        std::all_of(symmetry.turns.begin(), symmetry.turns.end(), [&](const Pose& T) {
            return std::abs(Eigen::AngleAxisd(T.linear()).axis().dot(first)) > 0.98;
        });
    return one_axis ? fmt::format("{}-fold", symmetry.turns.size() + 1)
                    : fmt::format("{} poses alike", symmetry.turns.size() + 1);
}

}  // namespace

Symmetry find_symmetry(const TemplateModel& model, const ForEach& for_each) {
    const ShapeMatcher self(model);
    auto turns = self.search(model, kNearlySame, for_each);
    std::erase_if(turns, [](const ShapeMatch& turn) {
        return angle_rad(turn.T_still_moving) < kSmallestTurn_rad;
    });
    Symmetry symmetry;
    symmetry.revolution = revolution(model, self, turns, kSame);
    for (const ShapeMatch& turn : turns) {
        if (symmetry.revolution) {
            const Eigen::Vector3d& a = symmetry.revolution->direction;
            if ((turn.T_still_moving.linear() * a).dot(a) > 0.9)
                continue;  // one of the revolution's own
            const bool have_ends = !symmetry.turns.empty();
            if (turn.same >= kSame && !have_ends) symmetry.turns.push_back(turn.T_still_moving);
            if (turn.same < kSame) symmetry.near_turns.push_back(turn.T_still_moving);
            continue;
        }
        (turn.same >= kSame ? symmetry.turns : symmetry.near_turns).push_back(turn.T_still_moving);
    }
    if (!symmetry.revolution) add_turns_of_a_body_with_a_handle(model, self, turns, symmetry);
    symmetry.name = name_of(symmetry);
    return symmetry;
}

Pose nearest_equivalent(const Pose& T, const Symmetry& symmetry, const Pose& reference) {
    std::vector<Pose> all{T};
    for (const Pose& turn : symmetry.turns) all.push_back(T * turn);
    if (symmetry.revolution) {
        const Axis& axis = *symmetry.revolution;
        for (Pose& candidate : all) {
            // The turn about the axis that brings the rotation nearest: its angle is the twist of
            // what is between the two.
            const Eigen::Quaterniond q(
                Eigen::Matrix3d(candidate.linear().transpose() * reference.linear()));
            const double twist = 2.0 * std::atan2(q.vec().dot(axis.direction), q.w());
            candidate = candidate * turn_about(axis, twist);
        }
    }
    const auto distance = [&](const Pose& candidate) {
        return angle_rad(candidate.inverse() * reference);
    };
    return *std::min_element(all.begin(), all.end(), [&](const Pose& a, const Pose& b) {
        return distance(a) < distance(b);
    });
}

}  // namespace gripscan
