#include "core/base/atomic_file.h"

#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>

namespace gripscan {
namespace fs = std::filesystem;
namespace {

std::string reason() { return std::strerror(errno); }

/// Makes the content of a file or the entries of a folder reach the disk.
bool sync_to_disk(const fs::path& path, int flags) {
    const int fd = ::open(path.c_str(), flags | O_CLOEXEC);
    if (fd < 0) return false;
    const bool synced = ::fsync(fd) == 0;
    return ::close(fd) == 0 && synced;
}

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

fs::path beside(const fs::path& path) {
    fs::path name = path.filename();
    if (name.empty()) name = path.parent_path().filename();
    return folder_of(path) / fmt::format(".{}.{}.part{}", name.stem().string(), ::getpid(),
                                         name.extension().string());
}

Status put_in_place(const fs::path& temporary, const fs::path& path) {
    if (!sync_to_disk(temporary, O_RDONLY)) {
        return input_error("cannot sync {}: {}; is the disk full?", path.string(), reason());
    }
    if (::rename(temporary.c_str(), path.c_str()) != 0) {
        return input_error("cannot write {}: {}", path.string(), reason());
    }
    sync_to_disk(folder_of(path), O_RDONLY | O_DIRECTORY);
    return {};
}

}  // namespace

Status write_file_atomically(const fs::path& path, std::string_view content) {
    return write_file_atomically(path, [&](const fs::path& temporary) -> Status {
        std::ofstream file(temporary, std::ios::binary);
        file.write(content.data(), static_cast<std::streamsize>(content.size()));
        file.close();
        if (!file) {
            return input_error("cannot write {}: {}; check that the folder exists, may be written "
                               "to and has space",
                               path.string(), reason());
        }
        return {};
    });
}

Status write_file_atomically(const fs::path& path,
                             const std::function<Status(const fs::path& temporary)>& write) {
    const fs::path temporary = beside(path);
    Status status = write(temporary);
    if (status) status = put_in_place(temporary, path);
    if (!status) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
    }
    return status;
}

Status replace_folder_atomically(const fs::path& target_given,
                                 const std::function<Status(const fs::path& fresh)>& fill) {
    fs::path target = target_given.lexically_normal();
    if (target.filename().empty()) target = target.parent_path();
    const fs::path fresh = beside(target);
    std::error_code code;
    fs::remove_all(fresh, code);
    fs::create_directories(fresh, code);
    if (code) {
        return input_error("cannot create a folder for {}: {}", target.string(), code.message());
    }
    Status status = fill(fresh);
    if (status) {
        for (const auto& entry : fs::recursive_directory_iterator(fresh, code)) {
            if (entry.is_regular_file() && !sync_to_disk(entry.path(), O_RDONLY)) {
                status = input_error("cannot sync {}: {}; is the disk full?",
                                     (target / entry.path().filename()).string(), reason());
                break;
            }
        }
    }
    if (status) {
        // Exchange keeps a complete folder under the name at every moment.
        if (fs::exists(target)) {
            if (::renameat2(AT_FDCWD, fresh.c_str(), AT_FDCWD, target.c_str(), RENAME_EXCHANGE) !=
                0) {
                status = input_error("cannot replace {}: {}", target.string(), reason());
            }
        } else if (::rename(fresh.c_str(), target.c_str()) != 0) {
            status = input_error("cannot create {}: {}", target.string(), reason());
        }
        sync_to_disk(folder_of(target), O_RDONLY | O_DIRECTORY);
    }
    fs::remove_all(fresh, code);
    return status;
}

Result<std::string> read_whole_file(const fs::path& path) {
    std::error_code code;
    if (fs::is_directory(path, code)) {
        return input_error("cannot read {}: it is a folder", path.string());
    }
    std::ifstream file(path, std::ios::binary);
    if (!file) return input_error("cannot read {}: {}", path.string(), reason());
    std::ostringstream text;
    text << file.rdbuf();
    if (file.bad()) return input_error("cannot read {}: {}", path.string(), reason());
    return std::move(text).str();
}

}  // namespace gripscan
