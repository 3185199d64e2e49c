#include "ui/views/session_wish.h"

#include "ui/views/path_listing.h"

namespace gripscan::ui {
namespace {
namespace fs = std::filesystem;

bool blank(const std::string& text) {
    return text.find_first_not_of(' ') == std::string::npos;
}

std::string folder_problem(const std::string& folder) {
    if (blank(folder)) return {};
    const fs::path path = expanded(folder);
    std::error_code code;
    if (!fs::exists(path, code)) return {};
    if (!fs::is_directory(path, code)) return "The session folder is a file: choose another name.";
    return fs::is_empty(path, code)
               ? ""
               : "The session folder holds something: recordings are never overwritten.";
}

}  // namespace

std::string session_problem(const TypedSession& typed) {
    if (typed.wish.object) {
        if (blank(typed.gripper)) return "Type the session or template of the gripper.";
        std::error_code code;
        if (!fs::exists(expanded(typed.gripper), code)) {
            return "There is neither a session nor a template of the gripper at this path.";
        }
        if (typed.simulated && typed.wish.sim_object.empty())
            return "Choose what the gripper holds.";
    }
    if (!typed.simulated) {
        if (blank(typed.cell_file)) return "Type the path of the cell file.";
        std::error_code code;
        if (!fs::is_regular_file(expanded(typed.cell_file), code)) {
            return "There is no cell file at this path.";
        }
    }
    return folder_problem(typed.folder);
}

SessionWish session_wish(const TypedSession& typed) {
    SessionWish wish = typed.wish;
    wish.folder = blank(typed.folder) ? fs::path() : expanded(typed.folder);
    wish.gripper = wish.object ? expanded(typed.gripper) : fs::path();
    if (!wish.object || !typed.simulated) wish.sim_object.clear();
    if (typed.simulated) {
        wish.cell = "sim";
        wish.live = wish.manual = false;
    } else {
        wish.cell = expanded(typed.cell_file).string();
        wish.faults.clear();
        wish.seed = SessionWish{}.seed;
    }
    return wish;
}

}  // namespace gripscan::ui
