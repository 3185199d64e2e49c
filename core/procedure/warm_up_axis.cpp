#include "core/procedure/warm_up_axis.h"

#include "core/base/units.h"
#include "core/registration/axis_estimate.h"

namespace gripscan {
namespace {

WarmUpAxis no_axis(Cause cause, const std::string& why) {
    return {{std::nullopt, fmt::format("not found in the warm-up: {}", why), std::nullopt, cause}};
}

/// Upwards is positive: by the hint, else as the turns went. True: they went against the hint.
bool settle_sign(Axis& axis, const std::optional<Eigen::Vector3d>& axis_hint,
                 std::span<const Pose> turns) {
    double turned_rad = 0.0;
    for (const Pose& T : turns) turned_rad += deviation_from(axis, T).angle_rad;
    if (turned_rad < 0.0) axis.direction = -axis.direction;
    const bool backwards = axis_hint && axis.direction.dot(*axis_hint) < 0.0;
    if (backwards) axis.direction = -axis.direction;
    return backwards;
}

}  // namespace

Result<WarmUpAxis> find_axis(std::span<const RecordedCapture> shots, TurnWorkspace& workspace,
                             const std::optional<Eigen::Vector3d>& axis_hint,
                             const Progress& progress, const ForEach& for_each) {
    Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
    for (const RecordedCapture& shot : shots) {
        if (auto added = workspace.add(shot, progress, for_each); !added) {
            return forward_error(added.error());
        }
        if (const PreparedView* view = workspace.view(shot.index)) {
            centre_m += view->surface.centre_m / static_cast<double>(shots.size());
        }
    }
    std::vector<Pose> turns;
    for (std::size_t last = 1; last < shots.size(); ++last) {
        auto result = workspace.last_step(shots.subspan(last - 1, 2), progress, for_each);
        if (!result) return forward_error(result.error());
        const TurnStep& row = result->step;
        if (!row.T || row.cause == Cause::kSymmetry || row.cause == Cause::kNotConverged) {
            return no_axis(row.cause, row.sentence);
        }
        turns.push_back(*row.T);
    }
    auto axis = estimate_axis(turns, centre_m);
    if (!axis) return no_axis(Cause::kNotConverged, "nothing turned");
    const bool backwards = settle_sign(axis->axis, axis_hint, turns);
    const std::string sentence =
        fmt::format("found by {} small turns to {:.2f} deg and {:.2f} mm{}", turns.size(),
                    deg_from_rad(axis->sd_rad), axis->sd_m * kMmPerM,
                    backwards ? "; the scans turn the other way than joint 6 reports" : "");
    return WarmUpAxis{{axis, sentence, std::nullopt, std::nullopt}, backwards ? -1.0 : 1.0};
}

}  // namespace gripscan
