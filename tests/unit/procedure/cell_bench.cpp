#include "tests/unit/procedure/cell_bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "core/base/units.h"
#include "core/sim/sim_cell.h"
#include "core/stereo/rectifier.h"
#include "core/stereo/stereo_cloud.h"

namespace gripscan::test {
namespace {

constexpr int kShots = 3;
constexpr double kShot_rad = 4.0 * kRadPerDeg;

sim::CellLayout half_size(std::uint64_t seed) {
    sim::CellLayout layout = sim::make_layout(seed);
    StereoRig& rig = layout.rig;
    rig.image = {rig.image.width / 2, rig.image.height / 2};
    for (Eigen::Matrix3d* K : {&rig.K_left, &rig.K_right}) {
        K->topRows<2>() /= 2.0;
        (*K)(0, 2) -= 0.25;  // pixel centres are whole numbers
        (*K)(1, 2) -= 0.25;
    }
    return layout;
}

sim::SceneModel default_scene(const sim::CellLayout& layout, std::uint64_t seed) {
    sim::SceneContents contents;
    contents.gripper = "two-finger";
    contents.seed = seed;
    contents.texture_contrast = kSimTextureLevels / sim::kGripperLevel;
    contents.gripper_centre_m = sim::body_poses(layout.joints_rad)[sim::SceneModel::kTool] *
                                Eigen::Vector3d(0, 0, sim::kGripperCentre_m);
    return sim::make_scene(contents);
}

}  // namespace

CellBench::CellBench(std::uint64_t seed)
    : layout(half_size(seed)), robot(layout.joints_rad), model_(default_scene(layout, seed)) {
    region = sim::registration_area(layout, model_);
    // Half the pixels: twice the error of depth, a quarter of the points.
    limits.depth_sd_mm *= 2.0;
    limits.least_points /= 4.0;
}

void CellBench::put(const Intruder& intruder) {
    sim::Part part{"intruder", sim::chamfered_box(intruder.size_m, 0.001), {}};
    part.material.texture = {.cell_m = 0.008, .octaves = 4, .gain = 0.85, .contrast = 0.15};
    for (Eigen::Vector3d& v : part.mesh.vertices) {
        v = layout.T_world_camera * (intruder.centre_m + v);
    }
    model_.bodies[sim::SceneModel::kSurroundings].parts.push_back(std::move(part));
    camera_.reset();
}

void CellBench::defocus(double blur_px) {
    blur_px_ = blur_px;
    camera_.reset();
}

void CellBench::make_camera() {
    if (camera_) return;
    camera_ = sim::SimCamera::create(
                  layout, model_, region, {{blur_px_, 2.0}, 7},
                  [this](const FrameRequest&) {
                      sim::Moment moment;
                      moment.true_rad = robot.joints_rad;
                      return moment;
                  },
                  pool_.for_each())
                  .value();
}

Cloud CellBench::cloud_of(int shot) {
    const auto rectifier = Rectifier::create(layout.rig).value();
    const auto frame = rectifier.rectify(camera_->grab({-2 - shot, 1, 0}).value()).value();
    return stereo_cloud(frame, rectifier.rig(), region, {}, {}, pool_.for_each()).value().cloud;
}

void CellBench::warm_up(double sense) {
    make_camera();
    const double start_rad = layout.joints_rad[5];
    clouds_.clear();
    views_.clear();
    clouds_.reserve(kShots);
    for (int shot = 0; shot < kShots; ++shot) {
        const auto reading =
            robot.turn_joint6({shot + 1, start_rad + sense * shot * kShot_rad}, {}).value();
        clouds_.push_back(cloud_of(shot));
        views_.push_back({&clouds_.back(), reading.joints_rad[5]});
    }
    if (!robot.turn_joint6({kShots + 1, start_rad}, {})) throw std::logic_error("no way back");
}

StereoFrame CellBench::picture(const FrameRequest& request) {
    make_camera();
    return camera_->grab(request).value();
}

CellReport CellBench::check() {
    make_camera();
    std::optional<AxisEstimate> axis;
    if (!views_.empty()) axis = AxisEstimate{sim::joint6_axis_in_camera(layout), 0.002, 0.0002};
    const CellUnderTest cell{.robot = &robot,
                             .source = *camera_,
                             .rig = layout.rig,
                             .region = region,
                             .session = session,
                             .T_robot_camera = T_robot_camera,
                             .axis = axis,
                             .warm_up = views_,
                             .settle_s = 0.3,
                             .compute_s = {}};
    return assess(measure_cell(cell, {}, pool_.for_each()).value(), plan, limits);
}

std::vector<std::string> failed_items(const CellReport& report) {
    std::vector<std::string> names;
    for (const CellCheckItem& item : report.items) {
        if (item.outcome == CheckOutcome::kFailed) names.push_back(item.name);
    }
    return names;
}

const CellCheckItem& item_of(const CellReport& report, std::string_view name) {
    const auto item = std::find_if(report.items.begin(), report.items.end(),
                                   [&](const CellCheckItem& i) { return i.name == name; });
    if (item == report.items.end()) throw std::out_of_range(std::string(name));
    return *item;
}

std::string text_of(const CellReport& report) {
    std::string text;
    for (const CellCheckItem& item : report.items) {
        text += fmt::format("{:10} {} {:.2f} / {:.2f} {}: {}\n", item.name,
                            static_cast<int>(item.outcome), item.value, item.limit, item.unit,
                            item.sentence);
    }
    return text;
}

}  // namespace gripscan::test
