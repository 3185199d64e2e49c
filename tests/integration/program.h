// Runs the program under test and keeps what it said.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace gripscan::test {

struct ProgramResult {
    int status = -1;  ///< exit status; 128 + signal if it was killed
    std::string out;
    std::string err;

    /// Standard output as one JSON document; null if it is none.
    [[nodiscard]] nlohmann::json json() const { return nlohmann::json::parse(out, nullptr, false); }
};

using Arguments = std::vector<std::string>;
/// "NAME=VALUE", in addition to the environment of the test.
using Environment = std::vector<std::string>;

[[nodiscard]] ProgramResult run_program(const Arguments& arguments,
                                        const Environment& environment = {});

/// Sends SIGINT as soon as the program listens for it and `ready` is true (asked every few
/// milliseconds).
[[nodiscard]] ProgramResult interrupt_program(const Arguments& arguments,
                                              const std::function<bool()>& ready);

/// Sends SIGKILL as soon as `ready` is true.
[[nodiscard]] ProgramResult kill_program(const Arguments& arguments,
                                         const std::function<bool()>& ready);

/// All files below a folder with their content, by relative path: to see that nothing changed.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> content_of(
    const std::filesystem::path& folder);

}  // namespace gripscan::test
