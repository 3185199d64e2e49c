// One program a folder: a lock that the kernel holds for this process and gives up with it, however
// it ends. The lock's file is there while the folder is open, and after a crash; it means nothing
// by itself and readers pass it by.
#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/result.h"

namespace gripscan {

class FolderLock {
  public:
    /// Its text is the number of the process that took it last.
    static constexpr std::string_view kFileName = ".gripscan-lock";

    /// Errors: another program holds it (named by its number where that is known), the folder
    /// cannot be written to, the file system knows no locks.
    [[nodiscard]] static Result<FolderLock> take(const std::filesystem::path& folder);
    FolderLock(FolderLock&& other) noexcept;
    FolderLock& operator=(FolderLock&&) = delete;
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;
    /// Removes the file and gives the lock up.
    ~FolderLock();

  private:
    FolderLock(std::filesystem::path path, int descriptor)
        : path_(std::move(path)), descriptor_(descriptor) {}

    std::filesystem::path path_;
    int descriptor_ = -1;
};

}  // namespace gripscan
