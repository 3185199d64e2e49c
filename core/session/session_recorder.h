// The automatic turn's way into a session folder.
#pragma once

#include "core/procedure/auto_turn.h"
#include "core/session/session_store.h"

namespace gripscan {

class SessionRecorder : public TurnStore {
  public:
    explicit SessionRecorder(SessionStore& store) : store_(store) {}

    [[nodiscard]] Status store(const TakenCapture& capture) override;

  private:
    SessionStore& store_;
    std::vector<CaptureRecord> captures_;
};

}  // namespace gripscan
