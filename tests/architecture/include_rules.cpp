#include "tests/architecture/include_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <regex>
#include <sstream>

namespace gripscan::test {
namespace {

/// Folders of core, bottom to top, with those they know directly.
const std::vector<std::pair<std::string, std::vector<std::string>>> kCore{
    {"base", {}},
    {"concurrency", {"base"}},
    {"geometry", {"base"}},
    {"cloud", {"geometry"}},
    {"camera", {"geometry", "concurrency"}},
    {"stereo", {"camera", "cloud"}},
    {"robot", {"geometry", "concurrency"}},
    {"registration", {"cloud"}},
    {"alignment", {"stereo", "robot", "registration"}},
    {"scene", {"registration", "robot"}},
    {"recognition", {"registration", "robot"}},
    {"procedure", {"alignment", "scene", "recognition"}},
    {"session", {"procedure"}},
    {"report", {"session"}},
    {"sim", {"camera", "robot"}},
};

/// Folders of the window, bottom to top, with those they know directly.
const std::vector<std::pair<std::string, std::vector<std::string>>> kUi{
    {"resources", {}},
    {"layout", {}},
    {"theme", {"resources", "layout"}},
    {"gl", {"resources"}},
    {"fonts", {"theme"}},
    {"widgets", {"fonts"}},
    {"render", {"gl", "theme"}},
    {"shell", {"gl", "widgets"}},
    {"views", {"theme"}},
    {"memory", {"views"}},
    {"panels", {"views", "render", "widgets"}},
};

/// Where a library of others may be included. "core" and the like stand for everything below.
struct LibraryRule {
    std::string_view prefix;
    std::vector<std::string_view> folders;
    bool headers_too;  ///< else only in source files: its headers are heavy or leak their types
};

const std::vector<LibraryRule> kLibraries{
    {"tl/expected.hpp", {"core/base"}, true},
    {"fmt/", {"core", "ui", "app"}, true},
    {"Eigen/", {"core", "ui", "app"}, true},
    {"nanoflann.hpp", {"core/cloud"}, false},
    {"assimp/", {"core/cloud"}, false},
    {"pcl/", {"core/cloud", "core/registration", "core/scene", "core/recognition"}, false},
    {"ceres/", {"core/registration", "core/alignment"}, false},
    {"opencv2/core",
     {"core/camera", "core/stereo", "core/alignment", "core/procedure", "core/session", "core/sim",
      "app", "ui"},
     true},
    {"opencv2/",
     {"core/camera", "core/stereo", "core/alignment", "core/recognition", "core/session",
      "core/sim", "app", "ui"},
     false},
    {"arv.h", {"core/camera"}, false},
    {"dc1394/", {"core/camera"}, false},
    {"asio", {"core/concurrency"}, false},
    {"embree3/", {"core/sim"}, false},
    {"yaml-cpp/", {"core/session", "core/procedure", "core/robot"}, true},
    {"nlohmann/",
     {"core/session", "core/report", "core/sim", "core/recognition", "ui", "app"},
     true},
    {"CLI/", {"app"}, true},
    {"imgui", {"ui"}, true},
    {"GLFW/", {"ui/shell"}, false},
    {"epoxy/", {"ui/gl", "ui/render", "ui/shell"}, true},
};

/// The files that may include PCL: its templates take many seconds to compile.
constexpr std::array<std::string_view, 2> kPclWrappers{"core/cloud/pcd_format.cpp",
                                                       "core/registration/paper_icp.cpp"};

std::set<std::string> known_by(const decltype(kCore)& table, const std::string& folder) {
    const auto row =
        std::find_if(table.begin(), table.end(), [&](const auto& r) { return r.first == folder; });
    if (row == table.end()) return {};
    std::set<std::string> known{folder};
    for (const std::string& below : row->second) known.merge(known_by(table, below));
    return known;
}

std::set<std::string> ui_folders_known_by(const std::string& folder) {
    return known_by(kUi, folder);
}

bool is_inside(std::string_view path, std::string_view folder) {
    return path.size() > folder.size() && path.starts_with(folder) && path[folder.size()] == '/';
}

/// "core/cloud/a.h" in "core" -> "cloud"; nothing outside, and for files of `top` itself.
std::string folder_in(std::string_view path, std::string_view top) {
    if (!is_inside(path, top)) return {};
    path.remove_prefix(top.size() + 1);
    const auto end = path.find('/');
    return end == std::string_view::npos ? std::string() : std::string(path.substr(0, end));
}

std::string core_folder(std::string_view path) {
    return folder_in(path, "core");
}

/// Headers of the C++ library have no dot; those of the system end with .h and stand in known
/// places.
bool is_system_header(std::string_view target) {
    if (target.find('.') == std::string_view::npos && target.find('/') == std::string_view::npos) {
        return true;
    }
    constexpr std::array<std::string_view, 15> kSystem{
        "fcntl.h",  "glob.h",    "unistd.h", "stdio.h", "pthread.h",
        "signal.h", "termios.h", "poll.h",   "sys/",    "netinet/",
        "arpa/",    "netdb.h",   "dlfcn.h",  "linux/",  "immintrin.h"};
    return std::any_of(kSystem.begin(), kSystem.end(),
                       [&](std::string_view known) { return target.starts_with(known); });
}

/// The same for a file of ui/`from` that includes a header of the window.
std::string ui_breach(const std::string& from, const std::string& target) {
    const std::string to = folder_in(target, "ui");
    if (from.empty() || to.empty()) return {};  // files of ui itself serve every room
    const auto known = ui_folders_known_by(from);
    if (known.empty()) return fmt::format("ui/{} is not in the table of folders", from);
    return known.contains(to) ? "" : fmt::format("ui/{} does not know ui/{}", from, to);
}

/// What is wrong with our own header there; empty if nothing is.
std::string own_breach(const std::string& path, const std::string& target) {
    if (is_inside(path, "core")) {
        const std::string from = core_folder(path);
        const std::string to = core_folder(target);
        const auto known = folders_known_by(from);
        if (known.empty()) return fmt::format("core/{} is not in the table of folders", from);
        if (to.empty()) return "core includes only core, by paths from the root";
        if (!known.contains(to)) return fmt::format("core/{} does not know core/{}", from, to);
    } else if (is_inside(path, "ui")) {
        if (!is_inside(target, "ui") && core_folder(target).empty()) {
            return "ui includes only ui and core";
        }
        return ui_breach(folder_in(path, "ui"), target);
    } else if (is_inside(path, "app") && is_inside(target, "tests")) {
        return "the program does not include tests";
    }
    return {};
}

/// What is wrong with a library of others there; empty if nothing is.
std::string library_breach(const std::string& path, const std::string& target) {
    if (is_system_header(target)) return {};
    const auto rule = std::find_if(kLibraries.begin(), kLibraries.end(), [&](const LibraryRule& r) {
        return target.starts_with(r.prefix);
    });
    if (rule == kLibraries.end()) {
        return "a library nobody listed; see third_party/README.md and the table of this test";
    }
    const bool place = std::any_of(rule->folders.begin(), rule->folders.end(),
                                   [&](std::string_view f) { return is_inside(path, f); });
    if (!place) return fmt::format("{} has no place here", rule->prefix);
    if (!rule->headers_too && is_header(path)) {
        return fmt::format("{} belongs into source files", rule->prefix);
    }
    if (rule->prefix == "pcl/" &&
        std::find(kPclWrappers.begin(), kPclWrappers.end(), path) == kPclWrappers.end()) {
        return "only a few wrapper files include PCL; see the list of this test";
    }
    return {};
}

bool is_product(const SourceFile& file) {
    return is_cpp(file.path) && (is_inside(file.path, "core") || is_inside(file.path, "ui") ||
                                 is_inside(file.path, "app"));
}

}  // namespace

std::set<std::string> folders_known_by(const std::string& folder) {
    return known_by(kCore, folder);
}

std::vector<std::string> include_breaches(const std::vector<SourceFile>& files) {
    std::vector<std::string> breaches;
    for (const SourceFile& file : files) {
        if (!is_product(file)) continue;
        for (const IncludeLine& include : includes_of(file.text)) {
            const std::string breach = include.quoted ? own_breach(file.path, include.target)
                                                      : library_breach(file.path, include.target);
            if (breach.empty()) continue;
            breaches.push_back(
                fmt::format("{}:{}: {}: {}", file.path, include.line, include.target, breach));
        }
    }
    return breaches;
}

std::vector<std::string> link_breaches(const std::vector<SourceFile>& files) {
    std::vector<std::string> breaches;
    for (const SourceFile& file : files) {
        const std::string folder = core_folder(file.path);
        if (folder.empty() || !file.path.ends_with("/CMakeLists.txt")) continue;
        const auto known = folders_known_by(folder);
        std::istringstream words(std::regex_replace(file.text, std::regex("#[^\n]*|[()]"), " "));
        for (std::string word; words >> word;) {
            if (!word.starts_with("gripscan_") || word == "gripscan_library") continue;
            const std::string linked = word.substr(9);
            if (known.contains(linked)) continue;
            breaches.push_back(
                fmt::format("{}: core/{} does not know core/{}", file.path, folder, linked));
        }
    }
    return breaches;
}

std::vector<std::string> machine_path_breaches(const std::vector<SourceFile>& files) {
    // Homes of people and of build machines. Assembled, so that this file is no breach itself.
    const std::regex pattern("(^|[^A-Za-z0-9_.}/])/" + std::string("(home|Users|root|work|mnt)") +
                             "/[A-Za-z0-9_]");
    std::vector<std::string> breaches;
    for (const SourceFile& file : files) {
        std::istringstream lines(file.text);
        std::string line;
        for (int number = 1; std::getline(lines, line); ++number) {
            if (std::regex_search(line, pattern)) {
                breaches.push_back(fmt::format("{}:{}: {}", file.path, number, line));
            }
        }
    }
    return breaches;
}

}  // namespace gripscan::test
