#include "core/sim/link_server.h"

#include <optional>
#include <variant>

#include "core/concurrency/tcp_listener.h"
#include "core/sim/disturbed_channel.h"

namespace gripscan::sim {
namespace {

/// How often a link looks whether a turn has ended or the controller is away.
constexpr std::chrono::milliseconds kPoll{2};

/// The life of one link: it listens, serves who comes, and goes away with the controller.
class Link {
  public:
    Link(TcpListener listener, LinkKind kind, Cabinet& cabinet, std::stop_token stop)
        : port_(listener.port()),
          listener_(std::move(listener)),
          kind_(kind),
          cabinet_(cabinet),
          stop_(std::move(stop)) {}

    void live() {
        while (!stop_.stop_requested()) {
            if (cabinet_.is_away()) {
                listener_.reset();
                std::this_thread::sleep_for(kPoll);
            } else if (!listener_) {
                open_again();
            } else if (auto client = listener_->accept(stop_, deadline_in(10 * kPoll))) {
                serve(DisturbedChannel(std::move(*client)));
            }
        }
    }

  private:
    void open_again() {
        auto listener = TcpListener::open(port_);
        if (listener) {
            listener_.emplace(std::move(*listener));
        } else {
            std::this_thread::sleep_for(10 * kPoll);
        }
    }

    void serve(DisturbedChannel channel) {
        const int start = cabinet_.starts();
        cabinet_.new_client(kind_);
        while (!stop_.stop_requested() && cabinet_.starts() == start) {
            const auto item = channel.read(deadline_in(kPoll));
            if (!item && item.error().fault != TcpFault::kTimeout) return;
            if (item && !hear(channel, *item, start)) return;
            if (kind_ != LinkKind::kMotion || channel.is_mute()) continue;
            const auto news = cabinet_.outcome();
            if (cabinet_.starts() != start) return;
            if (news && !channel.send(*news, stop_)) return;
        }
    }

    /// False: the link is over.
    bool hear(DisturbedChannel& channel, const FramedItem& item, int start) {
        if (std::holds_alternative<BrokenStream>(item)) return false;
        if (channel.is_mute()) return true;
        if (std::holds_alternative<OverlongLine>(item)) {
            return channel.send({encode(gsp::Reply{gsp::too_long()}), {}, {}}, stop_);
        }
        const auto request = gsp::decode_request(std::get<Line>(item).text);
        if (!request) return channel.send({encode(gsp::Reply{request.error()}), {}, {}}, stop_);
        const Exchange exchange = cabinet_.answer(kind_, *request);
        return cabinet_.starts() == start && channel.send(exchange, stop_);
    }

    std::uint16_t port_;
    std::optional<TcpListener> listener_;
    LinkKind kind_;
    Cabinet& cabinet_;
    std::stop_token stop_;
};

}  // namespace

LinkServer::LinkServer(TcpListener listener, LinkKind link, Cabinet& cabinet)
    : port_(listener.port()),
      thread_([link, &cabinet, listener = std::move(listener)](const std::stop_token& stop) mutable {
          Link(std::move(listener), link, cabinet, stop).live();
      }) {}

LinkServer::~LinkServer() = default;

}  // namespace gripscan::sim
