// The pages of the window.
#pragma once

namespace gripscan::ui {

enum class Page { kStart, kProcedure, kTemplate, kRecognise, kCell };

/// What stands in front of the page and takes the input.
enum class Dialog {
    kNone,
    kNewSession,  ///< folder, step, speed, seed or cell file
    kOpen,        ///< a folder or cloud file by its path
    kNote,        ///< why a step or a failed check is accepted
    kExport,
    kSettings,
    kKeys,   ///< F1
    kError,  ///< something failed: what, why, what to do
    kClose,  ///< something is going on: stop and close?
};

}  // namespace gripscan::ui
