#include "core/session/journal_file.h"

#include <gmock/gmock.h>

#include "core/base/checksum.h"
#include "core/base/seeded_random.h"
#include "tests/support/temporary_folder.h"

namespace gripscan {
namespace {

using testing::HasSubstr;

void write_three(const std::filesystem::path& path) {
    auto journal = JournalFile::create(path, "0.2.0");
    ASSERT_TRUE(journal) << journal.error().message;
    ASSERT_TRUE(journal->write("command", {{"verb", "run"}, {"path", "a \"b\"\nc ü"}}));
    ASSERT_TRUE(journal->write("capture", {{"index", "0"}}));
    ASSERT_TRUE(journal->write("result", {}));
}

TEST(JournalFile, ReadsWhatItWrote) {
    const test::TemporaryFolder folder;
    write_three(folder / "journal");
    const auto content = read_journal(folder / "journal");
    ASSERT_TRUE(content) << content.error().message;
    ASSERT_EQ(content->entries.size(), 3u);
    EXPECT_EQ(content->entries[0].event, "command");
    EXPECT_EQ(content->entries[0].fields[1].second, "a \"b\"\nc ü");
    EXPECT_EQ(content->entries[2].number, 4);
    EXPECT_EQ(content->header->format, "gripscan-journal/2");
    EXPECT_EQ(content->header->program, "0.2.0");
    EXPECT_EQ(content->whole_bytes, std::filesystem::file_size(folder / "journal"));
}

TEST(JournalFile, AnAbsentFileIsAnEmptyJournal) {
    const test::TemporaryFolder folder;
    const auto content = read_journal(folder / "journal");
    ASSERT_TRUE(content);
    EXPECT_TRUE(content->empty());
    EXPECT_FALSE(JournalFile::open(folder / "journal")) << "nothing to go on with";
}

TEST(JournalFile, IsBegunOnce) {
    const test::TemporaryFolder folder;
    write_three(folder / "journal");
    const std::string text = test::read_text(folder / "journal");
    EXPECT_FALSE(JournalFile::create(folder / "journal", "0.2.0"));
    EXPECT_EQ(test::read_text(folder / "journal"), text);
    test::write_text(folder / "torn", text.substr(0, 20));
    EXPECT_TRUE(JournalFile::create(folder / "torn", "0.2.0")) << "a cut line is none";
    EXPECT_TRUE(read_journal(folder / "torn")->header);
}

/// A line whose check sum is right but whose parts are of other types is damage, not a crash.
TEST(JournalFile, SurvivesLinesThatOthersWrote) {
    const test::TemporaryFolder folder;
    for (const std::string line :
         {R"({"n":"1","t":"","event":"a"})", R"({"n":1,"t":2,"event":"a"})",
          R"({"n":1,"t":"","event":"a","data":[1]})",
          R"({"n":1,"t":"","event":"a","data":{"b":1}})", R"({"t":"","event":"a"})", R"([1])",
          R"(7)"}) {
        std::string whole = line;
        if (whole.ends_with('}')) {
            whole.pop_back();
            whole += ",\"check\":\"" + checksum_text(line) + "\"}";
        }
        test::write_text(folder / "journal", whole + "\nmore\n");
        const auto content = read_journal(folder / "journal");
        ASSERT_FALSE(content) << line;
        EXPECT_THAT(content.error().message, HasSubstr("journal:1"));
    }
}

/// Whatever text a field holds, it comes back, and the line stays one line.
TEST(JournalFile, FieldsOfAnyTextComeBack) {
    const test::TemporaryFolder folder;
    SeededRandom random(7);
    std::vector<JournalFields> written;
    auto journal = JournalFile::create(folder / "journal", "0.2.0");
    ASSERT_TRUE(journal);
    for (int i = 0; i < 50; ++i) {
        std::string text;
        for (int k = 0; k < i; ++k) text += static_cast<char>(random.next() % 128);
        written.push_back({{"a", text}, {"", "ü°"}});
        ASSERT_TRUE(journal->write("event", written.back()));
    }
    const auto content = read_journal(folder / "journal");
    ASSERT_TRUE(content) << content.error().message;
    ASSERT_EQ(content->entries.size(), written.size());
    for (std::size_t i = 0; i < written.size(); ++i) {
        EXPECT_EQ(content->entries[i].fields, written[i]) << i;
    }
}

/// Whatever byte a crash stopped at, all whole lines are there and writing goes on.
TEST(JournalFile, SurvivesACutAtEveryByteOfTheLastLine) {
    const test::TemporaryFolder folder;
    write_three(folder / "whole");
    const std::string whole = test::read_text(folder / "whole");
    const auto last_line = whole.rfind('\n', whole.size() - 2) + 1;
    for (std::size_t cut = last_line; cut < whole.size(); ++cut) {
        test::write_text(folder / "journal", whole.substr(0, cut));
        {
            auto journal = JournalFile::open(folder / "journal");
            ASSERT_TRUE(journal) << cut << ": " << journal.error().message;
            ASSERT_TRUE(journal->write("resumed", {}));
        }
        const auto content = read_journal(folder / "journal");
        ASSERT_TRUE(content) << cut << ": " << content.error().message;
        ASSERT_EQ(content->entries.size(), 3u) << cut;
        EXPECT_EQ(content->entries[2].event, "resumed");
        EXPECT_EQ(content->entries[2].number, 4);
    }
}

TEST(JournalFile, NamesADamagedLineThatOthersFollow) {
    const test::TemporaryFolder folder;
    write_three(folder / "journal");
    test::replace_in_file(folder / "journal", "\"index\":\"0\"", "\"index\":\"1\"");
    const auto content = read_journal(folder / "journal");
    ASSERT_FALSE(content);
    EXPECT_THAT(content.error().message, HasSubstr("journal:3"));
    EXPECT_FALSE(JournalFile::open(folder / "journal")) << "nothing is appended to a damaged one";
}

TEST(JournalFile, AMissingLineIsDamage) {
    const test::TemporaryFolder folder;
    write_three(folder / "journal");
    std::string text = test::read_text(folder / "journal");
    const auto first_end = text.find('\n') + 1;
    const auto second_end = text.find('\n', first_end) + 1;
    test::write_text(folder / "journal",
                     text.erase(first_end, second_end - first_end) + text.substr(first_end));
    EXPECT_FALSE(read_journal(folder / "journal"));
}

}  // namespace
}  // namespace gripscan
