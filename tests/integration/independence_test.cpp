// The proof that Table 1 is evidence: whatever angles a recording claims, the scans say the same.

#include <gmock/gmock.h>

#include <cmath>

#include "core/session/capture_table.h"
#include "core/session/session_spec.h"
#include "tests/integration/program.h"
#include "tests/support/synthetic_session.h"
#include "tests/support/test_data.h"

namespace gripscan::test {
namespace {
namespace fs = std::filesystem;

using ChangeAngles = std::function<void(CaptureRow& row, int k)>;

void replace_angles(CaptureRow& row, int k) {
    // Nothing like the truth: other steps, other sign, uneven.
    row.commanded_deg = -3.0 * k + (k % 2);
    row.joints_deg[5] = 17.0 - 3.1 * k;
    if (row.j6_after_deg) row.j6_after_deg = 17.0 - 3.1 * k;
}

void remove_angles(CaptureRow& row, int) {
    row.commanded_deg.reset();
    row.joints_deg.fill(std::nullopt);
    row.j6_after_deg.reset();
}

/// A copy of the session that lies about the angles (or does not tell them).
void copy_with(const fs::path& from, const fs::path& to, const ChangeAngles& change,
               std::optional<double> step_deg) {
    fs::create_directories(to);
    for (const auto& entry : fs::directory_iterator(from)) {
        if (entry.is_directory() || entry.path().filename() == "rig.yaml") {
            fs::create_symlink(fs::absolute(entry.path()), to / entry.path().filename());
        }
    }
    auto spec = parse_session_spec("session.yaml", read_text(from / "session.yaml"));
    ASSERT_TRUE(spec);
    spec->step_deg = step_deg;
    // The sign of the turn is a convention told from outside; with a hint it stays the same.
    spec->axis_hint = Eigen::Vector3d(0.7, 0.7, 0.1);
    write_text(to / "session.yaml", session_spec_text(*spec));
    auto table = parse_capture_table("captures.csv", read_text(from / "captures.csv"));
    ASSERT_TRUE(table);
    for (std::size_t k = 0; k < table->rows.size(); ++k) {
        change(table->rows[k], static_cast<int>(k));
    }
    write_text(to / "captures.csv", capture_table_text(*table));
}

void expect_independent(const fs::path& session) {
    const TemporaryFolder folder;
    copy_with(
        session, folder / "true", [](CaptureRow&, int) {}, 10.0);
    copy_with(session, folder / "replaced", replace_angles, 33.0);
    copy_with(session, folder / "removed", remove_angles, std::nullopt);
    const auto steps = [&](const std::string& name) {
        const auto result = run_program({"replay", (folder / name).string(), "--out",
                                         (folder / (name + " out")).string(), "--json"});
        EXPECT_LE(result.status, 1) << result.err;
        return result.json()["steps"];
    };
    const auto truth = steps("true");
    ASSERT_GE(truth.size(), 5u);
    for (const char* name : {"replaced", "removed"}) {
        const auto changed = steps(name);
        ASSERT_EQ(changed.size(), truth.size());
        for (std::size_t i = 0; i < truth.size(); ++i) {
            const double sigma = truth[i]["sigma_deg"].get<double>();
            EXPECT_LT(
                std::abs(changed[i]["icp_deg"].get<double>() - truth[i]["icp_deg"].get<double>()),
                sigma)
                << name << ", step " << i + 1;
            EXPECT_TRUE(truth[i]["independent"].get<bool>());
        }
        if (std::string(name) == "removed") {
            EXPECT_TRUE(changed[0]["error_deg"].is_null());
        }
    }
}

TEST(Independence, OfASyntheticBody) {
    const TemporaryFolder folder;
    for (const std::uint64_t seed : {1u, 2u}) {
        SyntheticTurnSettings settings;
        settings.seed = seed;
        const auto session = folder / fmt::format("s{}", seed);
        ASSERT_NO_FATAL_FAILURE(write_synthetic_session(session, settings));
        expect_independent(session);
    }
}

TEST(Independence, OfPhotographs) {
    GRIPSCAN_TEST_DATA(session, "temple-turn");
    expect_independent(session);
}

}  // namespace
}  // namespace gripscan::test
