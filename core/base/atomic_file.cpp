#include "core/base/atomic_file.h"

#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <regex>
#include <sstream>
#include <system_error>

namespace gripscan {
namespace fs = std::filesystem;
namespace {

std::string reason() {
    return std::strerror(errno);
}

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
    return sync_folder(folder_of(path));
}

/// Every file and folder of a tree that will be called `target`.
Status sync_tree(const fs::path& fresh, const fs::path& target) {
    std::error_code code;
    for (const auto& entry : fs::recursive_directory_iterator(fresh, code)) {
        if (entry.is_directory()) {
            if (Status status = sync_folder(entry.path()); !status) return status;
        } else if (entry.is_regular_file() && !sync_to_disk(entry.path(), O_RDONLY)) {
            return input_error("cannot sync {}: {}; is the disk full?",
                               (target / entry.path().filename()).string(), reason());
        }
    }
    return sync_folder(fresh);
}

/// A complete folder lies under the name at every moment; the old one is called `fresh` then.
Status exchange(const fs::path& fresh, const fs::path& target) {
    if (!fs::exists(target)) {
        if (::rename(fresh.c_str(), target.c_str()) != 0) {
            return input_error("cannot create {}: {}", target.string(), reason());
        }
    } else if (::renameat2(AT_FDCWD, fresh.c_str(), AT_FDCWD, target.c_str(), RENAME_EXCHANGE) !=
               0) {
        return input_error("cannot replace {}: {}", target.string(), reason());
    }
    return sync_folder(folder_of(target));
}

/// The number in a name of beside(); 0 for any other name.
pid_t writer_of(const std::string& name) {
    static const std::regex pattern(R"(\..+\.([0-9]{1,9})\.part(\..*)?)");
    std::smatch match;
    return std::regex_match(name, match, pattern) ? std::stoi(match[1]) : 0;
}

bool is_other_process(pid_t pid) {
    return pid != ::getpid() && (::kill(pid, 0) == 0 || errno != ESRCH);
}

}  // namespace

Status sync_folder(const fs::path& folder) {
    // Some file systems have nothing to sync here, and a folder may be written but not read.
    if (sync_to_disk(folder, O_RDONLY | O_DIRECTORY) || errno == EINVAL || errno == EACCES) {
        return {};
    }
    return input_error("cannot sync {}: {}; is the disk full?", folder.string(), reason());
}

bool is_temporary_name(const std::string& name) {
    return writer_of(name) != 0;
}

void remove_dead_leftovers(const fs::path& folder) {
    std::error_code code;
    std::vector<fs::path> dead;
    for (const auto& entry : fs::directory_iterator(folder, code)) {
        const pid_t writer = writer_of(entry.path().filename().string());
        if (writer != 0 && !is_other_process(writer)) dead.push_back(entry.path());
    }
    for (const auto& path : dead) fs::remove_all(path, code);
}

Status write_file_atomically(const fs::path& path, std::string_view content) {
    return write_file_atomically(path, [&](const fs::path& temporary) -> Status {
        std::ofstream file(temporary, std::ios::binary);
        file.write(content.data(), static_cast<std::streamsize>(content.size()));
        file.close();
        if (!file) {
            return input_error(
                "cannot write {}: {}; check that the folder exists, may be written "
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
    if (status) status = sync_tree(fresh, target);
    if (status) status = exchange(fresh, target);
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
