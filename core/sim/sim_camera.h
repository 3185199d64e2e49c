// The simulated stereo camera: renders the cell as it stands at the moment of the grab.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "core/camera/stereo_source.h"
#include "core/sim/cell_layout.h"
#include "core/sim/moment.h"
#include "core/sim/renderer.h"
#include "core/sim/sensor_image.h"

namespace gripscan::sim {

/// Brightness of the gripper's body in the default light, levels: what a contrast in levels is
/// measured against.
inline constexpr double kGripperLevel = 105.0;

struct CameraSettings {
    SensorSettings sensor;
    std::uint64_t noise_seed = 0;
    double slack_m = 0.0;  ///< by which faults may move what is mounted on the flange
};

/// Not for several threads at once; it uses the loop it is given. What does not change as joint 6
/// turns is rendered once and kept until something else moves.
class SimCamera : public StereoSource {
  public:
    /// How the cell stands now, asked once a grab.
    using Look = std::function<Moment(const FrameRequest&)>;

    [[nodiscard]] static Result<std::unique_ptr<SimCamera>> create(const CellLayout& layout,
                                                                   const SceneModel& model,
                                                                   const Box& region,
                                                                   const CameraSettings& settings,
                                                                   Look look, ForEach for_each);

    /// The noise belongs to the request: the same one again gives the same images.
    [[nodiscard]] Result<StereoFrame> grab(const FrameRequest& request) override;

    [[nodiscard]] const Moments& grabbed() const { return grabbed_; }

  private:
    /// The solids, and the room they need to turn; shared by both eyes, referred to by the shader.
    struct Scenes {
        RayScene solids;
        RayScene swept;
    };
    struct Eye {
        Lens lens;
        Pose T_world_eye;  ///< at the start
        Viewpoint view;
        Picture picture;
    };
    SimCamera(const CellLayout& layout, const SceneModel& model, const Box& region,
              const CameraSettings& settings, Look look, ForEach for_each,
              std::unique_ptr<Scenes> scenes);
    void render(const Moment& moment);
    [[nodiscard]] Pose T_world_eye(const Eye& eye, const Moment& moment) const;
    [[nodiscard]] cv::Mat expose(std::size_t eye, const Moment& moment,
                                 const FrameRequest& request) const;
    [[nodiscard]] cv::Point2d glare_px(std::size_t eye, const Moment& moment) const;

    Pose T_world_camera_;  ///< at the start
    CameraSettings settings_;
    Look look_;
    ForEach for_each_;
    std::unique_ptr<Scenes> scenes_;
    Shader shader_;
    std::array<Eye, 2> eyes_;
    std::optional<Moment> rendered_;  ///< what the eyes' pictures show
    Moments grabbed_;
    int exposures_ = 0;
};

}  // namespace gripscan::sim
