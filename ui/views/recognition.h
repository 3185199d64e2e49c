// What was recognised in one view, as the window shows it: values, texts and table rows. Pure.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/cloud/cloud.h"
#include "core/geometry/box.h"
#include "core/geometry/pose.h"

namespace gripscan::ui {

struct StereoPicture;

enum class TemplateKind { kGripper, kObject };

/// A template that was found, with what its score rests on.
struct FoundTemplate {
    std::string name;
    TemplateKind kind = TemplateKind::kObject;
    Pose T_camera_template = Pose::Identity();
    std::optional<Pose> T_robot_template;    ///< where the alignment is known
    std::optional<Pose> T_gripper_template;  ///< where the gripper was found
    double score = 0.0;                      ///< 0 … 1
    double support = 0.0;                    ///< share that agrees, of what the camera could judge
    double found = 0.0;                      ///< share of the surface that faces the camera
    double outline = 0.0;                    ///< share of the outline that the view shows
    double rms_m = 0.0;
    double tolerance_m = 0.0;  ///< within which a point counts as on the surface
    std::string explained;     ///< the score in words
    std::string symmetry = "none";
    std::optional<double> next_score;      ///< of the next best pose; nothing: there is none
    Box box;                               ///< around the template, in its frame
    std::shared_ptr<const Cloud> matched;  ///< points of the view that lie on it, camera frame
};

/// What the gripper must do to grasp the object as it was taught.
struct ShownGrasp {
    std::string object;
    Pose T_robot_gripper = Pose::Identity();  ///< the tool's pose
    bool reachable = false;
    std::string sentence;  ///< joints, or why it cannot be reached
};

struct ShownRecognition {
    int view = 0;                  ///< counts from 1
    std::uint64_t generation = 0;  ///< of its clouds; no two recognitions have the same
    std::optional<int> capture;    ///< of the session; nothing: taken for this
    std::chrono::system_clock::time_point when;
    double seconds = 0.0;
    std::size_t looked_for = 0;                    ///< templates
    double least_score = 0.0;                      ///< below it a template counts as absent
    double least_found = 0.0;                      ///< of FoundTemplate::found
    std::vector<FoundTemplate> found;              ///< best first
    std::shared_ptr<const Cloud> rest;             ///< points of the view that lie on none of them
    std::shared_ptr<const StereoPicture> picture;  ///< null: the view came as a cloud
    std::optional<double> joint6_robot_rad;        ///< turn since the template's first view
    std::optional<double> joint6_gripper_rad;      ///< the same, from the gripper's pose
    std::optional<ShownGrasp> grasp;
    std::vector<std::string> strangers;  ///< "something is in the way, here: …"
};

/// A template of the library.
struct LibraryEntry {
    std::string name;
    TemplateKind kind = TemplateKind::kObject;
    std::size_t points = 0;
    std::string symmetry;
    std::string lineage;  ///< "held by gripper two-finger"; empty: of none
    std::string stale;    ///< why it should be made again; empty: it is up to date
};

}  // namespace gripscan::ui
