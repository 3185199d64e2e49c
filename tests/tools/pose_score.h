// How good the poses and angles of a turns.json are.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "tests/tools/truth_files.h"

namespace gripscan::test {

/// What a turns.json says, with the captures' indices from the captures.csv it was made of.
struct Turns {
    struct Step {
        int from = 0;
        int to = 0;
        std::optional<double> icp_deg;
    };
    std::vector<Step> steps;
    std::map<int, Pose> T_first_k;  ///< by index of the capture; only those with a pose
};

[[nodiscard]] Result<Turns> load_turns(const std::filesystem::path& turns_json,
                                       const std::filesystem::path& captures_csv);

struct PoseError {
    int capture = 0;
    double rotation_deg = 0.0;
    double shift_mm = 0.0;  ///< of the point of the axis nearest to `centre_m`
};

/// Both sides relative to the first capture that has a pose.
[[nodiscard]] std::vector<PoseError> pose_errors(const Turns& turns, const Truth& truth,
                                                 const Eigen::Vector3d& centre_m);

struct StepError {
    int to = 0;
    std::optional<double> error_deg;  ///< measured turn − true turn of joint 6
};
[[nodiscard]] std::vector<StepError> step_errors(const Turns& turns, const Truth& truth);

}  // namespace gripscan::test
