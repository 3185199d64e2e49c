#include "core/registration/align_held.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/base/units.h"
#include "core/geometry/axis.h"
#include "core/registration/align_surfaces.h"
#include "core/registration/fits_as_well.h"
#include "core/registration/joint_system.h"
#include "core/registration/quality.h"
#include "core/registration/texture_difference.h"

namespace gripscan {
namespace {

/// Poses nearer than this are one answer: both are the same minimum, reached from two sides.
constexpr double kSameShift_m = 0.0007;
constexpr double kSameTurn_rad = 0.5 * kRadPerDeg;
/// Texture that differs by less than this share says nothing.
constexpr double kPlainly = 0.95;
/// Texture is compared at this scale: the search leaves some pixels, the noise of one is too fine.
constexpr int kScale = 1;

/// A turn that is wrong by this, three of the usual limit of a step, has to look different.
constexpr double kTurnedBeside_rad = 1.5 * kRadPerDeg;

bool same_answer(const Alignment& a, const Alignment& b, const Eigen::Vector3d& centre_m) {
    const double shift_m = (a.T_target_source * centre_m - b.T_target_source * centre_m).norm();
    const double turn_rad =
        rotation_angle_rad(a.T_target_source.linear().transpose() * b.T_target_source.linear());
    return shift_m < kSameShift_m && turn_rad < kSameTurn_rad;
}

/// How the gripper moved, by its own surface; nothing where that does not show its turn.
std::optional<Alignment> motion_of_holder(const Holder& source, const Holder& target,
                                          const AlignSettings& settings) {
    Alignment moved =
        finish_alignment(source.surface, target.surface,
                         target.T_camera_holder * source.T_camera_holder.inverse(), settings);
    moved.starts_agree = true;  // its template was found in each of the two
    judge_alone(moved, settings);
    if (moved.verdict == Verdict::kReject) return std::nullopt;
    return moved;
}

/// The line that a motion turns about; only of one that turns.
Axis turned_about(const Alignment& a) {
    const Eigen::Vector3d& t = a.T_target_source.translation();
    const Eigen::Vector3d across = t - a.axis * a.axis.dot(t);
    return {0.5 * (across + a.axis.cross(across) / std::tan(0.5 * a.angle_rad)), a.axis};
}

/// The share by which the two pictures' patterns differ less at the answer than turned beside it:
/// 0 where texture does not show the turn either.
double observability_by_texture(const Surface& source, const Surface& target,
                                const Alignment& answer) {
    const auto here = texture_difference(source, target, answer, kScale);
    if (!here || answer.angle_rad < kTurnedBeside_rad) return 0.0;
    const Axis axis = turned_about(answer);
    double least = std::numeric_limits<double>::infinity();
    for (const double side : {-1.0, 1.0}) {
        Alignment beside = answer;
        beside.T_target_source =
            turn_about(axis, side * kTurnedBeside_rad) * answer.T_target_source;
        const auto there = texture_difference(source, target, beside, kScale);
        if (!there) return 0.0;
        least = std::min(least, *there);
    }
    return least > *here ? 1.0 - *here / least : 0.0;
}

/// What a round part does not show by its shape it may show by its texture.
void look_at_texture(const Surface& source, const Surface& target, const AlignSettings& settings,
                     Alignment& answer) {
    const bool round = answer.found && answer.observability < kLeastObservability;
    if (!round || answer.cause != Cause::kSymmetry) return;
    const double shown = observability_by_texture(source, target, answer);
    if (shown <= answer.observability) return;
    answer.observability = shown;
    judge_alone(answer, settings);
}

/// Is the answer that began with the gripper's motion better than the one that was searched?
bool plainly_better(const Surface& source, const Surface& target, const Alignment& free,
                    const Alignment& held) {
    if (!free.found) return true;
    const auto of_free = texture_difference(source, target, free, kScale);
    const auto of_held = texture_difference(source, target, held, kScale);
    return of_free && of_held && *of_held < kPlainly * *of_free;
}

/// What the search found or, where the texture is for it, what the gripper's motion leads to.
Alignment best_answer(const Surface& source, const Surface& target, const Alignment& free,
                      const Pose& T_holder_moved, const AlignSettings& settings) {
    Alignment held = finish_alignment(source, target, T_holder_moved, settings);
    if (free.found && same_answer(free, held, source.centre_m)) {
        if (free.starts_agree) return free;
        // Of several that fit alike it is the one that the gripper's motion leads to.
        Alignment chosen = free;
        chosen.starts_agree = true;
        judge_alone(chosen, settings);
        return chosen;
    }
    if (!plainly_better(source, target, free, held)) return free;
    held.starts_agree = true;
    judge_alone(held, settings);
    return held;
}

/// The gripper's motion as the part's. Its covariance holds all that lies between it and the answer
/// that fits alike.
Alignment carried(const Surface& source, const Surface& target, const Alignment& moved,
                  const Alignment& answer, const AlignSettings& settings) {
    Alignment result = alignment_at(source, target, moved.T_target_source, settings);
    const Vector6d between =
        motion_of(answer.T_target_source * moved.T_target_source.inverse(), result.centre_m);
    result.covariance += between * between.transpose();
    result.sigma_angle_rad = moved.sigma_angle_rad;
    result.observability = moved.observability;
    result.starts_agree = true;
    judge_alone(result, settings);
    return result;
}

/// Where surfaces and patterns fit as well to the gripper's motion: an answer near it is not known
/// better than by what lies between, and any other is none, since what is held moves with its
/// gripper unless something speaks against it.
Alignment compared(const Surface& source, const Surface& target, const Alignment& moved,
                   Alignment answer, const AlignSettings& settings) {
    if (!fits_as_well(source, target, answer, moved.T_target_source, settings)) return answer;
    if (answer.verdict == Verdict::kReject || !same_answer(answer, moved, source.centre_m)) {
        return carried(source, target, moved, answer, settings);
    }
    const Eigen::Matrix3d between =
        moved.T_target_source.linear().transpose() * answer.T_target_source.linear();
    answer.sigma_angle_rad = std::max(answer.sigma_angle_rad, rotation_angle_rad(between));
    return answer;
}

}  // namespace

Result<Alignment> align_held(const HeldSurface& source, const HeldSurface& target,
                             const AlignSettings& settings, const Progress& progress,
                             const ForEach& for_each) {
    const auto free = align_surfaces(source.part, target.part, settings, progress, for_each);
    if (!free || progress.cancelled()) return free;
    const auto moved = motion_of_holder(source.holder, target.holder, settings);
    Alignment answer =
        moved ? best_answer(source.part, target.part, *free, moved->T_target_source, settings)
              : *free;
    look_at_texture(source.part, target.part, settings, answer);
    if (!moved) return answer;
    return compared(source.part, target.part, *moved, std::move(answer), settings);
}

}  // namespace gripscan
