#include "core/session/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <optional>

#include "core/base/number_text.h"

namespace gripscan {
namespace {
namespace fs = std::filesystem;

tl::unexpected<Error> cannot_lock(const fs::path& folder, int why) {
    const char* advice = "a session needs a folder that may be written to";
    if (why == ENOSPC) advice = "is the disk full?";
    if (why == ENOLCK || why == EOPNOTSUPP || why == ENOSYS) {
        advice = "its file system knows no locks; record on a local disk";
    }
    return input_error("cannot open the session {} for writing: {}; {}", folder.string(),
                       std::strerror(why), advice);
}

tl::unexpected<Error> is_taken(const fs::path& folder, int descriptor) {
    std::array<char, 16> text{};
    const ssize_t length = ::pread(descriptor, text.data(), text.size(), 0);
    const auto pid = number_from_text(
        std::string_view(text.data(), static_cast<std::size_t>(std::max<ssize_t>(length, 0))));
    return input_error(
        "the session {} is open in another program{}; only one may write it: end that one, or "
        "choose another folder",
        folder.string(), pid ? fmt::format(" (process {:.0f})", *pid) : "");
}

/// Not if another program has removed the file since it was opened.
bool is_still(const fs::path& path, int descriptor) {
    struct stat by_name {};
    struct stat opened {};
    return ::stat(path.c_str(), &by_name) == 0 && ::fstat(descriptor, &opened) == 0 &&
           by_name.st_dev == opened.st_dev && by_name.st_ino == opened.st_ino;
}

/// For messages of others only: a disk too full for it does no harm.
void write_pid(int descriptor) {
    const std::string text = fmt::format("{}", ::getpid());
    if (::ftruncate(descriptor, 0) != 0) return;
    [[maybe_unused]] const ssize_t written = ::pwrite(descriptor, text.data(), text.size(), 0);
}

}  // namespace

Result<FolderLock> FolderLock::take(const fs::path& folder) {
    const fs::path path = folder / kFileName;
    while (true) {
        const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
        if (descriptor < 0) return cannot_lock(folder, errno);
        if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
            const int why = errno;
            auto error =
                why == EWOULDBLOCK ? is_taken(folder, descriptor) : cannot_lock(folder, why);
            ::close(descriptor);
            return error;
        }
        if (is_still(path, descriptor)) {
            write_pid(descriptor);
            return FolderLock(path, descriptor);
        }
        ::close(descriptor);
    }
}

FolderLock::FolderLock(FolderLock&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

FolderLock::~FolderLock() {
    if (descriptor_ < 0) return;
    if (is_still(path_, descriptor_)) ::unlink(path_.c_str());
    ::close(descriptor_);
}

}  // namespace gripscan
