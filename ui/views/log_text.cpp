#include "ui/views/log_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <ctime>

namespace gripscan::ui {
namespace {

bool same_letter(char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) ==
           std::tolower(static_cast<unsigned char>(b));
}
bool contains(std::string_view text, std::string_view part) {
    return std::search(text.begin(), text.end(), part.begin(), part.end(), same_letter) !=
           text.end();
}

}  // namespace

std::vector<std::size_t> filtered(std::span<const LogLine> log, const LogFilter& filter) {
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < log.size(); ++i) {
        const bool found = filter.search.empty() || contains(log[i].code, filter.search) ||
                           contains(log[i].text, filter.search);
        if (log[i].level >= filter.least && found) shown.push_back(i);
    }
    return shown;
}

std::string clock_text(std::chrono::system_clock::time_point when) {
    const std::time_t time = std::chrono::system_clock::to_time_t(when);
    std::tm local{};
    localtime_r(&time, &local);
    return fmt::format("{:02}:{:02}:{:02}", local.tm_hour, local.tm_min, local.tm_sec);
}

State state_of(LogLevel level) {
    constexpr std::array kStates{State::kAccept, State::kCheck, State::kReject};
    return kStates[static_cast<std::size_t>(level)];
}

std::string log_for_clipboard(std::span<const LogLine> log, const LogFilter& filter) {
    constexpr std::array<std::string_view, 3> kLevels{"information", "warning", "error"};
    std::string text;
    for (const std::size_t i : filtered(log, filter)) {
        text +=
            fmt::format("{}\t{}\t{}\t{}\n", clock_text(log[i].when),
                        kLevels[static_cast<std::size_t>(log[i].level)], log[i].code, log[i].text);
    }
    return text;
}

std::string_view word_at_least(LogLevel level) {
    constexpr std::array<std::string_view, 3> kWords{"all levels", "warnings", "errors"};
    return kWords[static_cast<std::size_t>(level)];
}

LogLevel worst_of(std::span<const LogLine> log) {
    LogLevel worst = LogLevel::kInformation;
    for (const LogLine& line : log) worst = std::max(worst, line.level);
    return worst;
}

}  // namespace gripscan::ui
