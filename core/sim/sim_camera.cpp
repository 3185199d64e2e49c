#include "core/sim/sim_camera.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

#include "core/base/seeded_random.h"
#include "core/sim/glare.h"
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
    const std::uint64_t kept = by_eye.next();
    if (request.exposure == 0) return kept;
    return SeededRandom(kept + static_cast<std::uint64_t>(request.exposure)).next();
}

/// Nothing but joint 6, and what turns with it, stands elsewhere.
bool differ_by_turn_only(const Moment& a, const Moment& b) {
    return std::equal(a.true_rad.begin(), a.true_rad.end() - 1, b.true_rad.begin()) &&
           a.T_camera_moved.matrix() == b.T_camera_moved.matrix() && a.intruder == b.intruder &&
           a.tool == b.tool && a.surroundings_shift_m == b.surroundings_shift_m;
}

bool same_picture(const Moment& a, const Moment& b) {
    return differ_by_turn_only(a, b) && a.true_rad == b.true_rad &&
           a.T_tool_part.matrix() == b.T_tool_part.matrix() &&
           a.T_part_object.matrix() == b.T_part_object.matrix();
}

}  // namespace

Result<std::unique_ptr<SimCamera>> SimCamera::create(const CellLayout& layout,
                                                     const SceneModel& model, const Box& region,
                                                     const CameraSettings& settings, Look look,
                                                     ForEach for_each) {
    auto solids = RayScene::create(model);
    if (!solids) return forward_error(solids.error());
    auto swept = RayScene::create(swept_scene(model, settings.slack_m));
    if (!swept) return forward_error(swept.error());
    auto scenes = std::make_unique<Scenes>(Scenes{std::move(*solids), std::move(*swept)});
    return std::unique_ptr<SimCamera>(new SimCamera(
        layout, model, region, settings, std::move(look), std::move(for_each), std::move(scenes)));
}

SimCamera::SimCamera(const CellLayout& layout, const SceneModel& model, const Box& region,
                     const CameraSettings& settings, Look look, ForEach for_each,
                     std::unique_ptr<Scenes> scenes)
    : T_world_camera_(layout.T_world_camera),
      settings_(settings),
      look_(std::move(look)),
      for_each_(std::move(for_each)),
      scenes_(std::move(scenes)),
      shader_(model, make_lighting(layout.T_world_camera, layout.light_seed), scenes_->solids,
              scenes_->swept),
      eyes_{Eye{Lens(layout.rig.K_left, layout.rig.D_left, layout.rig.image), {}, {}, {}},
            Eye{Lens(layout.rig.K_right, layout.rig.D_right, layout.rig.image), {}, {}, {}}} {
    const std::array<Pose, 2> T_world_eye = {layout.T_world_left(), layout.T_world_right()};
    for (std::size_t i = 0; i < eyes_.size(); ++i) {
        eyes_[i].T_world_eye = T_world_eye[i];
        Viewpoint& view = eyes_[i].view;
        view.lens = &eyes_[i].lens;
        view.dense =
            image_of(region, T_world_eye[i].inverse() * layout.T_world_camera, eyes_[i].lens);
        view.jitter_seed = settings.noise_seed + i;
    }
}

Result<StereoFrame> SimCamera::grab(const FrameRequest& request) {
    const Moment moment = look_(request);
    render(moment);
    StereoFrame frame;
    frame.left = expose(0, moment, request);
    frame.right = expose(1, moment, request);
    frame.t_s = kPeriod_s * exposures_++;
    // Exposures that are only compared leave no trace.
    if (request.exposure == 0 && request.capture >= 0) grabbed_[request.capture] = moment;
    return frame;
}

void SimCamera::render(const Moment& moment) {
    if (rendered_ && same_picture(*rendered_, moment)) return;
    scenes_->solids.place(body_poses(moment));
    scenes_->swept.place(body_poses(moment.true_rad));
    const bool only_turned = rendered_ && differ_by_turn_only(*rendered_, moment);
    for (Eye& eye : eyes_) {
        if (only_turned) {
            render_live(shader_, eye.view, eye.picture, for_each_);
            continue;
        }
        eye.view.T_world_camera = T_world_eye(eye, moment);
        eye.picture = render_all(shader_, eye.view, for_each_);
    }
    rendered_ = moment;
}

/// The original pose to the last bit for a camera that was not moved.
Pose SimCamera::T_world_eye(const Eye& eye, const Moment& moment) const {
    if (moment.T_camera_moved.matrix() == Pose::Identity().matrix()) return eye.T_world_eye;
    return T_world_camera_ * moment.T_camera_moved * T_world_camera_.inverse() * eye.T_world_eye;
}

cv::Mat SimCamera::expose(std::size_t eye, const Moment& moment,
                          const FrameRequest& request) const {
    SensorSettings sensor = settings_.sensor;
    if (moment.defocus_px > 0.0) sensor.blur_px = std::hypot(sensor.blur_px, moment.defocus_px);
    cv::Mat brightness = eyes_[eye].picture.brightness;
    if (moment.glare_px > 0.0) {
        brightness = brightness.clone();
        add_glare(brightness, glare_px(eye, moment), moment.glare_px);
    }
    return sensor_image(brightness, sensor, noise_seed(settings_.noise_seed, request, eye),
                        for_each_);
}

/// Where the middle of the gripper is seen: mirrors show their lamps to both eyes elsewhere, by
/// less than the spot is wide.
cv::Point2d SimCamera::glare_px(std::size_t eye, const Moment& moment) const {
    const Pose T_eye_world = T_world_eye(eyes_[eye], moment).inverse();
    const Eigen::Vector3d middle_m =
        body_poses(moment.true_rad)[SceneModel::kTool] * Eigen::Vector3d(0, 0, kGripperCentre_m);
    const Eigen::Vector2d p_px = eyes_[eye].lens.project(T_eye_world * middle_m);
    return {p_px.x(), p_px.y()};
}

}  // namespace gripscan::sim
