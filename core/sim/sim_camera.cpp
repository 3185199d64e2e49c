#include "core/sim/sim_camera.h"

#include <opencv2/core.hpp>

#include "core/base/seeded_random.h"

namespace gripscan::sim {
namespace {

constexpr double kPeriod_s = 0.5;  ///< between exposures, by the simulated clock

/// The rectangle of the image in which a box of the camera frame is seen, and some pixels around.
cv::Rect image_of(const Box& box, const Pose& T_eye_camera, const Lens& lens) {
    constexpr int kBorder_px = 12;
    cv::Rect rect;
    for (const Eigen::Vector3d& corner : box.corners()) {
        const Eigen::Vector2d p = lens.project(T_eye_camera * corner);
        const cv::Rect pixel(static_cast<int>(p.x()) - kBorder_px,
                             static_cast<int>(p.y()) - kBorder_px, 2 * kBorder_px, 2 * kBorder_px);
        rect = rect.empty() ? pixel : (rect | pixel);
    }
    return rect & cv::Rect(0, 0, lens.image().width, lens.image().height);
}

std::uint64_t noise_seed(std::uint64_t seed, const FrameRequest& request, std::size_t eye) {
    SeededRandom by_capture(seed + static_cast<std::uint64_t>(request.capture));
    SeededRandom by_attempt(by_capture.next() + static_cast<std::uint64_t>(request.attempt));
    SeededRandom by_eye(by_attempt.next() + eye);
    return by_eye.next();
}

}  // namespace

Result<std::unique_ptr<SimCamera>> SimCamera::create(const CellLayout& layout,
                                                     const SceneModel& model, const Box& region,
                                                     const CameraSettings& settings,
                                                     std::function<JointAngles()> true_joints,
                                                     ForEach for_each) {
    auto scene = RayScene::create(model);
    if (!scene) return forward_error(scene.error());
    return std::unique_ptr<SimCamera>(new SimCamera(layout, model, region, settings,
                                                    std::move(true_joints), std::move(for_each),
                                                    std::move(*scene)));
}

SimCamera::SimCamera(const CellLayout& layout, const SceneModel& model, const Box& region,
                     const CameraSettings& settings, std::function<JointAngles()> true_joints,
                     ForEach for_each, RayScene scene)
    : settings_(settings),
      true_joints_(std::move(true_joints)),
      for_each_(std::move(for_each)),
      scene_(std::make_unique<RayScene>(std::move(scene))),
      shader_(model, make_lighting(layout.T_world_camera, layout.light_seed), *scene_),
      eyes_{Eye{Lens(layout.rig.K_left, layout.rig.D_left, layout.rig.image),
                layout.T_world_left(),
                {}},
            Eye{Lens(layout.rig.K_right, layout.rig.D_right, layout.rig.image),
                layout.T_world_right(),
                {}}} {
    for (Eye& eye : eyes_) {
        eye.dense = image_of(region, eye.T_world_eye.inverse() * layout.T_world_camera, eye.lens);
    }
}

Result<StereoFrame> SimCamera::grab(const FrameRequest& request) {
    const JointAngles joints_rad = true_joints_();
    scene_->place(body_poses(joints_rad));
    StereoFrame frame;
    frame.left = expose(0, request);
    frame.right = expose(1, request);
    frame.t_s = kPeriod_s * exposures_++;
    grabbed_[request.capture] = joints_rad;
    return frame;
}

cv::Mat SimCamera::expose(std::size_t eye, const FrameRequest& request) const {
    const Viewpoint view{&eyes_[eye].lens, eyes_[eye].T_world_eye, settings_.noise_seed + eye};
    const cv::Mat brightness = render(shader_, view, {.dense = eyes_[eye].dense}, for_each_);
    return sensor_image(brightness, settings_.sensor,
                        noise_seed(settings_.noise_seed, request, eye), for_each_);
}

}  // namespace gripscan::sim
