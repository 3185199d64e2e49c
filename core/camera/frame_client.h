// A stereo camera at the other end of a frame port.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/camera/frame_protocol.h"
#include "core/concurrency/tcp_connection.h"

namespace gripscan {

struct FrameClientSettings {
    std::string host = "127.0.0.1";
    std::uint16_t port = 18742;
    std::chrono::milliseconds connect_within{3000};
    /// A picture: rendering takes a while. A greeting: one client is served at a time.
    std::chrono::milliseconds answer_within{30000};
    /// Without a greeting for so long, someone is told what is waited for.
    std::chrono::milliseconds patience{2000};
    std::function<void(const std::string&)> tell;
};

/// Not for several threads at once. A lost connection is opened again by the next grab().
class FrameClient : public StereoSource {
  public:
    /// Connects and asks for the description. A stop request ends the waiting (cancelled).
    [[nodiscard]] static Result<std::unique_ptr<FrameClient>> connect(
        const FrameClientSettings& settings, const std::stop_token& stop = {});
    ~FrameClient() override;

    [[nodiscard]] Result<StereoFrame> grab(const FrameRequest& request) override;
    [[nodiscard]] const frames::Description& description() const { return description_; }

  private:
    struct Link;
    explicit FrameClient(const FrameClientSettings& settings);
    [[nodiscard]] Status open(const std::stop_token& stop);
    template <typename Answer>
    [[nodiscard]] Result<Answer> ask(const frames::Message& question, const std::stop_token& stop);
    [[nodiscard]] TcpResult<frames::Message> exchange(const frames::Message& question,
                                                      const std::stop_token& stop);

    FrameClientSettings settings_;
    frames::Description description_;
    std::unique_ptr<Link> link_;  ///< none: not connected
};

}  // namespace gripscan
