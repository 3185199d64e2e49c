// The photographs of ViSP's tutorial (camera on the flange of a real arm) as gripscan reads poses.
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "core/geometry/pose.h"
#include "tests/support/temporary_folder.h"

namespace gripscan::test {

inline std::vector<double> numbers_in(const std::string& text) {
    const std::regex number(R"([-+]?\d+\.?\d*(?:[eE][-+]?\d+)?)");
    std::vector<double> result;
    for (auto it = std::sregex_iterator(text.begin(), text.end(), number);
         it != std::sregex_iterator(); ++it) {
        result.push_back(std::stod(it->str()));
    }
    return result;
}

/// tx ty tz and a rotation vector, after "data:".
inline Pose visp_pose(const std::filesystem::path& path) {
    const std::string text = read_text(path);
    const auto n = numbers_in(text.substr(text.find("data:")));
    Pose T = Pose::Identity();
    T.translation() = Eigen::Vector3d(n.at(0), n.at(1), n.at(2));
    T.linear() = rotation_from_vector({n.at(3), n.at(4), n.at(5)});
    return T;
}

/// T_flange_camera as published.
inline Pose visp_reference(const std::filesystem::path& data) {
    const std::string text = read_text(data / "reference-result.yaml");
    const auto n = numbers_in(text.substr(text.find("data:", text.find("flange_from_camera: !!"))));
    Pose T = Pose::Identity();
    for (int i = 0; i < 12; ++i) T.matrix()(i / 4, i % 4) = n.at(static_cast<std::size_t>(i));
    return T;
}

inline std::string matrix_text(const Pose& T) {
    std::string text;
    for (const double number : row_major_from_pose(T)) {
        text += (text.empty() ? "" : ", ") + fmt::format("{:.17g}", number);
    }
    return "[" + text + "]";
}

inline void write_visp_poses(const std::filesystem::path& data, const std::filesystem::path& out) {
    std::string text =
        "format: gripscan-robot-poses/1\ncamera_on: flange\n"
        "camera: {fx: 607.5931396484375, fy: 607.574951171875, cx: 323.46282958984375, cy: "
        "243.25529479980469}\n"
        "board: {chessboard: [9, 6], square_mm: 23.6}\nposes:\n";
    for (int i = 1; i <= 8; ++i) {
        const auto image = std::filesystem::absolute(data / fmt::format("franka_image-{}.png", i));
        const Pose T = visp_pose(data / fmt::format("franka_pose_rPe_{}.yaml", i));
        text += fmt::format("  - {{image: '{}', T_robot_flange: {}}}\n", image.string(),
                            matrix_text(T));
    }
    write_text(out, text);
}

}  // namespace gripscan::test
