#include "core/robot/line_channel.h"

namespace gripscan {

TcpResult<void> LineChannel::write(std::string_view line, Deadline deadline) {
    return connection_.write(std::string(line).append(kLineEnd), deadline);
}

TcpResult<FramedItem> LineChannel::read(Deadline deadline) {
    for (;;) {
        if (auto item = framer_.next()) return *std::move(item);
        const auto bytes = connection_.read_some(deadline);
        if (!bytes) return tl::unexpected<TcpError>(bytes.error());
        framer_.feed(*bytes);
        // Empty lines may come without end, faster than a wait for them could time out.
        if (framer_.empty() && std::chrono::steady_clock::now() >= deadline) {
            return tl::unexpected<TcpError>(
                TcpError{TcpFault::kTimeout, "no answer from " + connection_.peer() + " in time"});
        }
    }
}

}  // namespace gripscan
