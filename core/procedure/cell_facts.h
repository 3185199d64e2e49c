// What was measured of a cell before a turn, as plain numbers; each is known, or it is known why it
// is not. Lengths in m, angles in rad.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/robot/robot_link.h"

namespace gripscan {

/// A measurement, or why there is none, as the end of "not measured: …".
template <typename T>
using Fact = tl::expected<T, std::string>;
[[nodiscard]] inline tl::unexpected<std::string> unknown(std::string why) {
    return tl::unexpected<std::string>(std::move(why));
}

struct LinkFacts {
    bool answers = false;
    std::string trouble;                ///< where it does not answer
    std::vector<double> round_trips_s;  ///< of POS
};

/// The region in the two images and in disparities.
struct VolumeFacts {
    double margin_px = 0.0;  ///< of the corner nearest a border; negative: outside
    std::string nearest;     ///< which corner, in which image
    double far_m = 0.0;
    double far_disparity_px = 0.0;
    bool can_be_matched = false;  ///< disparities are positive and within the matcher's range
    double far_sd_m = 0.0;        ///< of depth
};

/// The image of the region, and what stereo made of it.
struct ImageFacts {
    double saturated = 0.0;  ///< share
    double brightness = 0.0;
    double contrast = 0.0;
    double fill = 0.0;
    std::size_t points = 0;
    double exposure_s = 0.0;  ///< how long an exposure took
    double stereo_s = 0.0;    ///< how long its cloud took
};

/// Connected surface.
struct Piece {
    Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();  ///< camera frame
    double area_m2 = 0.0;

    friend bool operator==(const Piece& a, const Piece& b) {
        return a.centre_m == b.centre_m && a.area_m2 == b.area_m2;
    }
};

/// Room around the turning gripper.
struct SweepFacts {
    double gripper_radius_m = 0.0;  ///< of its farthest point from the axis, as far as it is seen
    double free_radius_m = 0.0;     ///< to the nearest thing that stands still; 10: none is seen
};

struct DiskFacts {
    std::uintmax_t free_bytes = 0;
    std::uintmax_t image_bytes = 0;  ///< of one image as it comes from the camera
};

/// What a step takes beside the motion.
struct TimeFacts {
    double settle_s = 0.0;
    double exposure_s = 0.0;
    double compute_s = 0.0;
};

struct CellFacts {
    Fact<LinkFacts> link = unknown("nothing was asked");
    Fact<ControllerState> controller = unknown("nothing was asked");
    Fact<JointAngles> joints_rad = unknown("nothing was asked");
    Fact<VolumeFacts> volume = unknown("nothing was looked at");
    Fact<ImageFacts> image = unknown("nothing was looked at");
    /// What stands apart from the largest piece of surface, the largest first: by a gap that may
    /// be one of the gripper, and by more than a gripper has.
    Fact<std::vector<Piece>> apart = unknown("nothing was looked at");
    Fact<std::vector<Piece>> far_apart = unknown("nothing was looked at");
    /// What stood still while the gripper turned: beside it, and at the arm's side of it.
    Fact<std::vector<Piece>> still = unknown("nothing was turned");
    Fact<std::vector<Piece>> still_at_arm = unknown("nothing was turned");
    Fact<double> wrist_distance_m = unknown("the robot is not aligned to the camera");
    Fact<SweepFacts> sweep = unknown("nothing was turned");
    Fact<DiskFacts> disk = unknown("nothing was asked");
    Fact<TimeFacts> time = unknown("nothing was timed");
};

}  // namespace gripscan
