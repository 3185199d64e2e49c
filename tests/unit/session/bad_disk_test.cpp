// Disks that are full or read-only: a clear message, nothing damaged.
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/resource.h>

#include "core/base/atomic_file.h"
#include "core/session/resume.h"
#include "tests/support/child_process.h"
#include "tests/support/small_recording.h"
#include "tests/support/temporary_folder.h"

namespace gripscan {
namespace {

namespace fs = std::filesystem;
using test::small_capture;
using test::small_frame;
using test::small_rig;
using testing::HasSubstr;

std::string text_of(int entry) {
    return std::string(static_cast<std::size_t>(50 + entry * 37 % 200), 'x');
}

/// Files of this process end at so many bytes: the write that crosses the limit is cut in the
/// middle, as on a full disk.
void limit_files(rlim_t bytes) {
    ::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    ::getrlimit(RLIMIT_FSIZE, &limit);
    limit.rlim_cur = bytes;
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
}

TEST(BadDisk, AJournalWithoutSpaceKeepsItsWholeLinesAndGoesOnLater) {
    for (const rlim_t bytes : {300, 420, 777, 1500, 4096}) {
        const test::TemporaryFolder folder;
        test::in_child([&] {
            auto journal = JournalFile::create(folder / "journal", "0.2.0");
            ASSERT_TRUE(journal) << journal.error().message;
            limit_files(bytes);
            int written = 0;
            Status status;
            while ((status = journal->write("event", {{"text", text_of(written)}}))) ++written;
            EXPECT_THAT(status.error().message, HasSubstr("journal"));
            EXPECT_THAT(status.error().message, HasSubstr("disk full"));
            EXPECT_FALSE(journal->write("event", {{"text", text_of(written)}}));
            limit_files(RLIM_INFINITY);
            EXPECT_TRUE(journal->write("event", {{"text", text_of(written)}}))
                << "there is space again";
            const auto content = read_journal(folder / "journal");
            ASSERT_TRUE(content) << content.error().message;
            ASSERT_EQ(content->entries.size(), static_cast<std::size_t>(written) + 1);
            EXPECT_EQ(content->whole_bytes, fs::file_size(folder / "journal"));
        });
    }
}

TEST(BadDisk, AFullDiskLeavesTheSessionAsItWas) {
    if (!test::mounts_work()) GTEST_SKIP() << "no disk can be mounted here";
    const test::TemporaryFolder folder;
    test::in_child([&] {
        ASSERT_TRUE(test::own_mounts());
        ASSERT_TRUE(test::mount_small_disk(folder.path(), 100));
        auto store = SessionStore::create(folder / "s", {}, small_rig(), "0.2.0");
        ASSERT_TRUE(store) << store.error().message;
        std::vector<CaptureRecord> safe;
        Status status;
        for (int k = 0; status; ++k) {
            status = store->store_images(k, 1, small_frame(k));
            if (!status) break;
            std::vector<CaptureRecord> table = safe;
            table.push_back(small_capture(k));
            status = store->save_table(table);
            if (status) safe = table;
        }
        EXPECT_THAT(status.error().message, HasSubstr("No space left"));
        const auto session = open_session(folder / "s");
        ASSERT_TRUE(session) << session.error().message;
        EXPECT_EQ(session->table.rows.size(), safe.size());
        EXPECT_TRUE(check_session_files(*session, {}, for_each_in_order));
        for (const auto& entry : fs::recursive_directory_iterator(folder / "s")) {
            EXPECT_FALSE(is_temporary_name(entry.path().filename().string())) << entry.path();
        }
    });
}

TEST(BadDisk, ACreationWithoutSpaceLeavesNothing) {
    if (!test::mounts_work()) GTEST_SKIP() << "no disk can be mounted here";
    // A page a file, lock, rig.yaml, session.yaml, journal: full at every stage of the creation.
    for (int pages = 1; pages < 4; ++pages) {
        const test::TemporaryFolder folder;
        test::in_child([&] {
            ASSERT_TRUE(test::own_mounts());
            ASSERT_TRUE(test::mount_small_disk(folder.path(), 4 * pages));
            const auto store = SessionStore::create(folder / "s", {}, small_rig(), "0.2.0");
            ASSERT_FALSE(store) << pages;
            EXPECT_THAT(store.error().message, HasSubstr("No space left"));
            EXPECT_TRUE(is_fresh_session(folder / "s")) << pages;
        });
    }
}

TEST(BadDisk, AReadOnlyFolderIsNamedAndUntouched) {
    if (!test::mounts_work()) GTEST_SKIP() << "no disk can be mounted here";
    const test::TemporaryFolder folder;
    {
        auto store = SessionStore::create(folder / "s", {}, small_rig(), "0.2.0");
        ASSERT_TRUE(store);
        ASSERT_TRUE(store->journal().write("command", {{"verb", "connect"}}));
    }
    test::in_child([&] {
        ASSERT_TRUE(test::own_mounts());
        ASSERT_TRUE(test::mount_read_only(folder.path()));
        const auto fresh = SessionStore::create(folder / "new", {}, small_rig(), "0.2.0");
        ASSERT_FALSE(fresh);
        EXPECT_THAT(fresh.error().message, HasSubstr((folder / "new").string()));
        EXPECT_THAT(fresh.error().message, HasSubstr("Read-only"));
        const auto resumed = resume_session(folder / "s");
        ASSERT_FALSE(resumed);
        EXPECT_THAT(resumed.error().message, HasSubstr((folder / "s").string()));
        EXPECT_THAT(resumed.error().message, HasSubstr("Read-only"));
        const auto memory = open_memory(folder / "s");
        ASSERT_TRUE(memory) << memory.error().message;
        EXPECT_EQ(memory->entries.size(), 1u) << "it can still be read";
    });
}

}  // namespace
}  // namespace gripscan
