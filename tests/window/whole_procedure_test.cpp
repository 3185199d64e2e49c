// A turn from the start page to the exported template, by mouse and keys from outside.
#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdlib>

#include "tests/support/temporary_folder.h"
#include "tests/window/outside_driver.h"

namespace gripscan::test {
namespace {
namespace fs = std::filesystem;

/// GRIPSCAN_WINDOW_STEP_DEG=10 makes the whole turn of 36 steps of it.
std::string step_deg() {
    const char* wanted = std::getenv("GRIPSCAN_WINDOW_STEP_DEG");
    return wanted != nullptr ? wanted : "30";
}

/// The only session below the user's folder.
fs::path session_in(const fs::path& home) {
    for (const auto& entry : fs::directory_iterator(home / "gripscan")) return entry.path();
    return {};
}

int run_headless(const std::vector<std::string>& arguments) {
    std::string line = GRIPSCAN_PROGRAM;
    for (const auto& a : arguments) line += " '" + a + "'";
    return std::system((line + " >/dev/null 2>&1").c_str());
}

/// Begins a session in the simulated cell with this test's step, connected and idle.
void begin_turn(const OutsideDriver& driver) {
    ASSERT_TRUE(driver.click("start.simulated")) << driver.error_text();
    ASSERT_TRUE(driver.wait_for("step.check_cell")) << driver.error_text();
    if (step_deg() == "10") return;
    ASSERT_TRUE(driver.click("page.cell")) << driver.error_text();
    ASSERT_TRUE(driver.enter("plan.step", step_deg())) << driver.error_text();
    driver.key("Return");
    ASSERT_TRUE(driver.click("page.procedure")) << driver.error_text();
}

/// Two steps by hand, one of them again, one halved, one taken back; the rest by itself; export.
TEST(WholeProcedure, ByHandThenByItselfToTheExportedTemplate) {
    const TemporaryFolder folder;
    const fs::path home = folder / "home";
    OutsideDriver driver(home, {});
    begin_turn(driver);
    ASSERT_TRUE(driver.begin("step.check_cell")) << driver.error_text();
    ASSERT_TRUE(driver.begin("step.warm_up")) << driver.error_text();
    ASSERT_TRUE(driver.begin("step.capture")) << driver.error_text();
    ASSERT_TRUE(driver.wait_for("step.step")) << driver.error_text();
    driver.key("space");  // the next action: the first step
    ASSERT_TRUE(driver.taken("step.step")) << driver.error_text();
    ASSERT_TRUE(driver.begin("step.retry")) << driver.error_text();
    ASSERT_TRUE(driver.begin("step.halve")) << driver.error_text();
    ASSERT_TRUE(driver.begin("step.step")) << driver.error_text();
    ASSERT_TRUE(driver.wait_for("step.undo")) << driver.error_text();
    driver.key("ctrl+z");
    ASSERT_TRUE(driver.click("mode.run")) << driver.error_text();
    ASSERT_TRUE(driver.click("window.export", 800.0)) << driver.error_text();
    ASSERT_TRUE(driver.click("export.pcd")) << driver.error_text();
    ASSERT_TRUE(driver.click("export.binary")) << driver.error_text();
    // Typed on a keyboard of plain letters.
    const fs::path exported =
        fs::path("/tmp") / ("gripscan-window-" + std::to_string(::getpid()) + ".pcd");
    ASSERT_TRUE(driver.enter("export.file", exported.string())) << driver.error_text();
    ASSERT_TRUE(driver.click("export.write")) << driver.error_text();
    ASSERT_TRUE(driver.wait_for_file(exported)) << driver.error_text();
    driver.key("ctrl+w");
    ASSERT_TRUE(driver.wait_for("start.simulated")) << driver.error_text();

    // The same by the program without a window: the recording computed again and exported.
    const fs::path session = session_in(home);
    const fs::path again = folder / "again.pcd";
    ASSERT_EQ(run_headless({"replay", session.string(), "--out", (folder / "replayed").string()}),
              0);
    EXPECT_EQ(read_text(session / "results/template.pcd"),
              read_text(folder / "replayed/template.pcd"));
    ASSERT_EQ(run_headless({"export", session.string(), "--out", again.string()}), 0);
    EXPECT_EQ(read_text(exported), read_text(again));
    fs::remove(exported);
    fs::remove(exported.string() + ".json");
}

/// Without a hand in it, the window records what the command line does.
TEST(WholeProcedure, ARunInTheWindowIsTheRunOfTheCommandLine) {
    const TemporaryFolder folder;
    const fs::path home = folder / "home";
    OutsideDriver driver(home, {});
    begin_turn(driver);
    ASSERT_TRUE(driver.click("mode.run")) << driver.error_text();
    ASSERT_TRUE(driver.wait_for("window.export", 800.0)) << driver.error_text();
    ASSERT_EQ(run_headless({"run", "gripper", "--cell", "sim", "--step-deg", step_deg(), "--out",
                            (folder / "headless").string()}),
              0);
    EXPECT_EQ(read_text(session_in(home) / "results/template.pcd"),
              read_text(folder / "headless/results/template.pcd"));
}

/// Killed in the middle of a run: the next start offers to resume and goes on at the step.
TEST(WholeProcedure, KilledWhileBusyTheNextStartGoesOn) {
    const TemporaryFolder folder;
    const fs::path home = folder / "home";
    {
        OutsideDriver driver(home, {});
        begin_turn(driver);
        ASSERT_TRUE(driver.click("mode.run")) << driver.error_text();
        ASSERT_TRUE(driver.wait_for_file(session_in(home) / "frames/003_right.png"))
            << driver.error_text();
        driver.kill_now();
    }
    OutsideDriver driver(home, {});
    ASSERT_TRUE(driver.click("start.resume")) << driver.error_text();
    // Cut off in the middle of something it first goes on with that; the run is a command again.
    const auto next = driver.first_of({"step.resume", "mode.run"});
    ASSERT_TRUE(next) << driver.error_text();
    ASSERT_TRUE(*next != "step.resume" || driver.begin(*next));
    ASSERT_TRUE(driver.click("mode.run")) << driver.error_text();
    ASSERT_TRUE(driver.wait_for("window.export", 800.0)) << driver.error_text();
    ASSERT_EQ(run_headless({"run", "gripper", "--cell", "sim", "--step-deg", step_deg(), "--out",
                            (folder / "headless").string()}),
              0);
    EXPECT_EQ(read_text(session_in(home) / "results/template.pcd"),
              read_text(folder / "headless/results/template.pcd"));
}

}  // namespace
}  // namespace gripscan::test
