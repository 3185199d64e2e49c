// A session folder with the clouds of a synthetic turn: small, quick, and its truth is known.
#pragma once

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "core/cloud/cloud_file.h"
#include "tests/support/synthetic_turn.h"
#include "tests/support/temporary_folder.h"

namespace gripscan::test {

inline constexpr const char* kSyntheticYaml =
    "format: gripscan-session/1\n"
    "kind: gripper\n"
    "step_deg: 10\n"
    "region: {min: [-0.06, -0.08, 0.5], max: [0.08, 0.08, 0.7]}\n";

/// Writes session.yaml, captures.csv and clouds/NNN.pcd.
inline void write_synthetic_session(const std::filesystem::path& folder,
                                    const SyntheticTurnSettings& settings = {}) {
    const auto views = synthetic_turn(settings);
    write_text(folder / "session.yaml", kSyntheticYaml);
    std::filesystem::create_directories(folder / "clouds");
    std::string table = "index,commanded_deg,j6_deg,left,right,cloud\n";
    for (std::size_t k = 0; k < views.size(); ++k) {
        const double deg = static_cast<double>(k) * settings.step_deg;
        const std::string cloud = fmt::format("clouds/{:03}.pcd", k);
        table += fmt::format("{},{},{},,,{}\n", k, deg, deg - 90.0, cloud);
        const auto saved = save_cloud(folder / cloud, views[k]);
        ASSERT_TRUE(saved) << saved.error().message;
    }
    write_text(folder / "captures.csv", table);
}

}  // namespace gripscan::test
