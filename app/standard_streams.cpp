#include "app/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

namespace gripscan::app {

void keep_standard_streams() {
    // From the lowest on: what is opened gets the lowest number that is free. For reading only, so
    // that a result nobody receives is still an error.
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) >= 0 || errno != EBADF) continue;
        [[maybe_unused]] const int opened = ::open("/dev/null", O_RDONLY);
    }
}

void tell_people(std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
}

}  // namespace gripscan::app
