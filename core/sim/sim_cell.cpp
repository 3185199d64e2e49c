#include "core/sim/sim_cell.h"

#include <fmt/ranges.h>
#include <algorithm>
#include <cmath>

#include "core/concurrency/worker_pool.h"
#include "core/sim/cell_layout.h"
#include "core/sim/grippers.h"
#include "core/sim/objects.h"
#include "core/sim/seeds.h"
#include "core/sim/sim_camera.h"
#include "core/sim/sim_robot.h"
#include "core/sim/truth.h"

namespace gripscan {
namespace {

Status check(const SimCellSettings& settings) {
    const auto known = [](const std::vector<std::string>& names, const std::string& name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    if (!known(sim_grippers(), settings.gripper)) {
        return input_error("simulated cell: no gripper is called '{}'; there are {}",
                           settings.gripper, fmt::join(sim_grippers(), ", "));
    }
    if (!settings.object.empty() && !known(sim_objects(), settings.object)) {
        return input_error("simulated cell: no object is called '{}'; there are {}",
                           settings.object, fmt::join(sim_objects(), ", "));
    }
    const auto in_range = [](double value, double limit) { return value >= 0.0 && value <= limit; };
    if (!in_range(settings.noise_levels, 50.0)) {
        return input_error("simulated cell: noise of {} levels; it must be 0 … 50",
                           settings.noise_levels);
    }
    if (!in_range(settings.blur_px, 20.0)) {
        return input_error("simulated cell: blur of {} px; it must be 0 … 20", settings.blur_px);
    }
    if (!in_range(settings.texture_contrast, 60.0)) {
        return input_error("simulated cell: texture contrast of {} levels; it must be 0 … 60",
                           settings.texture_contrast);
    }
    return {};
}

sim::SceneContents contents_of(const SimCellSettings& settings, const sim::CellLayout& layout) {
    const double levels =
        settings.texture_contrast > 0.0 ? settings.texture_contrast : kSimTextureLevels;
    sim::SceneContents contents;
    contents.gripper = settings.gripper;
    contents.object = settings.object;
    contents.texture_contrast = levels / sim::kGripperLevel;
    contents.seed = settings.seed;
    contents.gripper_centre_m = sim::body_poses(layout.joints_rad)[sim::SceneModel::kTool] *
                                Eigen::Vector3d(0, 0, sim::kGripperCentre_m);
    return contents;
}

}  // namespace

std::vector<std::string> sim_grippers() {
    return sim::gripper_names();
}
std::vector<std::string> sim_objects() {
    return sim::object_names();
}

struct SimCell::Impl {
    sim::CellLayout layout;
    sim::SceneModel model;
    Box region;
    Eigen::Vector3d axis_hint;
    WorkerPool pool{threads_wanted()};
    sim::SimRobot robot;
    std::unique_ptr<sim::SimCamera> camera;

    Impl(const sim::CellLayout& cell_layout, std::uint64_t seed)
        : layout(cell_layout),
          axis_hint(joint6_axis_in_camera(cell_layout).direction),
          robot(cell_layout.joints_rad, sim::seed_for(seed, sim::Use::kRobot)) {}
};

Result<SimCell> SimCell::create(const SimCellSettings& settings) {
    if (Status ok = check(settings); !ok) return forward_error(ok.error());
    auto impl = std::make_unique<Impl>(sim::make_layout(settings.seed), settings.seed);
    sim::SceneContents contents = contents_of(settings, impl->layout);
    impl->model = sim::make_scene(contents);
    impl->region = sim::registration_area(impl->layout, impl->model);
    if (!settings.with_arm) {
        contents.with_arm = false;
        impl->model = sim::make_scene(contents);
    }
    auto camera = sim::SimCamera::create(
        impl->layout, impl->model, impl->region,
        {{settings.blur_px, settings.noise_levels}, sim::seed_for(settings.seed, sim::Use::kNoise)},
        [robot = &impl->robot] { return robot->arm().true_rad; }, impl->pool.for_each());
    if (!camera) return forward_error(camera.error());
    impl->camera = std::move(*camera);
    return SimCell(std::move(impl));
}

SimCell::SimCell(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SimCell::SimCell(SimCell&&) noexcept = default;
SimCell& SimCell::operator=(SimCell&&) noexcept = default;
SimCell::~SimCell() = default;

const StereoRig& SimCell::rig() const {
    return impl_->layout.rig;
}
const Box& SimCell::region() const {
    return impl_->region;
}
const Eigen::Vector3d& SimCell::axis_hint() const {
    return impl_->axis_hint;
}
double SimCell::start_joint6_rad() const {
    return impl_->layout.joints_rad[5];
}
StereoSource& SimCell::source() {
    return *impl_->camera;
}
RobotLink& SimCell::robot() {
    return impl_->robot;
}

Status SimCell::write_truth(const std::filesystem::path& folder) const {
    return sim::write_truth_files(
        {impl_->layout, impl_->model, impl_->region, impl_->camera->grabbed()}, folder,
        impl_->pool.for_each());
}

}  // namespace gripscan
