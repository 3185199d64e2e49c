#include "core/registration/align_held.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/base/units.h"
#include "core/registration/align_surfaces.h"
#include "core/registration/texture_rows.h"

namespace gripscan {
namespace {

/// Poses nearer than this are one answer: both are the same minimum, reached from two sides.
constexpr double kSameShift_m = 0.0007;
constexpr double kSameTurn_rad = 0.5 * kRadPerDeg;
/// Without texture to decide, a start from the gripper's motion may fit less well by this overlap.
constexpr double kNearlyAsMuch = 0.05;
/// Texture that differs by less than this share says nothing.
constexpr double kPlainly = 0.95;
/// Texture is compared where the surfaces meet this closely, in radii of the part.
constexpr double kGateShare = 0.03;

bool same_answer(const Alignment& a, const Alignment& b, const Eigen::Vector3d& centre_m) {
    const double shift_m = (a.T_target_source * centre_m - b.T_target_source * centre_m).norm();
    const double turn_rad =
        rotation_angle_rad(a.T_target_source.linear().transpose() * b.T_target_source.linear());
    return shift_m < kSameShift_m && turn_rad < kSameTurn_rad;
}

/// Median difference of the two pictures' patterns at a pose; nothing where they show too little.
std::optional<double> texture_difference(const Surface& source, const Surface& target,
                                         const Alignment& at) {
    const double gate_m = kGateShare * std::max(source.radius_m, target.radius_m);
    const auto rows = texture_rows(source, target, at.T_target_source, 1, gate_m, at.centre_m);
    if (rows.empty()) return std::nullopt;
    std::vector<double> sizes;
    for (const ResidualRow& row : rows) sizes.push_back(std::abs(row.residual));
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    return *middle;
}

enum class Better { kFree, kHeld, kHeldByTexture };

Better better_of(const Surface& source, const Surface& target, const Alignment& free,
                 const Alignment& held) {
    if (!free.found) return Better::kHeld;
    const auto of_free = texture_difference(source, target, free);
    const auto of_held = texture_difference(source, target, held);
    if (of_free && of_held) {
        return *of_held < kPlainly * *of_free ? Better::kHeldByTexture : Better::kFree;
    }
    return held.overlap > free.overlap - kNearlyAsMuch ? Better::kHeld : Better::kFree;
}

}  // namespace

Result<Alignment> align_held(const Surface& source, const Surface& target,
                             const Pose& T_holder_moved, const AlignSettings& settings,
                             const Progress& progress, const ForEach& for_each) {
    auto free = align_surfaces(source, target, settings, progress, for_each);
    if (!free || progress.cancelled()) return free;
    Alignment held = finish_alignment(source, target, T_holder_moved, settings);
    if (free->found && same_answer(*free, held, source.centre_m)) return free;
    const Better better = better_of(source, target, *free, held);
    if (better == Better::kFree) return free;
    held.starts_agree = free->starts_agree || better == Better::kHeldByTexture;
    judge_alone(held, settings);
    return held;
}

}  // namespace gripscan
