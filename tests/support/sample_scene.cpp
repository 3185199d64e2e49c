#include "tests/support/sample_scene.h"

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>

#include "core/base/units.h"
#include "core/robot/kinematics.h"
#include "tests/render/synthetic_cell.h"

namespace gripscan::test {
namespace {

constexpr double kStep_rad = 10.0 * kRadPerDeg;

RobotReading reading_at(double turned_rad) {
    RobotReading reading;
    reading.joints_rad = {0.0, 0.2, -0.1, 0.0, -0.9, turned_rad};
    return reading;
}

CaptureRecord capture(int index) {
    CaptureRecord record;
    record.index = index;
    record.commanded_rad = kStep_rad * index;
    record.before = reading_at(kStep_rad * index);
    return record;
}

JudgedStep accepted(int from) {
    JudgedStep step;
    step.row.from = from;
    step.row.to = from + 1;
    step.row.commanded_rad = step.row.robot_rad = step.row.icp_rad = kStep_rad;
    step.row.T = turn_about(scene_axis(), kStep_rad);
    step.row.verdict = Verdict::kAccept;
    return step;
}

/// The part as capture `index` saw it: the sides that look at the camera, turned with the joint.
std::shared_ptr<const Cloud> view_of(const std::vector<ui::PointChunk>& sides, int index) {
    auto cloud = std::make_shared<Cloud>();
    const int count = static_cast<int>(sides.size());
    for (int by = -6; by <= 6; ++by) {
        const auto side =
            static_cast<std::size_t>((count - index + by + count / 2 + count) % count);
        const Cloud& part = *sides[side].cloud;
        cloud->points.insert(cloud->points.end(), part.points.begin(), part.points.end());
        cloud->normals.insert(cloud->normals.end(), part.normals.begin(), part.normals.end());
        cloud->intensity.insert(cloud->intensity.end(), part.intensity.begin(),
                                part.intensity.end());
        cloud->sigma.insert(cloud->sigma.end(), part.sigma.begin(), part.sigma.end());
    }
    return std::make_shared<Cloud>(
        transformed(*cloud, turn_about(scene_axis(), kStep_rad * index)));
}

RectifiedRig rig() {
    RectifiedRig rig;
    rig.image = {320, 240};
    rig.f_px = 350.0;
    rig.cx_left_px = rig.cx_right_px = 160.0;
    rig.cy_px = 120.0;
    rig.baseline_m = 0.12;
    return rig;
}

/// FANUC's world as the camera sees it: the flange's axis through the part, behind it.
Pose alignment(const RobotReading& reading) {
    Pose T_camera_tool = Pose::Identity();
    T_camera_tool.linear() << 0, 0, -1, 0, 1, 0, 1, 0, 0;
    T_camera_tool.translation() = Eigen::Vector3d(0.17, 0.0, 0.7);
    return tool_pose(reading.joints_rad) * T_camera_tool.inverse();
}

void add_cell(ui::Snapshot& snapshot) {
    snapshot.cell.rig = rig();
    snapshot.cell.region = Box{{-0.11, -0.1, 0.6}, {0.11, 0.1, 0.8}};
    snapshot.cell.axis = scene_axis();
    snapshot.cell.axis_sd_rad = 0.02 * kRadPerDeg;
    snapshot.cell.T_robot_camera = alignment(reading_at(0.0));
}

void add_captures(SampleScene& scene, int steps, std::size_t points) {
    const auto sides = synthetic_part(points, kSceneViews);
    for (int i = 0; i <= steps; ++i) {
        scene.state->data.captures.push_back(capture(i));
        if (i > 0) scene.state->judged[{i - 1, i}] = accepted(i - 1);
        ui::ShownCapture shown;
        shown.index = i;
        shown.cloud = view_of(sides, i);
        scene.snapshot.captures.push_back(std::move(shown));
    }
    scene.state->data.step_rad = kStep_rad;
    scene.state->phase = phase::Idle{};
    scene.state->reading = reading_at(kStep_rad * steps);
}

}  // namespace

Axis scene_axis() {
    return {{0.0, 0.0, 0.7}, Eigen::Vector3d::UnitX()};
}

SampleScene empty_scene() {
    SampleScene scene;
    scene.snapshot.page = ui::Page::kProcedure;
    scene.snapshot.session = ui::SessionFacts{"/s", "valve-T20", "simulated cell", false, {}};
    scene.snapshot.procedure = scene.state.get();
    return scene;
}

SampleScene growing_scene(int steps, std::size_t points) {
    SampleScene scene = empty_scene();
    add_cell(scene.snapshot);
    add_captures(scene, steps, points);
    return scene;
}

SampleScene rejected_scene(int steps, double error_rad, std::size_t points) {
    SampleScene scene = growing_scene(steps, points);
    TurnStep& row = scene.state->judged[{steps - 1, steps}].row;
    row.icp_rad = kStep_rad + error_rad;
    row.T = turn_about(scene_axis(), *row.icp_rad);
    row.verdict = Verdict::kReject;
    return scene;
}

SampleScene template_scene(std::size_t points) {
    SampleScene scene = growing_scene(kSceneViews, 3000);
    scene.snapshot.page = ui::Page::kTemplate;
    auto solved = std::make_shared<ComputedTurn>();
    solved->report.merged = *synthetic_part(points, 1)[0].cloud;
    for (int i = 0; i <= kSceneViews; ++i) {
        solved->report.poses.emplace_back(turn_about(scene_axis(), -kStep_rad * i));
    }
    scene.snapshot.solved = solved;
    scene.snapshot.filter.min_seen = 4;
    return scene;
}

std::shared_ptr<const ui::StereoPicture> sample_picture() {
    auto picture = std::make_shared<ui::StereoPicture>();
    picture->left = cv::Mat(240, 320, CV_8U);
    picture->right = cv::Mat(240, 320, CV_8U);
    picture->disparity = cv::Mat(240, 320, CV_32F, std::numeric_limits<float>::infinity());
    for (int y = 0; y < 240; ++y) {
        for (int x = 0; x < 320; ++x) {
            const double level = 120 + 50 * std::sin(0.21 * x) * std::sin(0.17 * y);
            picture->left.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(level);
            picture->right.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(0.95 * level);
            const bool part = std::hypot(x - 160.0, y - 120.0) < 70.0;
            if (part)
                picture->disparity.at<float>(y, x) = 54.0F + 0.12F * static_cast<float>(x - 90);
        }
    }
    StereoHealth health;
    health.fill = 0.93;
    health.mean_intensity = 121.0;
    health.saturated = 0.002;
    health.row_error_px = 0.08;
    picture->left_health = health;
    health.mean_intensity = 115.0;
    health.saturated = 0.003;
    picture->right_health = health;
    return picture;
}

}  // namespace gripscan::test
