#include "core/session/journal_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <ctime>

#include "core/base/atomic_file.h"
#include "core/session/journal_line.h"

namespace gripscan {
namespace {
namespace fs = std::filesystem;

constexpr std::string_view kFormat = "gripscan-journal/2";
constexpr std::string_view kHeaderEvent = "journal";

std::string utc_now() {
    std::timespec now{};
    std::timespec_get(&now, TIME_UTC);
    std::tm parts{};
    gmtime_r(&now.tv_sec, &parts);
    return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z", parts.tm_year + 1900,
                       parts.tm_mon + 1, parts.tm_mday, parts.tm_hour, parts.tm_min, parts.tm_sec,
                       now.tv_nsec / 1'000'000);
}

std::string field(const JournalEntry& entry, std::string_view name) {
    for (const auto& [key, value] : entry.fields) {
        if (key == name) return value;
    }
    return "";
}

Error cannot_write(const fs::path& path) {
    const int why = errno;
    const bool space = why == ENOSPC || why == EDQUOT || why == EFBIG;
    return input_error("cannot write {}: {}{}", path.string(), std::strerror(why),
                       space ? "; is the disk full?" : "")
        .value();
}

Status write_all(int descriptor, std::string_view bytes, const fs::path& path) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return forward_error(cannot_write(path));
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
        auto entry = parse_journal_line(text->substr(at, end - at));
        const int number = content.last_number() + 1;
        if (!entry || entry->number != number) {
            if (end + 1 >= text->size()) break;
            return input_error("{}:{}: the line is damaged, but others follow it", path.string(),
                               number);
        }
        if (number == 1 && entry->event == kHeaderEvent) {
            content.header = {field(*entry, "format"), field(*entry, "program")};
        } else {
            content.entries.push_back(std::move(*entry));
        }
        at = end + 1;
        content.whole_bytes = at;
    }
    return content;
}

Status check_journal_version(const fs::path& path, const JournalContent& content) {
    if (content.header && content.header->format == kFormat) return {};
    if (content.empty()) return input_error("{}: there is no journal", path.string());
    if (content.header) {
        return input_error("{}: written as {} by gripscan {}; this version goes on with {}",
                           path.string(), content.header->format, content.header->program, kFormat);
    }
    return input_error("{}: written by gripscan {}, whose journals cannot be resumed",
                       path.string(),
                       content.entries.empty() ? "0.1" : field(content.entries.front(), "version"));
}

Result<JournalFile> JournalFile::create(const fs::path& path, std::string_view program_version,
                                        std::span<const JournalRecord> opening) {
    const auto content = read_journal(path);
    if (!content) return forward_error(content.error());
    if (!content->empty()) return input_error("{}: there is a journal already", path.string());
    std::string text = journal_line(
        {1,
         utc_now(),
         std::string(kHeaderEvent),
         {{"format", std::string(kFormat)}, {"program", std::string(program_version)}}});
    for (int number = 2; const JournalRecord& record : opening) {
        text += journal_line({number++, utc_now(), record.event, record.fields});
    }
    if (Status status = write_file_atomically(path, text); !status) {
        return forward_error(status.error());
    }
    return open(path);
}

Result<JournalFile> JournalFile::open(const fs::path& path) {
    const auto content = read_journal(path);
    if (!content) return forward_error(content.error());
    if (Status status = check_journal_version(path, *content); !status) {
        return forward_error(status.error());
    }
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
    if (descriptor < 0) return forward_error(cannot_write(path));
    JournalFile journal(path, descriptor, *content);
    if (::ftruncate(descriptor, static_cast<off_t>(content->whole_bytes)) != 0) {
        return forward_error(cannot_write(path));
    }
    return journal;
}

JournalFile::JournalFile(JournalFile&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      whole_bytes_(other.whole_bytes_),
      last_number_(other.last_number_),
      broken_(other.broken_) {}

JournalFile::~JournalFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

Status JournalFile::take_back(Error why, bool keep_going) {
    const bool whole = ::ftruncate(descriptor_, static_cast<off_t>(whole_bytes_)) == 0;
    broken_ = !whole || !keep_going;
    return forward_error(std::move(why));
}

Status JournalFile::write(std::string_view event, const JournalFields& fields) {
    if (broken_) {
        return input_error("{}: a write has failed before; check the disk, then resume the session",
                           path_.string());
    }
    const std::string line =
        journal_line({last_number_ + 1, utc_now(), std::string(event), fields});
    if (Status status = write_all(descriptor_, line, path_); !status) {
        return take_back(status.error(), true);
    }
    if (::fsync(descriptor_) != 0) return take_back(cannot_write(path_), false);
    ++last_number_;
    whole_bytes_ += line.size();
    return {};
}

}  // namespace gripscan
