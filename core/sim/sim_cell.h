// The simulated cell: an arm with a gripper in front of a stereo camera. The arm is reached over
// TCP through its controller, as a real one; the camera directly or on a frame port.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/camera/stereo_source.h"
#include "core/geometry/box.h"

namespace gripscan {

namespace sim {
class Cabinet;
}

/// Texture of gripper and object: standard deviation of the surface's brightness before lens and
/// sensor, in levels of 255 where the surface is lit to about 105, such as sand-blasted or speckled
/// metal. Grain from 1.5 mm (2 px at 0.74 m) to 12 mm.
inline constexpr double kSimTextureLevels = 14.0;

struct SimCellSettings {
    std::uint64_t seed = 1;
    std::string gripper = "two-finger";  ///< see sim_grippers()
    std::string object = "";             ///< empty: nothing in the gripper; see sim_objects()
    bool with_arm = true;                ///< false: the arm is out of the picture (environment)
    /// Where joints 1 … 5 stand, deg; none: before the camera, as the registration wants them. The
    /// registration area stays where it is.
    std::optional<std::array<double, 5>> other_joints_deg = {};
    double noise_levels = 2.0;      ///< standard deviation, of 255
    double blur_px = 0.6;           ///< Gaussian sigma
    double texture_contrast = 0.0;  ///< levels; 0: kSimTextureLevels
    unsigned image_fraction = 1;    ///< 4: a quarter of the camera's pixels a side

    std::vector<std::string> faults = {};         ///< NAME[@STEP][=VALUE], see docs/faults.md
    double step_deg = 10.0;                       ///< by which the steps of the faults count
    std::optional<double> start_joint6_deg = {};  ///< where joint 6 stands first; none: -180

    double time_scale = 1.0;             ///< the cell's seconds in one of the clock on the wall
    std::function<double()> clock = {};  ///< the cell's time, s, instead of that; for tests
    std::uint16_t port = 0;              ///< motion; monitor and frames follow; 0: free ones
    bool serve_frames = false;
};

/// Names of the built-in grippers and objects.
[[nodiscard]] std::vector<std::string> sim_grippers();
[[nodiscard]] std::vector<std::string> sim_objects();

/// Everything an estimator may know: the rig, the region, the axis hint; images by `source()` or on
/// the frame port, joints by the controller, which serves from the start to the end of the cell.
/// The truth leaves only through write_truth().
class SimCell {
  public:
    [[nodiscard]] static Result<SimCell> create(const SimCellSettings& settings);
    SimCell(SimCell&&) noexcept;
    SimCell& operator=(SimCell&&) noexcept;
    ~SimCell();

    /// GSP/1 on the loopback address.
    [[nodiscard]] std::uint16_t motion_port() const;
    [[nodiscard]] std::uint16_t monitor_port() const;
    [[nodiscard]] std::optional<std::uint16_t> frames_port() const;

    [[nodiscard]] const StereoRig& rig() const;
    [[nodiscard]] const Box& region() const;
    [[nodiscard]] const Eigen::Vector3d& axis_hint() const;
    /// Where the camera stands in FANUC WORLD, as the calibration of the cell would tell.
    [[nodiscard]] const Pose& T_robot_camera() const;
    /// Joint 6 at which the procedure starts, rad.
    [[nodiscard]] double start_joint6_rad() const;
    /// Renders what the camera sees at that moment; from any thread, one after the other.
    [[nodiscard]] StereoSource& source();
    /// The controller's own side, for what an operator does there: emergency stop, key switch.
    [[nodiscard]] sim::Cabinet& cabinet();
    /// Was a capture grabbed, so that there is a truth to be written?
    [[nodiscard]] bool has_truth() const;
    /// Writes truth.json (axis, rig, poses of the captures grabbed so far, in the camera frame),
    /// surface.ply (the true surface of gripper and object as a mesh) and visible.ply (points of it
    /// inside the region that both cameras have seen in at least one capture grabbed so far), both
    /// in the camera frame of the first capture. Where an object is held, object_surface.ply and
    /// object_visible.ply are the same of the object alone. At least one capture must have been
    /// grabbed.
    [[nodiscard]] Status write_truth(const std::filesystem::path& folder) const;

  private:
    struct Impl;
    explicit SimCell(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace gripscan
