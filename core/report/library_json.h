// `library … --json`.
#pragma once

#include <string>

#include "core/recognition/library.h"

namespace gripscan {

[[nodiscard]] std::string library_json(const Library& library);
/// The sidecar, with the lineage as it stands now.
[[nodiscard]] std::string library_entry_json(const Library& library, const LibraryEntry& entry);

}  // namespace gripscan
