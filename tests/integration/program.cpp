#include "tests/integration/program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>

#include "tests/support/temporary_folder.h"

namespace gripscan::test {
namespace {
namespace fs = std::filesystem;

void redirect(int descriptor, const fs::path& path) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(file, descriptor);
    ::close(file);
}

pid_t start(const Arguments& arguments, const Environment& environment, const fs::path& out,
            const fs::path& err) {
    const pid_t child = ::fork();
    if (child != 0) return child;
    redirect(STDOUT_FILENO, out);
    redirect(STDERR_FILENO, err);
    std::vector<char*> argv{const_cast<char*>(GRIPSCAN_PROGRAM)};
    for (const auto& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    for (const auto& variable : environment) ::putenv(const_cast<char*>(variable.c_str()));
    ::execv(GRIPSCAN_PROGRAM, argv.data());
    ::_exit(127);
}

/// Does the process hold SIGINT back from its default, sudden end? (mask in /proc, hexadecimal)
bool listens_for_interrupt(pid_t child) {
    const std::string text = read_text(fmt::format("/proc/{}/status", child));
    const auto at = text.find("SigBlk:");
    if (at == std::string::npos) return false;
    const auto mask = std::strtoull(text.c_str() + at + 7, nullptr, 16);
    return (mask >> (SIGINT - 1) & 1U) != 0;
}

int exit_status(int status) {
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// Unique beside the test's own temporary folders.
struct OutputFiles {
    OutputFiles() {
        static int count = 0;
        const auto stem =
            fs::temp_directory_path() /
            ("gripscan-output-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
        out = stem.string() + ".out";
        err = stem.string() + ".err";
    }
    ~OutputFiles() {
        std::error_code ignored;
        fs::remove(out, ignored);
        fs::remove(err, ignored);
    }
    fs::path out;
    fs::path err;
};

/// Sends the signal once, as soon as `ready` is true for the child.
ProgramResult signalled(const Arguments& arguments, int signal,
                        const std::function<bool(pid_t child)>& ready) {
    const OutputFiles files;
    const pid_t child = start(arguments, {}, files.out, files.err);
    int status = 0;
    bool sent = false;
    while (::waitpid(child, &status, WNOHANG) == 0) {
        if (!sent && ready(child)) {
            ::kill(child, signal);
            sent = true;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return {exit_status(status), read_text(files.out), read_text(files.err)};
}

}  // namespace

ProgramResult run_program(const Arguments& arguments, const Environment& environment) {
    const OutputFiles files;
    const pid_t child = start(arguments, environment, files.out, files.err);
    int status = 0;
    ::waitpid(child, &status, 0);
    return {exit_status(status), read_text(files.out), read_text(files.err)};
}

ProgramResult interrupt_program(const Arguments& arguments, const std::function<bool()>& ready) {
    return signalled(arguments, SIGINT,
                     [&](pid_t child) { return listens_for_interrupt(child) && ready(); });
}

ProgramResult kill_program(const Arguments& arguments, const std::function<bool()>& ready) {
    return signalled(arguments, SIGKILL, [&](pid_t) { return ready(); });
}

std::vector<std::pair<std::string, std::string>> content_of(const fs::path& folder) {
    std::vector<std::pair<std::string, std::string>> files;
    if (!fs::exists(folder)) return files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string name = entry.path().lexically_relative(folder).string();
        files.emplace_back(name, entry.is_regular_file() ? read_text(entry.path()) : "/");
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace gripscan::test
