#include "core/sim/sim_camera.h"

#include <algorithm>
#include <opencv2/core.hpp>

#include "core/base/seeded_random.h"
#include "core/sim/swept_volume.h"

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
    auto solids = RayScene::create(model);
    if (!solids) return forward_error(solids.error());
    auto swept = RayScene::create(swept_scene(model));
    if (!swept) return forward_error(swept.error());
    auto scenes = std::make_unique<Scenes>(Scenes{std::move(*solids), std::move(*swept)});
    return std::unique_ptr<SimCamera>(new SimCamera(layout, model, region, settings,
                                                    std::move(true_joints), std::move(for_each),
                                                    std::move(scenes)));
}

SimCamera::SimCamera(const CellLayout& layout, const SceneModel& model, const Box& region,
                     const CameraSettings& settings, std::function<JointAngles()> true_joints,
                     ForEach for_each, std::unique_ptr<Scenes> scenes)
    : settings_(settings),
      true_joints_(std::move(true_joints)),
      for_each_(std::move(for_each)),
      scenes_(std::move(scenes)),
      shader_(model, make_lighting(layout.T_world_camera, layout.light_seed), scenes_->solids,
              scenes_->swept),
      eyes_{Eye{Lens(layout.rig.K_left, layout.rig.D_left, layout.rig.image), {}, {}},
            Eye{Lens(layout.rig.K_right, layout.rig.D_right, layout.rig.image), {}, {}}} {
    const std::array<Pose, 2> T_world_eye = {layout.T_world_left(), layout.T_world_right()};
    for (std::size_t i = 0; i < eyes_.size(); ++i) {
        Viewpoint& view = eyes_[i].view;
        view.lens = &eyes_[i].lens;
        view.T_world_camera = T_world_eye[i];
        view.dense =
            image_of(region, T_world_eye[i].inverse() * layout.T_world_camera, eyes_[i].lens);
        view.jitter_seed = settings.noise_seed + i;
    }
}

Result<StereoFrame> SimCamera::grab(const FrameRequest& request) {
    const JointAngles joints_rad = true_joints_();
    render(joints_rad);
    StereoFrame frame;
    frame.left = expose(0, request);
    frame.right = expose(1, request);
    frame.t_s = kPeriod_s * exposures_++;
    grabbed_[request.capture] = joints_rad;
    return frame;
}

void SimCamera::render(const JointAngles& joints_rad) {
    if (rendered_rad_ == joints_rad) return;
    const auto T_world_body = body_poses(joints_rad);
    scenes_->solids.place(T_world_body);
    scenes_->swept.place(T_world_body);
    const bool only_joint6_moved =
        rendered_rad_ &&
        std::equal(joints_rad.begin(), joints_rad.end() - 1, rendered_rad_->begin());
    for (Eye& eye : eyes_) {
        if (only_joint6_moved) {
            render_live(shader_, eye.view, eye.picture, for_each_);
        } else {
            eye.picture = render_all(shader_, eye.view, for_each_);
        }
    }
    rendered_rad_ = joints_rad;
}

cv::Mat SimCamera::expose(std::size_t eye, const FrameRequest& request) const {
    return sensor_image(eyes_[eye].picture.brightness, settings_.sensor,
                        noise_seed(settings_.noise_seed, request, eye), for_each_);
}

}  // namespace gripscan::sim
