// The Stanford bunny's range scans and where its bun.conf says they stand.
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "core/geometry/pose.h"

namespace gripscan::test {

/// T_model_scan by file name. The quaternion of the file is the conjugate of the rotation.
[[nodiscard]] inline std::map<std::string, Pose> bunny_poses(const std::filesystem::path& folder) {
    std::map<std::string, Pose> poses;
    std::ifstream file(folder / "bun.conf");
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string kind;
        std::string name;
        Eigen::Vector3d t;
        Eigen::Quaterniond q;
        words >> kind >> name >> t.x() >> t.y() >> t.z() >> q.x() >> q.y() >> q.z() >> q.w();
        if (!words || kind != "bmesh") continue;
        Pose T = Pose::Identity();
        T.linear() = q.conjugate().normalized().toRotationMatrix();
        T.translation() = t;
        poses[name] = T;
    }
    return poses;
}

}  // namespace gripscan::test
