#include "core/base/atomic_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <fstream>

#include "tests/support/child_process.h"
#include "tests/support/temporary_folder.h"

namespace gripscan {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using testing::HasSubstr;

std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) {
        names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

void write_plainly(const fs::path& path, const std::string& text) {
    std::ofstream(path) << text;
}

TEST(AtomicFile, WritesAndReplacesTheWholeContent) {
    const TemporaryFolder folder;
    const auto path = folder / "a.txt";
    const std::string binary("one\0two\r\n\xff", 10);
    ASSERT_TRUE(write_file_atomically(path, std::string_view("a longer first content")));
    ASSERT_TRUE(write_file_atomically(path, std::string_view(binary)));
    EXPECT_EQ(read_whole_file(path).value(), binary);
    EXPECT_EQ(names_in(folder.path()), (std::vector<std::string>{"a.txt"}));
}

TEST(AtomicFile, AFailedWriterLeavesTheOldFileAndNothingElse) {
    const TemporaryFolder folder;
    const auto path = folder / "a.txt";
    write_plainly(path, "old");
    const Status status = write_file_atomically(path, [](const fs::path& temporary) -> Status {
        write_plainly(temporary, "half of the n");
        return input_error("no more ideas");
    });
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().message, "no more ideas");
    EXPECT_EQ(read_whole_file(path).value(), "old");
    EXPECT_EQ(names_in(folder.path()), (std::vector<std::string>{"a.txt"}));
}

TEST(AtomicFile, TheWriterGetsTheSameExtensionInTheSameFolder) {
    const TemporaryFolder folder;
    ASSERT_TRUE(write_file_atomically(folder / "image.png", [&](const fs::path& temporary) {
        EXPECT_EQ(temporary.extension(), ".png");
        EXPECT_EQ(temporary.parent_path(), folder.path());
        EXPECT_NE(temporary.filename(), "image.png");
        write_plainly(temporary, "x");
        return Status{};
    }));
    EXPECT_TRUE(fs::exists(folder / "image.png"));
}

TEST(AtomicFile, AFolderThatIsNotThereIsNamed) {
    const TemporaryFolder folder;
    const auto path = folder / "absent" / "a.txt";
    const Status status = write_file_atomically(path, std::string_view("x"));
    ASSERT_FALSE(status);
    EXPECT_THAT(status.error().message, HasSubstr(path.string()));
    EXPECT_FALSE(fs::exists(folder / "absent"));
}

TEST(AtomicFile, AFullDiskIsAnErrorAndNotAShortFile) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
    const TemporaryFolder folder;
    const auto path = folder / "a.txt";
    write_plainly(path, "old");
    const Status status = write_file_atomically(path, [](const fs::path&) -> Status {
        std::ofstream full("/dev/full");
        full << std::string(100000, 'x') << std::flush;
        if (!full) return input_error("disk full");
        return {};
    });
    ASSERT_FALSE(status);
    EXPECT_EQ(read_whole_file(path).value(), "old");
}

/// The disk ends in the middle of the text, at every kind of place.
TEST(AtomicFile, AWriteThatIsCutShortLeavesTheOldFileAndNothingElse) {
    const TemporaryFolder folder;
    const auto path = folder / "a.txt";
    write_plainly(path, "old");
    for (const rlim_t bytes : {1, 4095, 4096, 70000, 99999}) {
        test::in_child([&] {
            ::signal(SIGXFSZ, SIG_IGN);
            const rlimit limit{bytes, bytes};
            ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
            const Status status = write_file_atomically(path, std::string(100000, 'x'));
            ASSERT_FALSE(status) << bytes;
            EXPECT_THAT(status.error().message, HasSubstr("a.txt"));
        });
        EXPECT_EQ(read_whole_file(path).value(), "old");
        EXPECT_EQ(names_in(folder.path()), (std::vector<std::string>{"a.txt"}));
    }
}

TEST(AtomicFile, LeftoversOfDeadProgramsGoAndAllElseStays) {
    const TemporaryFolder folder;
    const std::string running = fmt::format(".table.{}.part.csv", ::getppid());
    const std::string own = fmt::format(".table.{}.part.csv", ::getpid());
    const std::vector<std::string> others{".gitignore",       ".part", ".a.part", ".a.b.part.csv",
                                          "a.999999999.part", running};
    for (const auto& name : others) write_plainly(folder / name, "x");
    for (const std::string name : {".a.999999999.part.csv", ".a b.c.999999999.part", own.c_str()}) {
        EXPECT_TRUE(is_temporary_name(name)) << name;
        write_plainly(folder / name, "x");
    }
    fs::create_directories(folder / ".results.999999999.part/inner");
    remove_dead_leftovers(folder.path());
    std::vector<std::string> expected = others;
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(names_in(folder.path()), expected);
}

TEST(ReplaceFolder, ComesWholeOrNotAtAll) {
    const TemporaryFolder folder;
    const auto target = folder / "results";
    const auto fill_with = [](const std::string& name) {
        return [name](const fs::path& fresh) {
            write_plainly(fresh / name, name);
            fs::create_directory(fresh / "inner");
            write_plainly(fresh / "inner" / name, name);
            return Status{};
        };
    };
    ASSERT_TRUE(replace_folder_atomically(target, fill_with("one")));
    EXPECT_EQ(names_in(target), (std::vector<std::string>{"inner", "one"}));
    ASSERT_TRUE(replace_folder_atomically(target / "", fill_with("two")));
    EXPECT_EQ(names_in(target), (std::vector<std::string>{"inner", "two"}));

    const Status status = replace_folder_atomically(target, [](const fs::path& fresh) -> Status {
        write_plainly(fresh / "three", "three");
        return cancelled_error();
    });
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().kind, ErrorKind::kCancelled);
    EXPECT_EQ(names_in(target), (std::vector<std::string>{"inner", "two"}));
    EXPECT_EQ(names_in(folder.path()), (std::vector<std::string>{"results"}));
}

TEST(ReadWholeFile, SaysWhatIsWrong) {
    const TemporaryFolder folder;
    EXPECT_THAT(read_whole_file(folder / "absent").error().message, HasSubstr("No such file"));
    EXPECT_THAT(read_whole_file(folder.path()).error().message, HasSubstr("folder"));
    write_plainly(folder / "empty", "");
    EXPECT_EQ(read_whole_file(folder / "empty").value(), "");
}

}  // namespace
}  // namespace gripscan
