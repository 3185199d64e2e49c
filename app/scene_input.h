// What `recognise --scene` may be: a cloud, a depth image, or the captures of a session.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/context.h"
#include "core/base/for_each.h"
#include "core/base/progress.h"
#include "core/cloud/cloud.h"
#include "core/robot/robot_link.h"

namespace gripscan::app {

struct SceneOptions {
    std::string scene;
    std::optional<int> capture;
    std::vector<double> intrinsics;     ///< fx fy cx cy, px; empty: not a depth image
    std::optional<double> depth_scale;  ///< units a metre
    std::vector<double> viewpoint_m;    ///< x y z; empty: as the file says
    std::string environment;            ///< taken away; empty: nothing is
};

void add_scene_options(CLI::App& command, SceneOptions& options);

struct InputView {
    int capture = 0;
    Cloud cloud;
    std::optional<JointAngles> joints_rad;  ///< read before the exposure
};

/// Every used capture of a session, or the one that is asked for; the one view of a file.
[[nodiscard]] Result<std::vector<InputView>> load_scene(const SceneOptions& options,
                                                        const Progress& progress,
                                                        const ForEach& for_each);

}  // namespace gripscan::app
