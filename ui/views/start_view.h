// What the start page says, without drawing.
#pragma once

#include <chrono>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ui/views/snapshot.h"

namespace gripscan::ui {

/// The latest session that can be gone on with; null: none.
[[nodiscard]] const RecentSession* resumable(std::span<const RecentSession> recent);

/// Those whose name, kind, cell or sentence holds every word of the search, in either case.
[[nodiscard]] std::vector<const RecentSession*> found(std::span<const RecentSession> recent,
                                                      std::string_view search);

/// "14 / 36"; "–" where nothing was planned.
[[nodiscard]] std::string steps_text(const RecentSession& session);

struct ClosureText {
    std::string angle;  ///< "0.07°", or the words "not closed"
    std::string shift;  ///< "0.24 mm"; empty with words
};
[[nodiscard]] ClosureText closure_text(const RecentSession& session);

/// "23 Nov 13:20", local time.
[[nodiscard]] std::string day_and_time(std::chrono::system_clock::time_point when);

/// "Resume at step 15".
[[nodiscard]] std::string resume_label(const RecentSession& session);

/// What a click on the line asks for; an interrupted session is gone on with, one that is gone
/// does nothing.
[[nodiscard]] std::vector<Request> requests_of_click(const RecentSession& session);

/// The wish behind "Simulated cell": everything as it is by default.
[[nodiscard]] SessionWish simulated_wish();

}  // namespace gripscan::ui
