// The journal of a session: one JSON object a line, each with a check sum, safe on the disk before
// the call returns. The first line says in which version it is written. Reading stops at a line
// that was cut by a crash; such a tail is dropped when the journal is opened for writing again.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "core/procedure/journal_codec.h"

namespace gripscan {

struct JournalEntry {
    int number = 0;    ///< 1, 2, … without gaps; the line of the file
    std::string time;  ///< UTC, ISO 8601
    std::string event;
    JournalFields fields;
};

/// The first line of a journal, event "journal".
struct JournalHeader {
    std::string format;   ///< "gripscan-journal/2"
    std::string program;  ///< version of the program that began it
};

struct JournalContent {
    std::optional<JournalHeader> header;  ///< nothing: of version 0.1, or empty
    std::vector<JournalEntry> entries;    ///< without the header
    std::size_t whole_bytes = 0;          ///< up to the end of the last whole line

    [[nodiscard]] bool empty() const { return whole_bytes == 0; }
    [[nodiscard]] int last_number() const {
        return static_cast<int>(entries.size()) + (header ? 1 : 0);
    }
};

/// An absent file is an empty journal. A damaged line before the last one is an error that names
/// it.
[[nodiscard]] Result<JournalContent> read_journal(const std::filesystem::path& path);

class JournalFile : public Journal {
  public:
    /// Begins one with these entries; a crash leaves all of them or no journal. Error: there is one
    /// already.
    [[nodiscard]] static Result<JournalFile> create(const std::filesystem::path& path,
                                                    std::string_view program_version,
                                                    std::span<const JournalRecord> opening = {});
    /// Goes on with one. Errors: absent, damaged, of another version.
    [[nodiscard]] static Result<JournalFile> open(const std::filesystem::path& path);
    JournalFile(JournalFile&& other) noexcept;
    JournalFile& operator=(JournalFile&&) = delete;
    JournalFile(const JournalFile&) = delete;
    JournalFile& operator=(const JournalFile&) = delete;
    ~JournalFile() override;

    /// On failure the journal is as before and can be written to once there is space; after a
    /// failed sync it refuses: what lies on the disk is unknown until it is opened again.
    [[nodiscard]] Status write(std::string_view event, const JournalFields& fields) override;

  private:
    JournalFile(std::filesystem::path path, int descriptor, const JournalContent& content)
        : path_(std::move(path)),
          descriptor_(descriptor),
          whole_bytes_(content.whole_bytes),
          last_number_(content.last_number()) {}
    [[nodiscard]] Status take_back(Error why, bool keep_going);

    std::filesystem::path path_;
    int descriptor_ = -1;
    std::size_t whole_bytes_ = 0;
    int last_number_ = 0;
    bool broken_ = false;
};

/// Why a journal with this content cannot be gone on with; nothing: it can.
[[nodiscard]] Status check_journal_version(const std::filesystem::path& path,
                                           const JournalContent& content);

}  // namespace gripscan
