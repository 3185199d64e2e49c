// The sessions that were opened lately, kept between runs of the program.
#pragma once

#include <filesystem>
#include <vector>

#include "core/base/result.h"
#include "ui/views/snapshot.h"

namespace gripscan::ui {

/// $XDG_STATE_HOME/gripscan, else ~/.local/state/gripscan; nothing where neither is known.
[[nodiscard]] std::optional<std::filesystem::path> state_folder();

/// The list as it lies on the disk: recent.json, gripscan-recent/1. Only folders and times are
/// stored; what a line says is read from the session itself, so it cannot be out of date.
class RecentSessions {
  public:
    static constexpr std::size_t kMost = 40;

    /// `folder` need not exist yet.
    explicit RecentSessions(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Latest first. A file that is absent is an empty list; one that makes no sense is an error
    /// and is left alone until something is added.
    [[nodiscard]] Result<std::vector<RecentSession>> list() const;
    /// Used now; the oldest ones go where there are too many.
    [[nodiscard]] Status add(const std::filesystem::path& session,
                             std::chrono::system_clock::time_point when);
    /// The session's folder stays as it is.
    [[nodiscard]] Status forget(const std::filesystem::path& session);

  private:
    std::filesystem::path folder_;
};

}  // namespace gripscan::ui
