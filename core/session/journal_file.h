// The journal of a session: one JSON object a line, each with a check sum, safe on the disk before
// the call returns. Reading stops at a line that was cut by a crash; such a tail is dropped when
// the journal is opened for writing again.
#pragma once

#include <filesystem>
#include <vector>

#include "core/procedure/journal.h"

namespace gripscan {

struct JournalEntry {
    int number = 0;    ///< 1, 2, … without gaps
    std::string time;  ///< UTC, ISO 8601
    std::string event;
    JournalFields fields;
};

struct JournalContent {
    std::vector<JournalEntry> entries;
    std::size_t whole_bytes = 0;  ///< up to the end of the last whole line
};

/// An absent file is an empty journal. A damaged line before the last one is an error that names
/// it.
[[nodiscard]] Result<JournalContent> read_journal(const std::filesystem::path& path);

class JournalFile : public Journal {
  public:
    [[nodiscard]] static Result<JournalFile> open(const std::filesystem::path& path);
    JournalFile(JournalFile&& other) noexcept;
    JournalFile& operator=(JournalFile&&) = delete;
    JournalFile(const JournalFile&) = delete;
    JournalFile& operator=(const JournalFile&) = delete;
    ~JournalFile() override;

    [[nodiscard]] Status write(std::string_view event, const JournalFields& fields) override;

  private:
    JournalFile(std::filesystem::path path, int descriptor, int last_number)
        : path_(std::move(path)), descriptor_(descriptor), last_number_(last_number) {}

    std::filesystem::path path_;
    int descriptor_ = -1;
    int last_number_ = 0;
};

}  // namespace gripscan
