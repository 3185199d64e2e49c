#include "core/sim/sim_cell.h"

#include "core/base/units.h"
#include "core/concurrency/worker_pool.h"
#include "core/robot/joint6_limits.h"
#include "core/robot/kinematics.h"
#include "core/sim/cabinet.h"
#include "core/sim/cell_layout.h"
#include "core/sim/frame_server.h"
#include "core/sim/free_ports.h"
#include "core/sim/guarded_source.h"
#include "core/sim/intruder.h"
#include "core/sim/link_server.h"
#include "core/sim/seeds.h"
#include "core/sim/sim_cell_settings.h"
#include "core/sim/truth.h"

namespace gripscan {
namespace {

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

/// What the robot's and the camera's side have in common, from the same seed every time.
struct Plan {
    sim::CellLayout layout;
    sim::CellLayout at_work;  ///< with the arm as a registration wants it
    std::vector<sim::Fault> faults;
    sim::StepFaults step_faults;
};

Result<Plan> plan_of(const SimCellSettings& settings) {
    auto faults = sim::parse_faults(settings.faults);
    if (!faults) return forward_error(faults.error());
    Plan plan{
        sim::make_layout(settings.seed), sim::make_layout(settings.seed), std::move(*faults), {}};
    plan.layout.rig = sim::shrunk(plan.layout.rig, settings.image_fraction);
    if (settings.other_joints_deg) {
        for (std::size_t i = 0; i < 5; ++i) {
            plan.layout.joints_rad[i] = rad_from_deg((*settings.other_joints_deg)[i]);
        }
        if (Status ok = check_joint_ranges(plan.layout.joints_rad); !ok) {
            return forward_error(ok.error());
        }
    }
    double& joint6_rad = plan.layout.joints_rad[5];
    if (settings.start_joint6_deg) joint6_rad = rad_from_deg(*settings.start_joint6_deg);
    plan.step_faults = sim::StepFaults(plan.faults, joint6_rad, rad_from_deg(settings.step_deg),
                                       sim::seed_for(settings.seed, sim::Use::kFaults));
    return plan;
}

/// What the server of a real controller allows, too (assets/fanuc/gs_conf.kl).
sim::ControllerSettings controller_settings() {
    sim::ControllerSettings settings;
    settings.max_step_deg = kMostTurn_deg;
    settings.max_speed_percent = kMostSpeed_percent;
    return settings;
}

}  // namespace

/// In the order in which they need each other: the servers end first.
struct SimCell::Impl {
    sim::CellLayout layout;
    sim::CellLayout at_work;
    sim::StepFaults faults;
    sim::SceneModel model;
    Box region;
    Eigen::Vector3d axis_hint;
    WorkerPool pool{threads_wanted()};
    sim::Cabinet cabinet;
    std::unique_ptr<sim::SimCamera> camera;
    std::optional<sim::GuardedSource> source;
    std::optional<sim::LinkServer> motion;
    std::optional<sim::LinkServer> monitor;
    std::optional<sim::FrameServer> frames;

    Impl(const Plan& plan, const SimCellSettings& settings)
        : layout(plan.layout),
          at_work(plan.at_work),
          faults(plan.step_faults),
          axis_hint(joint6_axis_in_camera(plan.at_work).direction),
          cabinet(sim::ArmMotion(plan.layout.joints_rad,
                                 sim::seed_for(settings.seed, sim::Use::kRobot), plan.step_faults),
                  controller_settings(), plan.faults,
                  settings.clock ? settings.clock : sim::cell_clock(settings.time_scale)) {}

    Status build_scene(const SimCellSettings& settings);
    Status serve(const SimCellSettings& settings);
    [[nodiscard]] sim::Moment look(const FrameRequest& request) const;
};

Status SimCell::Impl::build_scene(const SimCellSettings& settings) {
    sim::SceneContents contents = contents_of(settings, at_work);
    model = sim::make_scene(contents);
    region = sim::registration_area(at_work, model);
    if (!settings.with_arm) {
        contents.with_arm = false;
        model = sim::make_scene(contents);
    }
    if (const double thickness_m = faults.planned_intruder_m(); thickness_m > 0.0) {
        model.bodies[sim::SceneModel::kIntruder] =
            sim::make_intruder(thickness_m, region, layout.T_world_camera,
                               sim::seed_for(settings.seed, sim::Use::kFaults, 1));
    }
    if (const double length_m = faults.planned_tool_m(); length_m > 0.0) {
        model.bodies[sim::SceneModel::kLeftTool] =
            sim::make_left_tool(length_m, region, layout.T_world_camera,
                                sim::seed_for(settings.seed, sim::Use::kFaults, 2));
    }
    constexpr double kReach_m = 0.25;  // of the longest gripper with the longest object
    const sim::CameraSettings optics{{settings.blur_px, settings.noise_levels},
                                     sim::seed_for(settings.seed, sim::Use::kNoise),
                                     faults.slack_m(kReach_m)};
    auto made = sim::SimCamera::create(
        layout, model, region, optics,
        [this](const FrameRequest& request) { return look(request); }, pool.for_each());
    if (!made) return forward_error(made.error());
    camera = std::move(*made);
    source.emplace(*camera);
    return {};
}

Status SimCell::Impl::serve(const SimCellSettings& settings) {
    auto ports = sim::open_listeners(settings.port, settings.serve_frames ? 3 : 2);
    if (!ports) return forward_error(ports.error());
    motion.emplace(std::move((*ports)[0]), sim::LinkKind::kMotion, cabinet);
    monitor.emplace(std::move((*ports)[1]), sim::LinkKind::kMonitor, cabinet);
    if (settings.serve_frames) {
        frames.emplace(std::move((*ports)[2]), *source,
                       frames::Description{layout.rig, region, axis_hint});
    }
    return {};
}

sim::Moment SimCell::Impl::look(const FrameRequest& request) const {
    const sim::ArmState arm = cabinet.arm();
    sim::Moment moment;
    moment.true_rad = arm.true_rad;
    moment.T_tool_part = faults.T_tool_part(arm.joint6_rad);
    moment.T_part_object =
        model.T_tool_grasp * faults.T_grasp_object(arm.joint6_rad) * model.T_tool_grasp.inverse();
    moment.T_camera_moved = faults.T_camera_moved(arm.joint6_rad);
    moment.intruder = faults.intruder_m(arm.joint6_rad) > 0.0;
    moment.tool = faults.tool_m(arm.joint6_rad) > 0.0;
    moment.surroundings_shift_m = faults.surroundings_shift_m(arm.joint6_rad);
    moment.defocus_px = faults.defocus_px(arm.joint6_rad);
    moment.glare_px = faults.glare_px(arm.joint6_rad, request.attempt);
    return moment;
}

Result<SimCell> SimCell::create(const SimCellSettings& settings) {
    if (Status ok = sim::check(settings); !ok) return forward_error(ok.error());
    const auto plan = plan_of(settings);
    if (!plan) return forward_error(plan.error());
    auto impl = std::make_unique<Impl>(*plan, settings);
    if (Status ok = impl->build_scene(settings); !ok) return forward_error(ok.error());
    if (Status ok = impl->serve(settings); !ok) return forward_error(ok.error());
    return SimCell(std::move(impl));
}

SimCell::SimCell(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SimCell::SimCell(SimCell&&) noexcept = default;
SimCell& SimCell::operator=(SimCell&&) noexcept = default;
SimCell::~SimCell() = default;

std::uint16_t SimCell::motion_port() const {
    return impl_->motion->port();
}
std::uint16_t SimCell::monitor_port() const {
    return impl_->monitor->port();
}
std::optional<std::uint16_t> SimCell::frames_port() const {
    if (!impl_->frames) return std::nullopt;
    return impl_->frames->port();
}
const StereoRig& SimCell::rig() const {
    return impl_->layout.rig;
}
const Box& SimCell::region() const {
    return impl_->region;
}
const Eigen::Vector3d& SimCell::axis_hint() const {
    return impl_->axis_hint;
}
const Pose& SimCell::T_robot_camera() const {
    return impl_->layout.T_world_camera;
}
double SimCell::start_joint6_rad() const {
    return impl_->layout.joints_rad[5];
}
StereoSource& SimCell::source() {
    return *impl_->source;
}
sim::Cabinet& SimCell::cabinet() {
    return impl_->cabinet;
}

bool SimCell::has_truth() const {
    return !impl_->source->grabbed().empty();
}

Status SimCell::write_truth(const std::filesystem::path& folder) const {
    const sim::Moments captures = impl_->source->grabbed();
    return sim::write_truth_files({impl_->layout, impl_->model, impl_->region, captures}, folder,
                                  impl_->pool.for_each());
}

}  // namespace gripscan
