#include "tests/support/virtual_screen.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <string>

namespace gripscan::test {

std::unique_ptr<VirtualScreen> VirtualScreen::make() {
    std::array<int, 2> pipe_ends{};
    if (::pipe(pipe_ends.data()) != 0) return nullptr;
    const pid_t server = ::fork();
    if (server == 0) {
        ::close(pipe_ends[0]);
        const int silence = ::open("/dev/null", O_WRONLY);
        ::dup2(silence, 2);
        const std::string fd = std::to_string(pipe_ends[1]);
        // It lives on between two windows of a test: without -noreset it begins anew then.
        ::execlp("Xvfb", "Xvfb", "-noreset", "-displayfd", fd.c_str(), "-screen", "0",
                 "1600x1000x24", "-nolisten", "tcp", static_cast<char*>(nullptr));
        ::_exit(127);
    }
    ::close(pipe_ends[1]);
    // The server writes its number when it is ready.
    std::string number;
    for (char c = 0; ::read(pipe_ends[0], &c, 1) == 1 && c != '\n';) number += c;
    ::close(pipe_ends[0]);
    if (number.empty()) {
        ::waitpid(server, nullptr, 0);
        return nullptr;
    }
    ::setenv("DISPLAY", (":" + number).c_str(), 1);
    ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    return std::unique_ptr<VirtualScreen>(new VirtualScreen(server));
}

VirtualScreen::~VirtualScreen() {
    ::kill(server_, SIGTERM);
    ::waitpid(server_, nullptr, 0);
    ::unsetenv("DISPLAY");
}

}  // namespace gripscan::test
