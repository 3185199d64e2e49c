// A run that is killed goes on with --resume to the results of an undisturbed one.
#include <gmock/gmock.h>

#include <cmath>
#include <vector>

#include "core/session/cell_file.h"
#include "tests/integration/program.h"
#include "tests/support/temporary_folder.h"

namespace gripscan::test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

/// Steps of 30° keep the tests short.
Arguments turn(const fs::path& session, const Arguments& more = {}) {
    Arguments arguments{"run", "gripper", "--step-deg", "30", "--out", session.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

/// What an undisturbed run ends with, computed once.
struct Undisturbed {
    std::string template_pcd;
    std::size_t steps = 0;  ///< twelve, and more where one was halved
};
const Undisturbed& undisturbed() {
    static const Undisturbed all = [] {
        const TemporaryFolder folder;
        const auto result = run_program(turn(folder / "s", {"--json"}));
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_GE(result.json()["steps"].size(), 12U);
        return Undisturbed{read_text(folder / "s/results/template.pcd"),
                           result.json()["steps"].size()};
    }();
    return all;
}
const std::string& undisturbed_template() {
    return undisturbed().template_pcd;
}

TEST(Resume, AKilledRunEndsWithTheTemplateOfAnUndisturbedOne) {
    const TemporaryFolder folder;
    const fs::path session = folder / "s";
    const auto killed =
        kill_program(turn(session), [&] { return fs::exists(session / "frames/005_left.png"); });
    ASSERT_EQ(killed.status, 128 + 9);
    EXPECT_FALSE(fs::exists(session / "results"));
    const auto resumed = run_program({"run", "gripper", "--resume", "--out", session.string()});
    EXPECT_EQ(resumed.status, 0) << resumed.err;
    EXPECT_EQ(read_text(session / "results/template.pcd"), undisturbed_template());
    // What it did not begin with is refused, also where it is the default.
    for (const auto& other : std::vector<Arguments>{{"--step-deg", "10"}, {"--seed", "2"}}) {
        Arguments contradicting{"run", "gripper", "--resume", "--out", session.string()};
        contradicting.insert(contradicting.end(), other.begin(), other.end());
        const auto refused = run_program(contradicting);
        EXPECT_EQ(refused.status, 2) << other[0];
        EXPECT_THAT(refused.err, HasSubstr(other[0]));
    }
    // Once more: it is finished, and stays so.
    const auto again =
        run_program({"run", "gripper", "--resume", "--out", session.string(), "--json"});
    EXPECT_EQ(again.status, 0) << again.err;
    EXPECT_EQ(again.json()["steps"].size(), undisturbed().steps);
    EXPECT_EQ(read_text(session / "results/template.pcd"), undisturbed_template());
}

TEST(Resume, TheCellMayLiveOnInItsOwnProcess) {
    const TemporaryFolder folder;
    const fs::path session = folder / "s";
    const fs::path cell = folder / "cell/cell.yaml";
    const auto served = interrupt_program(
        {"simcell", "--port", "0", "--time-scale", "20", "--step-deg", "30", "--cell-out",
         (folder / "cell").string()},
        [&] {
            if (!fs::exists(cell)) return false;
            const auto killed =
                kill_program(turn(session, {"--cell", cell.string(), "--live"}),
                             [&] { return fs::exists(session / "frames/003_right.png"); });
            EXPECT_EQ(killed.status, 128 + 9);
            // What moves an arm is asked for again; what it began with is not changed.
            const auto resume_with = [&](std::vector<std::string> more) {
                more.insert(more.begin(),
                            {"run", "gripper", "--resume", "--out", session.string()});
                return run_program(more);
            };
            const auto unasked = resume_with({});
            EXPECT_EQ(unasked.status, 2);
            EXPECT_THAT(unasked.err, HasSubstr("--live"));
            EXPECT_EQ(resume_with({"--live", "--manual"}).status, 2);
            EXPECT_EQ(resume_with({"--live", "--step-deg", "20"}).status, 2);
            const auto resumed = resume_with({"--live"});
            EXPECT_EQ(resumed.status, 0) << resumed.err;
            EXPECT_THAT(resumed.err, HasSubstr("LIVE"));
            // And a session of the simulated cell never goes on in a real one.
            const auto other = turn(folder / "sim");
            const auto cut = kill_program(
                other, [&] { return fs::exists(folder / "sim/frames/000_right.png"); });
            EXPECT_EQ(cut.status, 128 + 9);
            const auto real = run_program({"run", "gripper", "--resume", "--out",
                                           (folder / "sim").string(), "--cell", cell.string()});
            EXPECT_EQ(real.status, 2);
            EXPECT_THAT(real.err, HasSubstr("simulated cell"));
            return true;
        });
    EXPECT_EQ(served.status, 0) << served.err;
    EXPECT_EQ(read_text(session / "results/template.pcd"), undisturbed_template());
}

TEST(Resume, NothingBeginsWhereThereIsNoSession) {
    const TemporaryFolder folder;
    const auto resumed =
        run_program({"run", "gripper", "--resume", "--out", (folder / "mistyped").string()});
    EXPECT_EQ(resumed.status, 2);
    EXPECT_THAT(resumed.err, HasSubstr("no session at"));
    EXPECT_FALSE(fs::exists(folder / "mistyped"));
}

TEST(Resume, AnEmptyFolderHoldsNoSession) {
    const TemporaryFolder folder;
    const auto resumed =
        run_program({"run", "gripper", "--resume", "--out", folder.path().string()});
    EXPECT_EQ(resumed.status, 2);
    EXPECT_THAT(resumed.err, HasSubstr("no session at"));
    EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(Resume, AnotherKindIsSentToItsCommand) {
    const TemporaryFolder folder;
    const fs::path session = folder / "s";
    (void)kill_program(turn(session), [&] { return fs::exists(session / "journal"); });
    const auto before = content_of(session);
    const auto resumed = run_program({"run", "object", "--resume", "--out", session.string()});
    EXPECT_EQ(resumed.status, 2) << resumed.err;
    EXPECT_THAT(resumed.err,
                HasSubstr("gripscan run gripper --resume --out '" + session.string() + "'"));
    EXPECT_EQ(content_of(session), before);
}

TEST(Resume, ASecondProcessOnTheSameSessionIsRefused) {
    const TemporaryFolder folder;
    const fs::path session = folder / "s";
    const auto first = interrupt_program(turn(session), [&] {
        if (!fs::exists(session / "frames/000_right.png")) return false;
        const auto second = run_program({"run", "gripper", "--resume", "--out", session.string()});
        EXPECT_EQ(second.status, 2);
        EXPECT_THAT(second.err, HasSubstr(session.string()));
        return true;
    });
    EXPECT_EQ(first.status, 4) << first.err;
    EXPECT_THAT(first.err, HasSubstr("--resume --out '" + session.string() + "'\n"));
}

TEST(DryRun, WritesTheMotionsDownAndMovesNothing) {
    const TemporaryFolder folder;
    const fs::path cell = folder / "cell/cell.yaml";
    (void)interrupt_program(
        {"simcell", "--port", "0", "--cell-out", (folder / "cell").string()}, [&] {
            if (!fs::exists(cell)) return false;
            const auto dry = run_program(turn(folder / "s", {"--cell", cell.string(), "--json"}));
            EXPECT_EQ(dry.status, 0) << dry.err;
            const auto json = dry.json();
            EXPECT_EQ(json["format"], "gripscan-rehearsal/1");
            EXPECT_EQ(json["mode"], "DRY");
            // The steps, then the way home in pieces, passed by the approach and reached from
            // below.
            const auto motions = json["joint6_deg"].get<std::vector<double>>();
            EXPECT_EQ(motions.size(), 12U + 10U + 1U);
            if (motions.size() != 23) return true;
            const double start = motions.back();
            EXPECT_NEAR(start, -180.0, 0.006) << "where the encoder says that it stands: 6 sigma";
            for (std::size_t k = 0; k < 12; ++k) {
                EXPECT_NEAR(motions[k] - start, 30.0 * static_cast<double>(k + 1), 1e-6);
            }
            for (std::size_t k = 1; k < motions.size(); ++k) {
                EXPECT_LE(std::abs(motions[k] - motions[k - 1]), 40.0 + 1e-6) << k;
            }
            EXPECT_NEAR(motions[21] - start, -3.0, 1e-6);
            const auto file = load_cell_file(cell);
            EXPECT_TRUE(file);
            if (!file) return true;
            const auto check = run_program(
                {"robot-check", "127.0.0.1:" + std::to_string(file->robot->port), "--monitor-port",
                 std::to_string(file->robot->monitor_port), "--json"});
            EXPECT_EQ(check.status, 0) << check.out;
            EXPECT_FALSE(fs::exists(folder / "s/frames/000_left.png"));
            return true;
        });
}

TEST(LiveRun, NobodyThereIsADeviceError) {
    const TemporaryFolder folder;
    const fs::path cell = folder / "cell/cell.yaml";
    (void)interrupt_program({"simcell", "--port", "0", "--cell-out", (folder / "cell").string()},
                            [&] { return fs::exists(cell); });
    const auto gone = run_program(turn(folder / "s", {"--cell", cell.string(), "--live"}));
    EXPECT_EQ(gone.status, 3) << gone.err;
    EXPECT_FALSE(gone.err.empty());
}

}  // namespace
}  // namespace gripscan::test
