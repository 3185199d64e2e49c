#include "ui/memory/recent_sessions.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "ui/memory/session_line.h"
#include "ui/memory/user_folder.h"

namespace gripscan::ui {
namespace {
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Clock = std::chrono::system_clock;

constexpr std::string_view kFormat = "gripscan-recent/1";

struct Stored {
    fs::path folder;
    Clock::time_point used;
};

fs::path file_in(const fs::path& folder) {
    return folder / "recent.json";
}

Result<std::vector<Stored>> parse(const fs::path& path, const std::string& text) {
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object() || !json.contains("format") || json["format"] != kFormat) {
        return input_error(
            "{}: no list of recent sessions of this version ({}); remove it to begin "
            "a new one",
            path.string(), kFormat);
    }
    std::vector<Stored> stored;
    try {
        for (const Json& one : json.at("sessions")) {
            stored.push_back(
                {one.at("folder").get<std::string>(),
                 Clock::time_point(std::chrono::seconds(one.at("used_s").get<std::int64_t>()))});
        }
    } catch (const Json::exception& e) {
        return input_error("{}: not as expected: {}; remove it to begin a new one", path.string(),
                           e.what());
    }
    return stored;
}

Result<std::vector<Stored>> read(const fs::path& path) {
    std::error_code code;
    if (!fs::exists(path, code)) return std::vector<Stored>{};
    const auto text = read_whole_file(path);
    if (!text) return forward_error(text.error());
    return parse(path, *text);
}

Status write(const fs::path& path, const std::vector<Stored>& stored) {
    Json json{{"format", kFormat}, {"sessions", Json::array()}};
    for (const Stored& one : stored) {
        json["sessions"].push_back({{"folder", one.folder.string()},
                                    {"used_s", std::chrono::duration_cast<std::chrono::seconds>(
                                                   one.used.time_since_epoch())
                                                   .count()}});
    }
    std::error_code code;
    fs::create_directories(path.parent_path(), code);
    if (code) return input_error("{}: {}", path.parent_path().string(), code.message());
    return write_file_atomically(path,
                                 json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

fs::path plain(const fs::path& session) {
    std::error_code code;
    const fs::path whole = fs::absolute(session, code).lexically_normal();
    return whole.has_filename() ? whole : whole.parent_path();
}

}  // namespace

std::optional<fs::path> state_folder() {
    return user_folder("XDG_STATE_HOME", ".local/state");
}

Result<std::vector<RecentSession>> RecentSessions::list() const {
    const auto stored = read(file_in(folder_));
    if (!stored) return forward_error(stored.error());
    std::vector<RecentSession> lines;
    for (const Stored& one : *stored) {
        lines.push_back(session_line(one.folder));
        lines.back().last_used = one.used;
    }
    return lines;
}

Status RecentSessions::add(const fs::path& session, Clock::time_point when) {
    auto stored = read(file_in(folder_)).value_or(std::vector<Stored>{});
    const fs::path whole = plain(session);
    std::erase_if(stored, [&](const Stored& one) { return one.folder == whole; });
    stored.insert(stored.begin(), {whole, when});
    if (stored.size() > kMost) stored.resize(kMost);
    return write(file_in(folder_), stored);
}

Status RecentSessions::forget(const fs::path& session) {
    auto stored = read(file_in(folder_));
    if (!stored) return forward_error(stored.error());
    const fs::path whole = plain(session);
    if (std::erase_if(*stored, [&](const Stored& one) { return one.folder == whole; }) == 0) {
        return {};
    }
    return write(file_in(folder_), *stored);
}

}  // namespace gripscan::ui
