// Where the local recordings lie. They are not part of the repository; tests that need them are
// skipped, with the missing path, where they are absent.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace gripscan::test {

[[nodiscard]] inline std::filesystem::path data_folder() {
    if (const char* set = std::getenv("GRIPSCAN_DATA")) return set;
    return std::filesystem::path(GRIPSCAN_SOURCE_DIR) / ".." / "shared" / "data";
}

}  // namespace gripscan::test

/// Declares `variable` as a folder of the test data, or skips the test, naming what is missing.
#define GRIPSCAN_TEST_DATA(variable, name)                                         \
    const std::filesystem::path variable = gripscan::test::data_folder() / (name); \
    if (!std::filesystem::exists(variable)) GTEST_SKIP() << "no test data at " << variable
