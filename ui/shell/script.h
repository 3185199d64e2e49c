// A tour through the window as text, one step a line: for documentation pictures, demonstrations
// and tests. Steps press controls by the names under which the window notes them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/base/result.h"
#include "ui/shell/key_stroke.h"

namespace gripscan::ui {

namespace script {
struct Click {  ///< `click ID`: waits until the control is there and enabled
    std::string id;
};
struct RightClick {  ///< `menu ID`
    std::string id;
};
struct Key {  ///< `key Space`
    KeyStroke stroke;
};
struct Type {  ///< `type some text`
    std::string text;
};
struct Drag {  ///< `drag ID DX DY`: from the middle of the control, in px
    std::string id;
    float dx_px = 0.0F;
    float dy_px = 0.0F;
};
struct Pause {  ///< `pause SECONDS`
    double seconds = 0.0;
};
struct WaitFor {  ///< `wait ID [SECONDS]`: until it is there and enabled, at most that long
    std::string id;
    std::optional<double> patience_s;
};
struct Picture {  ///< `picture FILE.png`
    std::filesystem::path file;
};
struct Say {  ///< `say what is going on`: a caption; without words it goes
    std::string text;
};
}  // namespace script

using ScriptStep =
    std::variant<script::Click, script::RightClick, script::Key, script::Type, script::Drag,
                 script::Pause, script::WaitFor, script::Picture, script::Say>;

/// Empty lines and those that begin with # are left out. Errors name the line.
[[nodiscard]] Result<std::vector<ScriptStep>> parse_script(const std::string& text,
                                                           const std::string& file);

}  // namespace gripscan::ui
