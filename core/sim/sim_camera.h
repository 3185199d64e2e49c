// The simulated stereo camera: renders the cell as the arm stands at the moment of the grab.
#pragma once

#include <functional>
#include <memory>
#include <optional>

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

/// Not for several threads at once; it uses the loop it is given. What does not change as joint 6
/// turns is rendered once and kept until another joint moves.
class SimCamera : public StereoSource {
  public:
    [[nodiscard]] static Result<std::unique_ptr<SimCamera>> create(
        const CellLayout& layout, const SceneModel& model, const Box& region,
        const CameraSettings& settings, std::function<JointAngles()> true_joints, ForEach for_each);

    [[nodiscard]] Result<StereoFrame> grab(const FrameRequest& request) override;

    [[nodiscard]] const TrueJoints& grabbed() const { return grabbed_; }

  private:
    /// The solids, and the room they need to turn; shared by both eyes, referred to by the shader.
    struct Scenes {
        RayScene solids;
        RayScene swept;
    };
    struct Eye {
        Lens lens;
        Viewpoint view;
        Picture picture;
    };
    SimCamera(const CellLayout& layout, const SceneModel& model, const Box& region,
              const CameraSettings& settings, std::function<JointAngles()> true_joints,
              ForEach for_each, std::unique_ptr<Scenes> scenes);
    void render(const JointAngles& joints_rad);
    [[nodiscard]] cv::Mat expose(std::size_t eye, const FrameRequest& request) const;

    CameraSettings settings_;
    std::function<JointAngles()> true_joints_;
    ForEach for_each_;
    std::unique_ptr<Scenes> scenes_;
    Shader shader_;
    std::array<Eye, 2> eyes_;
    std::optional<JointAngles> rendered_rad_;  ///< where the arm stood in the eyes' pictures
    TrueJoints grabbed_;
    int exposures_ = 0;
};

}  // namespace gripscan::sim
