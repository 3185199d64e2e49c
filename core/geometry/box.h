// An axis-aligned box, such as the registration area.
#pragma once

#include <Eigen/Core>
#include <array>

namespace gripscan {

/// Corners in metres, min < max in every coordinate when valid.
struct Box {
    Eigen::Vector3d min_m = Eigen::Vector3d::Zero();
    Eigen::Vector3d max_m = Eigen::Vector3d::Zero();

    [[nodiscard]] bool valid() const {
        return min_m.allFinite() && max_m.allFinite() && (min_m.array() < max_m.array()).all();
    }
    [[nodiscard]] bool contains(const Eigen::Vector3d& p_m) const {
        return (p_m.array() >= min_m.array()).all() && (p_m.array() <= max_m.array()).all();
    }
    [[nodiscard]] std::array<Eigen::Vector3d, 8> corners() const {
        std::array<Eigen::Vector3d, 8> result;
        for (unsigned i = 0; i < 8; ++i) {
            result[i] = Eigen::Vector3d((i & 1) != 0 ? max_m.x() : min_m.x(),
                                        (i & 2) != 0 ? max_m.y() : min_m.y(),
                                        (i & 4) != 0 ? max_m.z() : min_m.z());
        }
        return result;
    }
    friend bool operator==(const Box&, const Box&) = default;
};

}  // namespace gripscan
