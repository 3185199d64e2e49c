// The simulated cell as the cell check meets it, with things in it that should not be there. Its
// camera has half the pixels a side of the default one, for speed.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/concurrency/worker_pool.h"
#include "core/procedure/cell_check.h"
#include "core/procedure/measure_cell.h"
#include "core/robot/kinematics.h"
#include "core/sim/cell_layout.h"
#include "core/sim/sim_camera.h"

namespace gripscan::test {

/// A block in the room, in the camera frame.
struct Intruder {
    Eigen::Vector3d size_m = Eigen::Vector3d::Zero();
    Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
};

/// An arm that stands exactly where it is told, and whose controller can be in any state.
class BenchRobot : public RobotLink {
  public:
    explicit BenchRobot(const JointAngles& at_rad) : joints_rad(at_rad) {
        controller.automatic = controller.servo_on = true;
        controller.override_percent = 100;
    }
    RobotResult<RobotIdentity> connect() override { return RobotIdentity{"bench", 6, "none"}; }
    void disconnect() override {}
    RobotResult<ControllerState> state() override { return controller; }
    RobotResult<RobotReading> read() override {
        return RobotReading{joints_rad, tool_pose(joints_rad)};
    }
    RobotResult<RobotReading> turn_joint6(const Joint6Command& command, std::stop_token) override {
        joints_rad[5] = command.angle_rad;
        return read();
    }
    RobotResult<void> stop() override { return {}; }
    void on_beat(std::function<void(const RobotBeat&)>) override {}

    JointAngles joints_rad;
    ControllerState controller;
};

class CellBench {
  public:
    explicit CellBench(std::uint64_t seed);

    void put(const Intruder& intruder);
    void defocus(double blur_px);
    /// Three pictures 4° apart, as the procedure takes them; the arm returns to the start. Sense
    /// -1: the gripper turns downwards, as with a joint that turns the other way than it is told.
    void warm_up(double sense = 1.0);
    [[nodiscard]] StereoFrame picture(const FrameRequest& request);
    [[nodiscard]] CellReport check();

    sim::CellLayout layout;
    Box region;
    BenchRobot robot;
    std::filesystem::path session = std::filesystem::temp_directory_path() / "not" / "yet";
    std::optional<Pose> T_robot_camera;
    TurnPlan plan;
    CellLimits limits;

  private:
    void make_camera();
    [[nodiscard]] Cloud cloud_of(int shot);

    sim::SceneModel model_;
    double blur_px_ = 0.6;
    WorkerPool pool_{threads_wanted()};
    std::unique_ptr<sim::SimCamera> camera_;
    std::vector<Cloud> clouds_;
    std::vector<WarmUpView> views_;
};

[[nodiscard]] std::vector<std::string> failed_items(const CellReport& report);
[[nodiscard]] const CellCheckItem& item_of(const CellReport& report, std::string_view name);
[[nodiscard]] std::string text_of(const CellReport& report);

}  // namespace gripscan::test
