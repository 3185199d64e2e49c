// The simulated stereo camera: renders the cell as the arm stands at the moment of the grab.
#pragma once

#include <functional>
#include <memory>

#include "core/camera/stereo_source.h"
#include "core/sim/cell_layout.h"
#include "core/sim/renderer.h"
#include "core/sim/sensor_image.h"
#include "core/sim/truth.h"

namespace gripscan::sim {

/// Brightness of the gripper's body in the default light, levels: what a contrast in levels is
/// measured against.
inline constexpr double kGripperLevel = 105.0;

struct CameraSettings {
    SensorSettings sensor;
    std::uint64_t noise_seed = 0;
};

/// Not for several threads at once; it uses the loop it is given.
class SimCamera : public StereoSource {
  public:
    [[nodiscard]] static Result<std::unique_ptr<SimCamera>> create(
        const CellLayout& layout, const SceneModel& model, const Box& region,
        const CameraSettings& settings, std::function<JointAngles()> true_joints, ForEach for_each);

    [[nodiscard]] Result<StereoFrame> grab(const FrameRequest& request) override;

    [[nodiscard]] const TrueJoints& grabbed() const { return grabbed_; }

  private:
    struct Eye {
        Lens lens;
        Pose T_world_eye;
        cv::Rect dense;  ///< where the registration area is seen
    };
    SimCamera(const CellLayout& layout, const SceneModel& model, const Box& region,
              const CameraSettings& settings, std::function<JointAngles()> true_joints,
              ForEach for_each, RayScene scene);
    [[nodiscard]] cv::Mat expose(std::size_t eye, const FrameRequest& request) const;

    CameraSettings settings_;
    std::function<JointAngles()> true_joints_;
    ForEach for_each_;
    std::unique_ptr<RayScene> scene_;
    Shader shader_;
    std::array<Eye, 2> eyes_;
    TrueJoints grabbed_;
    int exposures_ = 0;
};

}  // namespace gripscan::sim
