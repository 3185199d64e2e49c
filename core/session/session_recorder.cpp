#include "core/session/session_recorder.h"

namespace gripscan {

Status SessionRecorder::store(const TakenCapture& capture) {
    if (Status status = store_.store_images(capture.index, capture.frame); !status) return status;
    CaptureRecord record;
    record.index = capture.index;
    record.commanded_rad = capture.commanded_rad;
    record.before = capture.before;
    record.joint6_after_rad = capture.after.joints_rad[5];
    record.t_s = capture.frame.t_s;
    captures_.push_back(std::move(record));
    return store_.save_table(captures_);
}

}  // namespace gripscan
