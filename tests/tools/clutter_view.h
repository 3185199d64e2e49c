// Single views of the simulated cell with clutter and things in front, and which templates are in
// them at which pose: what recognition is examined by.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/for_each.h"
#include "core/base/result.h"
#include "core/cloud/cloud.h"
#include "core/geometry/pose.h"
#include "core/sim/mesh.h"

namespace gripscan::test {

/// The six templates of the exam: two grippers and a box-like, a curved, a flat and a nearly
/// symmetric object.
[[nodiscard]] std::vector<std::string> exam_templates();
/// The template's true surface, in its own frame: tool0 of a gripper, the grasp frame of an object.
[[nodiscard]] sim::Mesh template_mesh(const std::string& name);

/// A template that is in a view.
struct TrueTemplate {
    std::string name;
    Pose T_camera_template = Pose::Identity();
    double visible = 0.0;  ///< share of the surface facing the camera that nothing else hides
    /// Share of the detail that alone tells its turns apart which the camera sees; 1 if it needs
    /// none.
    double telling_detail = 1.0;
};

struct ClutterView {
    Cloud cloud;
    std::vector<TrueTemplate> present;
};

struct ClutterSettings {
    std::uint64_t seed = 1;
    unsigned image_fraction = 1;    ///< 2: half the camera's pixels a side
    bool templates_present = true;  ///< false: only things that are none of the templates
};

/// Rendered, then put through the stereo chain like any pair of images.
[[nodiscard]] Result<ClutterView> make_clutter_view(const ClutterSettings& settings,
                                                    const ForEach& for_each);

}  // namespace gripscan::test
