#include "core/session/folder_lock.h"

#include <gmock/gmock.h>
#include <signal.h>

#include "tests/support/child_process.h"
#include "tests/support/temporary_folder.h"

namespace gripscan {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST(FolderLock, IsHeldByOneAndFreeAgainAfterwards) {
    const test::TemporaryFolder folder;
    {
        const auto lock = FolderLock::take(folder.path());
        ASSERT_TRUE(lock) << lock.error().message;
        EXPECT_FALSE(FolderLock::take(folder.path())) << "not twice in one process either";
    }
    EXPECT_TRUE(fs::is_empty(folder.path()));
    EXPECT_TRUE(FolderLock::take(folder.path()));
}

TEST(FolderLock, ASecondProcessIsToldWhoHoldsIt) {
    const test::TemporaryFolder folder;
    const auto lock = FolderLock::take(folder.path());
    ASSERT_TRUE(lock);
    const std::string holder = fmt::format("process {}", ::getpid());
    test::in_child([&] {
        const auto second = FolderLock::take(folder.path());
        ASSERT_FALSE(second);
        EXPECT_THAT(second.error().message, HasSubstr(folder.path().string()));
        EXPECT_THAT(second.error().message, HasSubstr(holder));
    });
    EXPECT_TRUE(fs::exists(folder / std::string(FolderLock::kFileName)))
        << "the one who failed leaves the holder's file alone";
}

TEST(FolderLock, OfAKilledProcessNeverBlocks) {
    const test::TemporaryFolder folder;
    const pid_t child = ::fork();
    if (child == 0) {
        const auto lock = FolderLock::take(folder.path());
        ::kill(::getpid(), SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_TRUE(fs::exists(folder / std::string(FolderLock::kFileName)));
    const auto lock = FolderLock::take(folder.path());
    EXPECT_TRUE(lock) << lock.error().message;
}

/// Taking, removing and taking again race here; two holders at a time would meet in the file.
TEST(FolderLock, ManyProcessesNeverHoldItTogether) {
    const test::TemporaryFolder folder;
    const fs::path inside = folder / "inside";
    std::vector<pid_t> children;
    for (int i = 0; i < 4; ++i) {
        children.push_back(::fork());
        if (children.back() != 0) continue;
        int met = 0;
        for (int taken = 0; taken < 50;) {
            const auto lock = FolderLock::take(folder.path());
            if (!lock) continue;
            ++taken;
            if (!fs::create_directory(inside)) ++met;
            fs::remove(inside);
        }
        ::_exit(met == 0 ? 0 : 1);
    }
    for (const pid_t child : children) {
        int status = 1;
        ASSERT_EQ(::waitpid(child, &status, 0), child);
        EXPECT_EQ(status, 0);
    }
}

TEST(FolderLock, AFolderThatIsNotThereIsNamed) {
    const test::TemporaryFolder folder;
    const auto lock = FolderLock::take(folder / "absent");
    ASSERT_FALSE(lock);
    EXPECT_THAT(lock.error().message, HasSubstr("absent"));
}

}  // namespace
}  // namespace gripscan
