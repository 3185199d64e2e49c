#include "core/sim/cabinet.h"

#include <array>

namespace gripscan::sim {
namespace {

using std::chrono::steady_clock;

ExchangePoint point_of(const gsp::Request& request) {
    // In the order of the alternatives of gsp::Request.
    constexpr std::array kPoints = {ExchangePoint::kHello, ExchangePoint::kState,
                                    ExchangePoint::kPos, ExchangePoint::kAccept,
                                    ExchangePoint::kStop};
    static_assert(kPoints.size() == std::variant_size_v<gsp::Request>);
    return kPoints.at(request.index());
}

}  // namespace

CellClock cell_clock(double scale) {
    return [scale, start = steady_clock::now()] {
        return scale * std::chrono::duration<double>(steady_clock::now() - start).count();
    };
}

Cabinet::Cabinet(ArmMotion arm, const ControllerSettings& settings,
                 const std::vector<Fault>& faults, CellClock clock)
    : clock_(std::move(clock)),
      arm_(std::move(arm)),
      controller_(arm_, settings),
      faults_(faults) {}

Exchange Cabinet::answer(LinkKind link, const gsp::Request& request) {
    const std::scoped_lock lock(mutex_);
    const double now_s = clock_();
    const ExchangePoint point = point_of(request);
    if (point == ExchangePoint::kAccept) faults_.count_turn();
    const int start = starts_;
    strike(point, now_s);
    if (starts_ != start) return {};  // it was not heard any more
    return {encode(controller_.answer(link, request, now_s)), faults_.take_of_link(point), {}};
}

std::optional<Exchange> Cabinet::outcome() {
    const std::scoped_lock lock(mutex_);
    const double now_s = clock_();
    if (controller_.half_way(now_s)) {
        strike(ExchangePoint::kRun, now_s);
        if (auto fault = faults_.take_of_link(ExchangePoint::kRun)) return Exchange{"", fault, {}};
    }
    if (controller_.arrived(now_s)) strike(ExchangePoint::kDone, now_s);
    const auto reply = controller_.outcome(now_s);
    if (!reply) return std::nullopt;
    strike(ExchangePoint::kAfterDone, now_s);
    return Exchange{encode(*reply), faults_.take_of_link(ExchangePoint::kDone),
                    faults_.take_of_link(ExchangePoint::kAfterDone)};
}

void Cabinet::new_client(LinkKind link) {
    const std::scoped_lock lock(mutex_);
    if (link == LinkKind::kMotion) controller_.new_client();
}

ArmState Cabinet::arm() const {
    const std::scoped_lock lock(mutex_);
    return arm_.at(clock_());
}

void Cabinet::set_conditions(const Conditions& conditions) {
    const std::scoped_lock lock(mutex_);
    controller_.set_conditions(conditions, clock_());
}

int Cabinet::starts() const {
    const std::scoped_lock lock(mutex_);
    return starts_;
}

bool Cabinet::is_away() const {
    const std::scoped_lock lock(mutex_);
    return steady_clock::now() < back_at_;
}

void Cabinet::strike(ExchangePoint point, double now_s) {
    while (const auto fault = faults_.take_of_controller(point)) {
        Conditions conditions;
        conditions.servo_on = false;
        switch (fault->kind) {
            case FaultKind::kRestart:
                controller_.restart(now_s);
                ++starts_;
                back_at_ = steady_clock::now() + std::chrono::duration_cast<steady_clock::duration>(
                                                     std::chrono::duration<double>(fault->amount));
                break;
            case FaultKind::kEmergencyStop:
                conditions.emergency_stop = conditions.fault = true;
                conditions.alarm = "SRVO-001 emergency stop of the operator panel";
                controller_.set_conditions(conditions, now_s, fault->amount);
                break;
            case FaultKind::kServoOff:
                conditions.alarm = "SRVO-003 deadman switch released";
                controller_.set_conditions(conditions, now_s, fault->amount);
                break;
            default:
                controller_.limit_joint6(fault->amount, now_s);
                break;
        }
    }
}

}  // namespace gripscan::sim
