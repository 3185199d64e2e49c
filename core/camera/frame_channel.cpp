#include "core/camera/frame_channel.h"

namespace gripscan::frames {

TcpResult<void> FrameChannel::write(const Message& message, Deadline deadline) {
    return connection_.write(encode(message), deadline);
}

TcpResult<Message> FrameChannel::read(Deadline deadline) {
    const auto nonsense = [](const Error& error) {
        return tl::unexpected<TcpError>({TcpFault::kFailed, error.message});
    };
    while (true) {
        if (received_.size() >= kHeaderBytes) {
            const auto header = decode_header(std::string_view(received_).substr(0, kHeaderBytes));
            if (!header) return nonsense(header.error());
            const std::size_t whole = kHeaderBytes + header->payload_bytes;
            if (received_.size() >= whole) {
                auto message = decode(*header, std::string_view(received_).substr(
                                                   kHeaderBytes, header->payload_bytes));
                if (!message) return nonsense(message.error());
                received_.erase(0, whole);
                return std::move(*message);
            }
        }
        auto bytes = connection_.read_some(deadline);
        if (!bytes) return tl::unexpected<TcpError>(std::move(bytes.error()));
        received_ += *bytes;
    }
}

}  // namespace gripscan::frames
