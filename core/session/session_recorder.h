// Writes a session folder as the turn goes on: images first, then the line in captures.csv, so that
// whatever stops the program leaves a valid recording of what was taken.
#pragma once

#include "core/procedure/auto_turn.h"
#include "core/session/session.h"

namespace gripscan {

class SessionRecorder : public TurnStore {
  public:
    /// Makes the folder with session.yaml and rig.yaml. A folder that holds anything already is an
    /// error: recordings are never overwritten.
    [[nodiscard]] static Result<SessionRecorder> create(const std::filesystem::path& folder,
                                                        const SessionSpec& spec,
                                                        const StereoRig& rig);

    [[nodiscard]] Status store(const TakenCapture& capture) override;

  private:
    explicit SessionRecorder(std::filesystem::path folder);

    std::filesystem::path folder_;
    CaptureTable table_;
};

}  // namespace gripscan
