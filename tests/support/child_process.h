// A part of a test in a process of its own: to be killed, to hold a lock, or to see disks that only
// it sees.
#pragma once

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

namespace gripscan::test {

/// Runs `body` in a child; what it expects in vain fails the test here.
template <typename Body>
void in_child(const Body& body) {
    std::fflush(nullptr);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        body();
        std::fflush(nullptr);
        ::_exit(testing::Test::HasFailure() ? 1 : 0);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "in the child; status " << status;
}

/// In a child only: what is mounted from now on is seen by this process alone and ends with it.
/// Works for root and, where the system lets users have namespaces, for them.
[[nodiscard]] inline bool own_mounts() {
    const uid_t user = ::getuid();
    const gid_t group = ::getgid();
    if (::unshare(user == 0 ? CLONE_NEWNS : CLONE_NEWUSER | CLONE_NEWNS) != 0) return false;
    if (user != 0) {
        std::ofstream("/proc/self/setgroups") << "deny";
        std::ofstream("/proc/self/uid_map") << "0 " << user << " 1";
        std::ofstream("/proc/self/gid_map") << "0 " << group << " 1";
    }
    return ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0;
}

/// A disk of so many kB at an empty folder.
[[nodiscard]] inline bool mount_small_disk(const std::filesystem::path& at, int kilobytes) {
    const std::string size = "size=" + std::to_string(kilobytes) + "k";
    return ::mount("tmpfs", at.c_str(), "tmpfs", 0, size.c_str()) == 0;
}

/// The folder as it is, but nothing can be written there, not by root either.
[[nodiscard]] inline bool mount_read_only(const std::filesystem::path& folder) {
    return ::mount(folder.c_str(), folder.c_str(), nullptr, MS_BIND, nullptr) == 0 &&
           ::mount(nullptr, folder.c_str(), nullptr, MS_BIND | MS_REMOUNT | MS_RDONLY, nullptr) ==
               0;
}

/// Can children mount at all here?
[[nodiscard]] inline bool mounts_work() {
    const pid_t child = ::fork();
    if (child == 0) {
        const auto at = std::filesystem::temp_directory_path();
        ::_exit(own_mounts() && mount_small_disk(at, 4) ? 0 : 1);
    }
    int status = 1;
    return child > 0 && ::waitpid(child, &status, 0) == child && status == 0;
}

}  // namespace gripscan::test
