#include "ui/views/start_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <ctime>
#include <sstream>

namespace gripscan::ui {
namespace {

using End = RecentSession::End;

std::string lower(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

}  // namespace

const RecentSession* resumable(std::span<const RecentSession> recent) {
    const auto it = std::find_if(recent.begin(), recent.end(),
                                 [](const auto& s) { return s.end == End::kInterrupted; });
    return it == recent.end() ? nullptr : &*it;
}

std::vector<const RecentSession*> found(std::span<const RecentSession> recent,
                                        std::string_view search) {
    std::vector<const RecentSession*> result;
    for (const RecentSession& session : recent) {
        const std::string text = lower(session.name + "\n" + session.kind + "\n" + session.cell +
                                       "\n" + session.sentence);
        std::istringstream words(lower(search));
        bool all = true;
        for (std::string word; words >> word;) all = all && text.find(word) != std::string::npos;
        if (all) result.push_back(&session);
    }
    return result;
}

std::string steps_text(const RecentSession& session) {
    if (session.steps_total <= 0) return "–";
    return fmt::format("{} / {}", session.steps_done, session.steps_total);
}

ClosureText closure_text(const RecentSession& session) {
    if (!session.closure_deg) return {session.end == End::kMissing ? "" : "not closed", {}};
    ClosureText text{fmt::format("{:.2f}°", *session.closure_deg), {}};
    if (session.closure_mm) text.shift = fmt::format("{:.2f} mm", *session.closure_mm);
    return text;
}

std::string day_and_time(std::chrono::system_clock::time_point when) {
    constexpr std::array kMonths{"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                 "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
    const std::time_t time = std::chrono::system_clock::to_time_t(when);
    std::tm local{};
    if (localtime_r(&time, &local) == nullptr) return "–";
    return fmt::format("{} {} {:02}:{:02}", local.tm_mday,
                       kMonths[static_cast<std::size_t>(local.tm_mon)], local.tm_hour,
                       local.tm_min);
}

std::string resume_label(const RecentSession& session) {
    return fmt::format("Resume at step {}", session.steps_done + 1);
}

std::vector<Request> requests_of_click(const RecentSession& session) {
    switch (session.end) {
        case End::kMissing:
            return {};
        case End::kInterrupted:
            return {request::Resume{session.folder}};
        case End::kComplete:
        case End::kCheck:
        case End::kRejected:
            break;
    }
    return {request::Open{session.folder}};
}

SessionWish simulated_wish() {
    return {};
}

}  // namespace gripscan::ui
