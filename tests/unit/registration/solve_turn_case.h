// Synthetic turns for the tests of the whole registration, with their truth.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "core/concurrency/worker_pool.h"
#include "core/registration/solve_turn.h"
#include "tests/support/pose_matchers.h"
#include "tests/support/synthetic_views.h"

namespace gripscan::test {

struct TurnCase {
    std::vector<TurnView> views;
    std::vector<Pose> T_view_first;  ///< truth
    Axis axis;
    SolidPart part;
};

/// How the part was really turned and moved before each capture, and what the robot says of it.
struct TurnPlan {
    std::uint64_t seed = 1;
    int captures = 37;
    double step_deg = 10.0;
    double robot_noise_deg = 0.01;
    double true_over_robot = 1.0;
    int slips_before = -1;  ///< from this capture on the part sits 3 mm further along the axis
};

[[nodiscard]] inline TurnCase make_turn(const TurnPlan& plan) {
    TurnCase turn{{}, {}, cell_axis(), asymmetric_part(plan.seed)};
    SeededRandom random(plan.seed + 500);
    ViewSettings settings{.width_px = 90, .height_px = 72, .focal_px = 400.0};
    for (int k = 0; k < plan.captures; ++k) {
        const double robot_deg = k * plan.step_deg;
        Pose T = turn_about(turn.axis, rad_from_deg(plan.true_over_robot * robot_deg));
        if (plan.slips_before >= 0 && k >= plan.slips_before) {
            T.translation() += 3.0e-3 * turn.axis.direction;
        }
        TurnView view;
        view.index = k;
        view.commanded_rad = rad_from_deg(robot_deg);
        view.joint6_rad = rad_from_deg(30.0 + robot_deg + plan.robot_noise_deg * random.normal());
        view.cloud = view_of(turn.part, T * part_turned(turn.axis, 0.0), settings,
                             plan.seed * 100 + static_cast<std::uint64_t>(k));
        turn.views.push_back(std::move(view));
        turn.T_view_first.push_back(T);
    }
    return turn;
}

[[nodiscard]] inline TurnReport solved(const std::vector<TurnView>& views,
                                       const TurnSettings& settings = {}) {
    WorkerPool pool(2);
    auto report = solve_turn(views, settings, {}, pool.for_each());
    if (!report) {
        ADD_FAILURE() << report.error().message;
        return {};
    }
    return std::move(*report);
}

/// Shares of template points within tolerance_m of the part's surface, first view's frame: rays
/// along the template's own normals, from outside, must meet the part where the point is.
[[nodiscard]] inline double share_on_surface(const Cloud& merged, const TurnCase& turn,
                                             double tolerance_m) {
    const Pose T_part_camera = part_turned(turn.axis, 0.0).inverse();
    constexpr double kBack_m = 3.0e-3;
    std::size_t good = 0;
    for (std::size_t i = 0; i < merged.size(); ++i) {
        const Eigen::Vector3d p = T_part_camera * merged.points[i].cast<double>();
        const Eigen::Vector3d n = T_part_camera.linear() * merged.normals[i].cast<double>();
        const auto t = turn.part.hit({p + kBack_m * n, -n});
        if (t && std::abs(*t - kBack_m) < tolerance_m) ++good;
    }
    return static_cast<double>(good) / static_cast<double>(std::max<std::size_t>(1, merged.size()));
}

}  // namespace gripscan::test
