// The sources as the architecture tests see them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gripscan::test {

struct SourceFile {
    std::string path;  ///< relative to the root, with slashes
    std::string text;
};

/// All text files below the root's fixed folders and directly in the root, sorted by path.
[[nodiscard]] std::vector<SourceFile> read_source_tree(const std::filesystem::path& root);

struct IncludeLine {
    std::string target;
    bool quoted = false;  ///< "…", not <…>
    int line = 0;
};

[[nodiscard]] std::vector<IncludeLine> includes_of(std::string_view text);

[[nodiscard]] bool is_cpp(std::string_view path);
[[nodiscard]] bool is_header(std::string_view path);

}  // namespace gripscan::test
