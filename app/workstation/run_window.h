// The workstation's window from opening to closing.
#pragma once

#include "app/context.h"
#include "app/workstation/window_options.h"

namespace gripscan::app {

/// On the main thread. Errors: no screen, a script that makes no sense or could not go on, a
/// picture that cannot be written.
[[nodiscard]] Result<ExitStatus> run_window(const WindowOptions& options, const Context& context);

}  // namespace gripscan::app
