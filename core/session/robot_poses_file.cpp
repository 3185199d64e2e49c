#include "core/session/robot_poses_file.h"

#include <array>
#include <cmath>

#include "core/base/atomic_file.h"
#include "core/base/units.h"
#include "core/robot/kinematics.h"
#include "core/session/yaml_parts.h"

namespace gripscan {
namespace fs = std::filesystem;
namespace {

int whole(StrictYaml& yaml, std::string_view key, double value) {
    if (value >= 1 && value <= 1000 && value == std::floor(value)) return static_cast<int>(value);
    yaml.fail(key, "must hold whole numbers from 1 to 1000");
    return 0;
}

CalibrationBoard read_board(StrictYaml& yaml) {
    auto map = yaml.map("board");
    if (!map) {
        yaml.fail("board",
                  "is missing: {chessboard: [9, 6], square_mm: 25} or {charuco: [7, 5], "
                  "square_mm: 30, marker_mm: 22, dictionary: DICT_5X5_100}");
        return Chessboard{};
    }
    const auto chess = map->numbers("chessboard", 2);
    const auto charuco = map->numbers("charuco", 2);
    const double square_m = map->number("square_mm").value_or(0.0) / kMmPerM;
    const auto marker_mm = map->number("marker_mm");
    const auto dictionary = map->text("dictionary");
    map->reject_other_keys();
    if (chess.has_value() == charuco.has_value()) {
        map->fail("chessboard", "or 'charuco': one of both must be given");
        return Chessboard{};
    }
    if (chess) {
        return Chessboard{whole(*map, "chessboard", (*chess)[0]),
                          whole(*map, "chessboard", (*chess)[1]), square_m};
    }
    return CharucoBoard{whole(*map, "charuco", (*charuco)[0]),
                        whole(*map, "charuco", (*charuco)[1]), square_m,
                        marker_mm.value_or(0.0) / kMmPerM, dictionary.value_or("")};
}

MonoCamera read_camera(StrictYaml& yaml) {
    auto map = yaml.map("camera");
    if (!map) return {};
    MonoCamera camera;
    const std::array<std::pair<const char*, double*>, 4> numbers = {{{"fx", &camera.fx_px},
                                                                     {"fy", &camera.fy_px},
                                                                     {"cx", &camera.cx_px},
                                                                     {"cy", &camera.cy_px}}};
    for (const auto& [key, value] : numbers) {
        const auto number = map->number(key);
        if (!number) map->fail(key, "is missing, px");
        *value = number.value_or(0.0);
    }
    camera.distortion = map->numbers("distortion", 5).value_or(std::vector<double>{});
    map->reject_other_keys();
    return camera;
}

/// One of joints_deg, flange (x y z in mm, w p r in deg), T_robot_flange.
std::optional<Pose> read_flange(StrictYaml& row) {
    const auto joints = row.numbers("joints_deg", 6);
    const auto xyzwpr = row.numbers("flange", 6);
    const auto matrix = read_pose(row, "T_robot_flange");
    if (joints) {
        JointAngles angles{};
        for (std::size_t i = 0; i < 6; ++i) angles[i] = rad_from_deg((*joints)[i]);
        return tool_pose(angles);
    }
    if (xyzwpr) {
        const std::vector<double>& v = *xyzwpr;
        Pose T = Pose::Identity();
        T.linear() =
            rotation_from_euler({rad_from_deg(v[3]), rad_from_deg(v[4]), rad_from_deg(v[5])});
        T.translation() = Eigen::Vector3d(v[0], v[1], v[2]) / kMmPerM;
        return T;
    }
    return matrix;
}

RobotPoseRow read_row(StrictYaml& row, const fs::path& folder, bool stereo) {
    RobotPoseRow result;
    const auto first = row.text(stereo ? "left" : "image");
    const auto second = stereo ? row.text("right") : std::nullopt;
    const auto flange = read_flange(row);
    row.reject_other_keys();
    if (!first) row.fail(stereo ? "left" : "image", "is missing");
    if (stereo && !second) row.fail("right", "is missing: with a rig every view is a pair");
    if (!flange) {
        row.fail("flange",
                 "is missing: give [x_mm, y_mm, z_mm, w_deg, p_deg, r_deg], or "
                 "joints_deg, or T_robot_flange");
    }
    result.left = folder / first.value_or("");
    if (second) result.right = folder / *second;
    result.T_robot_flange = flange.value_or(Pose::Identity());
    return result;
}

}  // namespace

Result<RobotPosesFile> load_robot_poses(const fs::path& path) {
    const auto text = read_whole_file(path);
    if (!text) return forward_error(text.error());
    StrictYaml yaml = StrictYaml::parse(path, *text);
    require_format(yaml, "gripscan-robot-poses/1");
    RobotPosesFile file;
    const std::string camera_on = yaml.text("camera_on").value_or("stand");
    if (camera_on != "stand" && camera_on != "flange") {
        yaml.fail("camera_on", fmt::format("is '{}'; known are stand, flange", camera_on));
    }
    file.mounting = camera_on == "flange" ? Mounting::kCameraOnFlange : Mounting::kBoardOnFlange;
    const auto rig = yaml.text("rig");
    const bool mono = yaml.has("camera");
    if (rig) file.rig = path.parent_path() / *rig;
    file.camera = read_camera(yaml);
    file.board = read_board(yaml);
    auto rows = yaml.maps("poses");
    yaml.reject_other_keys();
    if (rig.has_value() == mono) yaml.fail("rig", "or 'camera': one of both must be given");
    if (!rows || rows->empty()) yaml.fail("poses", "must list the views");
    for (std::size_t i = 0; rows && i < rows->size(); ++i) {
        file.rows.push_back(read_row((*rows)[i], path.parent_path(), rig.has_value()));
    }
    if (Status status = yaml.status(); !status) return forward_error(status.error());
    return file;
}

}  // namespace gripscan
