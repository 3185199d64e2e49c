// What is said goes to its stream or nowhere: never into a file, and never at the program's cost.
#include "app/console.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>

#include "app/standard_streams.h"

namespace gripscan::app {
namespace {

/// In a process of its own, whose streams may be spoilt.
bool holds(const std::function<bool()>& check) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(check() ? 0 : 1);
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST(Console, NothingThatIsOpenedGetsTheNumberOfAClosedStream) {
    for (const bool all : {true, false}) {
        EXPECT_TRUE(holds([all] {
            for (const int stream : {0, 1, 2}) {
                if (all || stream == 1) ::close(stream);
            }
            keep_standard_streams();
            return ::open("/dev/null", O_RDONLY) > 2;
        })) << all;
    }
}

TEST(Console, AResultThatNobodyReceivesIsToldStill) {
    EXPECT_TRUE(holds([] {
        ::close(STDOUT_FILENO);
        keep_standard_streams();
        print_result("lost");
        return !results_printed();
    }));
}

TEST(Console, AFullStandardErrorStopsNothing) {
    EXPECT_TRUE(holds([] {
        const int full = ::open("/dev/full", O_WRONLY);
        ::dup2(full, STDERR_FILENO);
        say({}, "nobody reads this");
        return report_error({ErrorKind::kDevice, "nor this"}) == kDeviceFailed;
    }));
}

}  // namespace
}  // namespace gripscan::app
