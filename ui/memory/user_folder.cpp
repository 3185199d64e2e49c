#include "ui/memory/user_folder.h"

#include <cstdlib>

namespace gripscan::ui {

std::optional<std::filesystem::path> user_folder(const char* variable,
                                                 std::string_view beside_home) {
    if (const char* set = std::getenv(variable); set != nullptr) {
        const std::filesystem::path base(set);
        if (base.is_absolute()) return base / "gripscan";
    }
    if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0') {
        return std::filesystem::path(home) / beside_home / "gripscan";
    }
    return std::nullopt;
}

}  // namespace gripscan::ui
