#include "ui/views/view_keys.h"

#include <array>

#include "ui/views/actions.h"

namespace gripscan::ui {

std::span<const ViewKey> view_keys() {
    using enum ViewCommand;
    static constexpr std::array kKeys{
        ViewKey{kFitSelection, "view.fit", "Fit the part", "F"},
        ViewKey{kFitAll, "view.fit_all", "Fit everything", "Home"},
        ViewKey{kFront, "view.front", "Front view", "Ctrl+1"},
        ViewKey{kSide, "view.side", "Side view", "Ctrl+3"},
        ViewKey{kTop, "view.top", "Top view", "Ctrl+7"},
        ViewKey{kAlongAxis, "view.axis", "Look along the joint axis", "X"},
        ViewKey{kStereoCamera, "view.camera", "View of the left camera", "V"},
        ViewKey{kMeasure, "view.measure", "Measure", "M"},
        ViewKey{kSideBySide, "view.side_by_side", "Side by side", "D"},
        ViewKey{kEyeDome, "view.eye_dome", "Eye-dome lighting", "E"},
        ViewKey{kLarger, "view.larger", "Larger points", "Ctrl+Up"},
        ViewKey{kSmaller, "view.smaller", "Smaller points", "Ctrl+Down"},
    };
    return kKeys;
}

std::optional<ViewCommand> view_command(std::string_view key,
                                        const WindowPreferences& preferences) {
    for (const ViewKey& candidate : view_keys()) {
        const std::string_view bound = chosen_key(candidate.name, candidate.key, preferences);
        if (bound == key) return candidate.command;
    }
    return std::nullopt;
}

}  // namespace gripscan::ui
