// Who may know whom: the folders of gripscan and the libraries of others. ARCHITECTURE.md explains
// the table; this is where it is enforced.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "tests/architecture/source_tree.h"

namespace gripscan::test {

/// Folders of core a folder of core may include, itself and transitive ones among them; empty for
/// a folder that is not in the table.
[[nodiscard]] std::set<std::string> folders_known_by(const std::string& folder);

/// One line a breach: file, line, what is wrong.
[[nodiscard]] std::vector<std::string> include_breaches(const std::vector<SourceFile>& files);

/// The same for what the folders' CMakeLists.txt link.
[[nodiscard]] std::vector<std::string> link_breaches(const std::vector<SourceFile>& files);

/// Paths that exist on one machine only.
[[nodiscard]] std::vector<std::string> machine_path_breaches(const std::vector<SourceFile>& files);

}  // namespace gripscan::test
