// Which clouds the 3D view shows, where each stands and what it stands for. Pure: from the snapshot
// to a list; poses are in the frame of the first capture (camera frame while it was taken).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ui/views/snapshot.h"

namespace gripscan::ui {

/// How the second cloud of a step stands to the first.
enum class PairPose {
    kBefore,   ///< as both were captured
    kAligned,  ///< as the registration placed it
    kRobot,    ///< turned by what the robot reported
};

enum class CloudRole {
    kView,      ///< one capture of the growing cloud
    kTarget,    ///< capture at the beginning of a step
    kSource,    ///< and at its end
    kTemplate,  ///< all captures merged
    kScene,     ///< a recognised view, what belongs to no template
    kFound,     ///< and what belongs to one
    kHolder,    ///< the gripper that holds the object
};

struct SceneCloud {
    std::uint64_t id = 0;          ///< stable for the same capture
    std::uint64_t generation = 0;  ///< changes with the points
    std::shared_ptr<const Cloud> cloud;
    std::shared_ptr<const std::vector<float>> residual_m;  ///< one a point; null: unknown
    Pose T_first_cloud = Pose::Identity();
    int step = 0;  ///< place in the turn, from 0; of the capture
    CloudRole role = CloudRole::kView;
    Colour Theme::*colour = nullptr;  ///< of kFound
    bool visible = true;              ///< hidden ones stay in the memory of the graphics card
};

enum class SceneKind { kEmpty, kGrowing, kPair, kTemplate, kFound };

/// Angles about the axis from where the first capture was taken, as the arc shows them.
struct SceneTurn {
    double turned_rad = 0.0;          ///< by steps that are trusted
    std::optional<double> next_rad;   ///< where the next step leads
    std::optional<double> robot_rad;  ///< of the shown step: where the robot says it leads
    std::optional<double> icp_rad;    ///< and where the registration says so
};

struct SceneParts {
    SceneKind kind = SceneKind::kEmpty;
    std::vector<SceneCloud> clouds;  ///< in the order of the turn
    SceneTurn turn;
    int steps_total = 0;  ///< of the whole turn; 0: unknown
    int steps_done = 0;
    int not_placed = 0;  ///< used captures that no trusted step leads to
    int pair_from = 0;   ///< kPair: captures of the step
    int pair_to = 0;
    /// kGrowing, of an object's turn: the latest view taken apart, and where it stands.
    std::shared_ptr<const ObjectSplit> split;
    Pose T_first_split = Pose::Identity();
    std::string why_no_aligned;  ///< kPair: why there is nothing to show after the registration
    std::string why_no_robot;
};

/// What of the scene the user wants to see.
struct SceneWish {
    /// The two clouds of the selected step. Nothing: for a rejected step, and for one that was
    /// chosen in Table 1.
    std::optional<bool> pair;
    PairPose pair_pose = PairPose::kAligned;
};

[[nodiscard]] SceneParts scene_parts(const Snapshot& snapshot, const SceneWish& wish);

/// T_first_k of every line of captures.csv; nothing where a capture is not used or no trusted step
/// leads to it. From the solution where there is one, else steps composed.
[[nodiscard]] std::vector<std::optional<Pose>> capture_poses(const Snapshot& snapshot);

/// Why the two clouds of the selected step cannot be shown; empty: they can.
[[nodiscard]] std::string why_no_pair(const Snapshot& snapshot);

/// Points of the clouds that are visible.
[[nodiscard]] std::size_t visible_points(const SceneParts& parts);

}  // namespace gripscan::ui
