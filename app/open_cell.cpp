#include "app/open_cell.h"

#include "core/camera/frame_client.h"
#include "core/robot/gsp_link.h"
#include "core/session/cell_file.h"
#include "core/stereo/rig_file.h"

namespace gripscan::app {
namespace {

/// The simulated cell in this process need not keep a person's pace.
constexpr double kTimeScale = 20.0;

std::unique_ptr<RobotLink> link_to(gsp::GspSettings settings, bool motion_rights) {
    settings.motion_rights = motion_rights;
    return std::make_unique<gsp::GspLink>(std::move(settings));
}

Result<Cell> open_simulated(const CellOptions& options) {
    SimCellSettings settings;
    settings.seed = options.seed;
    if (!options.gripper_model.empty()) settings.gripper = options.gripper_model;
    settings.object = options.object;
    settings.faults = options.faults;
    settings.step_deg = options.step_deg;
    settings.with_arm = !options.arm_away;
    settings.other_joints_deg = options.other_joints_deg;
    settings.time_scale = kTimeScale;
    auto sim = SimCell::create(settings);
    if (!sim) return forward_error(sim.error());
    Cell cell;
    cell.simulated = std::make_unique<SimCell>(std::move(*sim));
    cell.camera = &cell.simulated->source();
    gsp::GspSettings link;
    link.motion_port = cell.simulated->motion_port();
    link.monitor_port = cell.simulated->monitor_port();
    cell.robot = link_to(std::move(link), !options.manual);
    cell.rig = cell.simulated->rig();
    cell.region = cell.simulated->region();
    cell.axis_hint = cell.simulated->axis_hint();
    cell.T_robot_camera = cell.simulated->T_robot_camera();
    cell.speed_percent = options.speed_percent.value_or(10.0);
    cell.settle_s = 0.3 / kTimeScale;
    return cell;
}

Result<std::unique_ptr<RobotLink>> open_robot(const CellFile& file, const CellOptions& options) {
    if (!file.robot) {
        if (options.manual) return std::unique_ptr<RobotLink>();
        return input_error("{} names no robot; without one only --manual works", options.cell);
    }
    if (file.robot->dialect != "gsp1") {
        return input_error("{}: the robot dialect '{}' is not known; known is gsp1", options.cell,
                           file.robot->dialect);
    }
    gsp::GspSettings link;
    link.host = file.robot->host;
    link.motion_port = static_cast<std::uint16_t>(file.robot->port);
    link.monitor_port = static_cast<std::uint16_t>(file.robot->monitor_port);
    link.model.clear();
    return link_to(std::move(link), !options.manual);
}

Result<Cell> open_real(const CellOptions& options, const std::stop_token& stop,
                       const std::function<void(const std::string&)>& tell) {
    const auto file = load_cell_file(options.cell);
    if (!file) return forward_error(file.error());
    if (!file->camera) return input_error("{} names no camera", options.cell);
    Cell cell;
    auto robot = open_robot(*file, options);
    if (!robot) return forward_error(robot.error());
    cell.robot = std::move(*robot);
    if (file->rig.empty()) return input_error("{} names no rig", options.cell);
    auto rig = load_rig(file->rig);
    if (!rig) return forward_error(rig.error());
    cell.rig = std::move(*rig);
    FrameClientSettings frames;
    frames.host = file->camera->host;
    frames.port = static_cast<std::uint16_t>(file->camera->port);
    frames.tell = tell;
    auto camera = FrameClient::connect(frames, stop);
    if (!camera) return forward_error(camera.error());
    cell.own_camera = std::move(*camera);
    cell.camera = cell.own_camera.get();
    cell.region = file->region;
    cell.axis_hint = file->axis_hint;
    cell.T_robot_camera = file->T_robot_camera;
    cell.limits = file->limits;
    const double file_speed = file->robot ? file->robot->speed_percent : 10.0;
    cell.speed_percent = options.speed_percent.value_or(file_speed);
    cell.settle_s = file->robot ? file->robot->settle_s : 0.3;
    return cell;
}

}  // namespace

Result<Cell> open_cell(const CellOptions& options, const std::stop_token& stop,
                       const std::function<void(const std::string&)>& tell) {
    if (Status sensible = check(options); !sensible) return forward_error(sensible.error());
    return options.simulated() ? open_simulated(options) : open_real(options, stop, tell);
}

}  // namespace gripscan::app
