#include "core/procedure/measure_cell.h"

#include <chrono>
#include <system_error>

#include "core/procedure/region_view.h"
#include "core/procedure/still_surface.h"
#include "core/procedure/surface_pieces.h"
#include "core/procedure/swept_room.h"
#include "core/robot/kinematics.h"
#include "core/stereo/rectifier.h"
#include "core/stereo/stereo_cloud.h"

namespace gripscan {
namespace {

constexpr int kRoundTrips = 10;
/// Pieces of surface further apart than this are not one surface, and not one gripper.
constexpr double kGap_m = 0.008;
constexpr double kFarGap_m = 0.030;
/// Pieces smaller than this are chance matches.
constexpr double kLeastPiece_m2 = 30e-6;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

void ask_robot(RobotLink& robot, CellFacts& facts) {
    LinkFacts link{true, {}, {}};
    for (int i = 0; i < kRoundTrips && link.answers; ++i) {
        const auto start = Clock::now();
        const auto reading = robot.read();
        link.round_trips_s.push_back(seconds_since(start));
        link.answers = reading.has_value();
        if (reading) {
            facts.joints_rad = reading->joints_rad;
        } else {
            link.trouble = reading.error().message;
        }
    }
    const auto state = link.answers ? robot.state() : RobotResult<ControllerState>{};
    if (link.answers && !state) {
        link.answers = false;
        link.trouble = state.error().message;
    }
    if (link.answers) {
        facts.controller = *state;
    } else {
        facts.controller = unknown("the robot does not answer");
        facts.joints_rad = unknown("the robot does not answer");
    }
    facts.link = std::move(link);
}

/// The nearest folder that exists: the session's own may not be there yet.
std::filesystem::path existing(std::filesystem::path folder) {
    std::error_code error;
    folder = std::filesystem::absolute(folder, error);
    while (!std::filesystem::exists(folder, error) && folder.has_relative_path()) {
        folder = folder.parent_path();
    }
    return folder;
}

Fact<DiskFacts> look_at_disk(const CellUnderTest& cell) {
    std::error_code error;
    const auto space = std::filesystem::space(existing(cell.session), error);
    if (error) return unknown(error.message());
    const auto pixels = static_cast<std::uintmax_t>(cell.rig.image.width) *
                        static_cast<std::uintmax_t>(cell.rig.image.height);
    return DiskFacts{space.available, pixels};
}

std::vector<Piece> apart_from_largest(const Cloud& cloud, double gap_m) {
    auto pieces = pieces_of(cloud, gap_m, kLeastPiece_m2);
    if (!pieces.empty()) pieces.erase(pieces.begin());
    return pieces;
}

/// Nothing else is looked at when the region cannot be.
void blind(CellFacts& facts, const std::string& why) {
    facts.image = unknown(why);
    facts.apart = unknown(why);
    facts.far_apart = unknown(why);
    facts.sweep = unknown(why);
}

void look_around(const CellUnderTest& cell, const RectifiedRig& rig, const StereoFrame& rectified,
                 const Progress& progress, const ForEach& for_each, CellFacts& facts) {
    const auto start = Clock::now();
    const auto view = stereo_cloud(rectified, rig, cell.region, {}, progress, for_each);
    if (!view) return blind(facts, view.error().message);
    const StereoHealth& health = view->health;
    facts.image = ImageFacts{health.saturated,    health.mean_intensity, health.texture,
                             health.fill,         view->cloud.size(),    0.0,
                             seconds_since(start)};
    facts.apart = apart_from_largest(view->cloud, kGap_m);
    facts.far_apart = apart_from_largest(view->cloud, kFarGap_m);
    if (!cell.axis) {
        facts.sweep = unknown("the warm-up finds the axis");
        return;
    }
    StereoSettings rough;
    rough.refine = false;
    const auto scene = stereo_cloud(rectified, rig, std::nullopt, rough, progress, for_each);
    if (!scene) {
        facts.sweep = unknown(scene.error().message);
        return;
    }
    facts.sweep = swept_room(view->cloud, scene->cloud, *cell.region, cell.axis->axis);
}

/// Of the whole region, from the picture that `cell` gives of it.
Status look_at_region(const CellUnderTest& cell, const Rectifier& rectifier,
                      const Progress& progress, const ForEach& for_each, CellFacts& facts) {
    const auto start = Clock::now();
    const auto frame = cell.source.grab({-1, 1, 0});
    const double exposure_s = seconds_since(start);
    if (!frame && frame.error().kind == ErrorKind::kDevice) {
        return device_error("the camera gave no picture for the cell check: {}",
                            frame.error().message);
    }
    const auto rectified = frame ? rectifier.rectify(*frame) : frame;
    if (!rectified) {
        blind(facts, rectified.error().message);
        return {};
    }
    look_around(cell, rectifier.rig(), *rectified, progress, for_each, facts);
    if (facts.image) facts.image->exposure_s = exposure_s;
    return {};
}

Status look(const CellUnderTest& cell, const Progress& progress, const ForEach& for_each,
            CellFacts& facts) {
    std::string why;
    if (!cell.region) {
        why = "no registration area is set";
        facts.volume = unknown(why);
    } else if (const auto rectifier = Rectifier::create(cell.rig); !rectifier) {
        why = rectifier.error().message;
    } else {
        facts.volume = region_in_view(*cell.region, rectifier->rig());
        if (facts.volume->margin_px >= 0.0 && facts.volume->can_be_matched) {
            return look_at_region(cell, *rectifier, progress, for_each, facts);
        }
        why = "the cameras do not see the whole region";
    }
    blind(facts, why);
    return {};
}

/// Between the views that are furthest apart in angle.
void compare_warm_up(const CellUnderTest& cell, CellFacts& facts) {
    if (!cell.axis || cell.warm_up.size() < 2) return;
    const WarmUpView& first = cell.warm_up.front();
    const WarmUpView& last = cell.warm_up.back();
    const StillSurface still = still_surface(*first.cloud, *last.cloud, cell.axis->axis,
                                             last.turned_rad - first.turned_rad);
    facts.still = pieces_of(still.beside, kGap_m, kLeastPiece_m2);
    facts.still_at_arm = pieces_of(still.at_arm, kGap_m, kLeastPiece_m2);
}

/// Joint 5 is in the wrist's centre, and is the nearest joint that does not turn with the gripper.
void measure_wrist(const CellUnderTest& cell, CellFacts& facts) {
    if (!cell.T_robot_camera || !cell.region || !facts.joints_rad) return;
    const Eigen::Vector3d wrist_m =
        cell.T_robot_camera->inverse() * link_poses(*facts.joints_rad)[5].translation();
    const Eigen::Vector3d nearest_m =
        wrist_m.cwiseMax(cell.region->min_m).cwiseMin(cell.region->max_m);
    facts.wrist_distance_m = (wrist_m - nearest_m).norm();
}

}  // namespace

Result<CellFacts> measure_cell(const CellUnderTest& cell, const Progress& progress,
                               const ForEach& for_each) {
    CellFacts facts;
    if (cell.robot != nullptr) {
        ask_robot(*cell.robot, facts);
    } else {
        facts.link = unknown("no robot is read");
        facts.controller = unknown("no robot is read");
        facts.joints_rad = unknown("no robot is read");
    }
    if (Status seen = look(cell, progress, for_each, facts); !seen) {
        return forward_error(seen.error());
    }
    compare_warm_up(cell, facts);
    measure_wrist(cell, facts);
    facts.disk = look_at_disk(cell);
    if (facts.image) {
        facts.time = TimeFacts{cell.settle_s, facts.image->exposure_s,
                               cell.compute_s.value_or(facts.image->stereo_s)};
    }
    return facts;
}

}  // namespace gripscan
