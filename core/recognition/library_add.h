// New templates for the library: measured ones with their history, and CAD models sampled as a
// camera could see them.
#pragma once

#include <functional>

#include "core/base/for_each.h"
#include "core/base/progress.h"
#include "core/recognition/library.h"

namespace gripscan {

struct AddRequest {
    /// A session with results, a results folder, or a file: PCD, PLY, XYZ, STL, OBJ.
    std::filesystem::path source;
    std::string name;  ///< empty: of the folder or the file
    std::string kind;  ///< empty: of the template's sidecar, else "object"
    double metres_per_unit = 1.0;
    double mesh_spacing_m = 0.001;
    std::optional<Pose> T_tool_template;  ///< of a gripper, where it is known
    bool replace = false;                 ///< a template of that name
    bool allow_duplicate = false;         ///< of another name
    std::string software;                 ///< version, for the sidecar
};

struct Added {
    LibraryEntry entry;
    std::string same_shape_as;  ///< an entry with the same shape, though other points; empty: none
};

/// Errors: what cannot be read or is no template; the same bytes, or the same shape, under another
/// name unless allowed; a name that is taken unless to be replaced; cancelled. Nothing is changed
/// then.
[[nodiscard]] Result<Added> add_to_library(Library& library, const AddRequest& request,
                                           const Progress& progress, const ForEach& for_each);

}  // namespace gripscan
