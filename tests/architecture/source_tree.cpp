#include "tests/architecture/source_tree.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

namespace gripscan::test {
namespace {

namespace fs = std::filesystem;

bool is_text(const fs::path& path) {
    constexpr std::array<std::string_view, 16> kExtensions{
        ".h",   ".cpp", ".txt",  ".cmake", ".md",   ".sh",   ".json", ".yaml",
        ".yml", ".css", ".html", ".vert",  ".frag", ".glsl", ".supp", ""};
    return std::find(kExtensions.begin(), kExtensions.end(), path.extension().string()) !=
           kExtensions.end();
}

SourceFile read(const fs::path& root, const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return {fs::relative(path, root).generic_string(), std::move(text).str()};
}

}  // namespace

std::vector<SourceFile> read_source_tree(const fs::path& root) {
    std::vector<SourceFile> files;
    for (const auto& entry : fs::directory_iterator(root)) {
        if (entry.is_regular_file() && is_text(entry.path())) {
            files.push_back(read(root, entry.path()));
        }
    }
    for (const char* folder :
         {".ci", "app", "core", "ui", "shaders", "assets", "tests", "third_party", "docs"}) {
        if (!fs::exists(root / folder)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            if (entry.is_regular_file() && is_text(entry.path())) {
                files.push_back(read(root, entry.path()));
            }
        }
    }
    std::sort(files.begin(), files.end(),
              [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
    return files;
}

std::vector<IncludeLine> includes_of(std::string_view text) {
    std::vector<IncludeLine> includes;
    std::istringstream lines{std::string(text)};
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        std::string_view rest = line;
        const auto skip_blanks = [&] {
            rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
        };
        skip_blanks();
        if (!rest.starts_with('#')) continue;
        rest.remove_prefix(1);
        skip_blanks();
        if (!rest.starts_with("include")) continue;
        rest.remove_prefix(7);
        skip_blanks();
        if (rest.empty() || (rest[0] != '"' && rest[0] != '<')) continue;
        const bool quoted = rest[0] == '"';
        const std::size_t end = rest.find(quoted ? '"' : '>', 1);
        if (end == std::string_view::npos) continue;
        includes.push_back({std::string(rest.substr(1, end - 1)), quoted, number});
    }
    return includes;
}

bool is_cpp(std::string_view path) {
    return path.ends_with(".cpp") || path.ends_with(".h");
}
bool is_header(std::string_view path) {
    return path.ends_with(".h");
}

}  // namespace gripscan::test
