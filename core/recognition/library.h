// The template library: a folder with a PCD and a sidecar for every template.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/cloud/cloud.h"
#include "core/geometry/box.h"
#include "core/geometry/pose.h"

namespace gripscan {

/// How an object was held when it was registered: its lineage and its grasp.
struct HeldBy {
    std::string gripper;  ///< name in the library; empty: no gripper with that check sum was there
    std::string check;    ///< of the gripper's template as it was then
    std::optional<Pose> T_gripper_object;  ///< from the object template's frame into the gripper's
};

/// What a sidecar says.
struct LibraryEntry {
    std::string name;
    std::string file;   ///< of the points, in the library's folder
    std::string check;  ///< sum of its bytes
    std::string kind;   ///< "gripper", "object"
    std::string unit = "m";
    std::string frame;                    ///< in words
    std::optional<Pose> T_axis_template;  ///< origin on the joint's axis, z along it
    std::optional<Pose> T_tool_template;  ///< of a gripper: its frame in tool0
    std::optional<double> alpha_deg;      ///< step of the turn
    std::size_t points = 0;
    Box bounds;
    std::string symmetry = "none";
    std::optional<std::string> calibration;  ///< check sum of the rig it was measured with
    std::string source;                      ///< where it was added from
    std::string software;                    ///< version that added it
    std::optional<HeldBy> held;
    std::string origin;  ///< template.json as it was, with closure and Table 1; empty: from CAD
};

struct Library {
    std::filesystem::path folder;
    std::vector<LibraryEntry> entries;  ///< by name

    [[nodiscard]] const LibraryEntry* find(const std::string& name) const;
};

/// Reads every sidecar. A folder that is absent is an error, an empty one is not. The message
/// names the sidecar and what is wrong with it.
[[nodiscard]] Result<Library> open_library(const std::filesystem::path& folder);
/// The same, but an absent folder is an empty library: the first template makes it.
[[nodiscard]] Result<Library> open_or_begin_library(const std::filesystem::path& folder);

/// The points, checked against the sum in the sidecar.
[[nodiscard]] Result<Cloud> load_entry(const Library& library, const LibraryEntry& entry);

/// Writes the points under a name that says their check sum, then the sidecar: a library is never
/// seen half changed. The entry's `file` and `check` are set from the bytes.
[[nodiscard]] Status store_entry(Library& library, LibraryEntry entry, const std::string& pcd);

/// Sidecar first, so that what is left behind by a power cut is a file nobody names.
[[nodiscard]] Status remove_entry(Library& library, const std::string& name);

enum class Lineage {
    kNone,     ///< not held by a gripper when it was registered
    kCurrent,  ///< the gripper in the library is the one it was registered with
    kStale,    ///< the gripper's template has changed since
    kMissing,  ///< the gripper is not in the library
};
[[nodiscard]] std::string_view word(Lineage lineage);
[[nodiscard]] Lineage lineage_of(const Library& library, const LibraryEntry& entry);

/// A sidecar as text, and back; `path` is for messages.
[[nodiscard]] std::string sidecar_text(const LibraryEntry& entry);
[[nodiscard]] Result<LibraryEntry> parse_sidecar(const std::filesystem::path& path,
                                                 const std::string& text);

/// The kind that the sidecar of any template names; empty where it cannot be told.
[[nodiscard]] std::string sidecar_kind(const std::filesystem::path& sidecar);

}  // namespace gripscan
