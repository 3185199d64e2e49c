#include "core/session/journal_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <ctime>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/checksum.h"

namespace gripscan {
namespace {
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr auto kReplaceBadUtf8 = Json::error_handler_t::replace;

std::string utc_now() {
    std::timespec now{};
    std::timespec_get(&now, TIME_UTC);
    std::tm parts{};
    gmtime_r(&now.tv_sec, &parts);
    return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z", parts.tm_year + 1900,
                       parts.tm_mon + 1, parts.tm_mday, parts.tm_hour, parts.tm_min, parts.tm_sec,
                       now.tv_nsec / 1'000'000);
}

std::string text_of(const Json& json) {
    return json.dump(-1, ' ', false, kReplaceBadUtf8);
}

std::string line_of(const JournalEntry& entry) {
    Json json{{"n", entry.number}, {"t", entry.time}, {"event", entry.event}};
    for (const auto& [name, value] : entry.fields) json["data"][name] = value;
    json["check"] = checksum_text(text_of(json));
    return text_of(json) + "\n";
}

/// Nothing if the line is not what line_of() writes.
std::optional<JournalEntry> entry_of(const std::string& line) {
    Json json = Json::parse(line, nullptr, false);
    if (!json.is_object() || !json.contains("check")) return std::nullopt;
    const Json check = json["check"];
    json.erase("check");
    if (check != checksum_text(text_of(json))) return std::nullopt;
    JournalEntry entry;
    entry.number = json.value("n", 0);
    entry.time = json.value("t", "");
    entry.event = json.value("event", "");
    if (json.contains("data")) {
        for (const auto& [name, value] : json["data"].items()) {
            entry.fields.emplace_back(name, value.get<std::string>());
        }
    }
    return entry;
}

Status cannot_write(const fs::path& path) {
    return input_error("cannot write {}: {}", path.string(), std::strerror(errno));
}

Status write_all(int descriptor, std::string_view bytes, const fs::path& path) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return cannot_write(path);
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return {};
}

}  // namespace

Result<JournalContent> read_journal(const fs::path& path) {
    JournalContent content;
    std::error_code code;
    if (!fs::exists(path, code)) return content;
    const auto text = read_whole_file(path);
    if (!text) return forward_error(text.error());
    for (std::size_t at = 0; at < text->size();) {
        const auto end = text->find('\n', at);
        if (end == std::string::npos) break;
        auto entry = entry_of(text->substr(at, end - at));
        const int number = static_cast<int>(content.entries.size()) + 1;
        if (!entry || entry->number != number) {
            if (end + 1 >= text->size()) break;
            return input_error("{}:{}: the line is damaged, but others follow it", path.string(),
                               number);
        }
        content.entries.push_back(std::move(*entry));
        at = end + 1;
        content.whole_bytes = at;
    }
    return content;
}

Result<JournalFile> JournalFile::open(const fs::path& path) {
    const auto content = read_journal(path);
    if (!content) return forward_error(content.error());
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
    if (descriptor < 0) return forward_error(cannot_write(path).error());
    JournalFile journal(path, descriptor, static_cast<int>(content->entries.size()));
    if (::ftruncate(descriptor, static_cast<off_t>(content->whole_bytes)) != 0) {
        return forward_error(cannot_write(path).error());
    }
    return journal;
}

JournalFile::JournalFile(JournalFile&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      last_number_(other.last_number_) {}

JournalFile::~JournalFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

Status JournalFile::write(std::string_view event, const JournalFields& fields) {
    const JournalEntry entry{last_number_ + 1, utc_now(), std::string(event), fields};
    if (Status status = write_all(descriptor_, line_of(entry), path_); !status) return status;
    if (::fsync(descriptor_) != 0) return cannot_write(path_);
    ++last_number_;
    return {};
}

}  // namespace gripscan
