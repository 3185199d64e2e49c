// From the bare gripper to its pose in a view that is taken for it, by mouse and keys from outside.
#include <gtest/gtest.h>

#include <unistd.h>

#include "tests/support/temporary_folder.h"
#include "tests/window/outside_driver.h"

namespace gripscan::test {
namespace {
namespace fs = std::filesystem;

void type_into(const OutsideDriver& driver, const std::string& id, const std::string& text) {
    ASSERT_TRUE(driver.click(id));
    ::usleep(400000);  // until the input has the keyboard
    driver.key("ctrl+a");
    driver.type(text);
    driver.key("Return");
}

/// Runs the turn that is open to its end and puts its template into the library.
void run_and_keep(const OutsideDriver& driver, const std::string& line) {
    ASSERT_TRUE(driver.click("mode.run")) << driver.error_text();
    ASSERT_TRUE(driver.wait_for("window.export", 800.0)) << driver.error_text();
    ASSERT_TRUE(driver.click("page.template"));
    ASSERT_TRUE(driver.click("library.add"));
    ASSERT_TRUE(driver.click("page.recognise"));
    ASSERT_TRUE(driver.wait_for(line, 300.0)) << driver.error_text();
}

TEST(Project, FromTheGripperToItsPoseInANewView) {
    const TemporaryFolder folder;
    const fs::path home = folder / "home";
    OutsideDriver driver(home, {});
    ASSERT_TRUE(driver.click("start.simulated"));
    ASSERT_TRUE(driver.wait_for("step.check_cell")) << driver.error_text();
    ASSERT_TRUE(driver.click("page.cell"));
    type_into(driver, "plan.step", "30");
    ASSERT_TRUE(driver.click("page.procedure"));
    run_and_keep(driver, "library.0");

    // It is found again in a view that is taken now, and where joint 6 stands is read from it.
    ASSERT_TRUE(driver.click("recognise.now"));
    ASSERT_TRUE(driver.wait_for("found.0", 300.0)) << driver.error_text();
    const auto verdict = driver.find("recognise.verdict");
    ASSERT_TRUE(verdict);
    EXPECT_EQ(verdict->label, "Found");
    ASSERT_TRUE(driver.wait_for("recognise.copy"));

    // The environment without the arm; then the same view says what is in the way: nothing.
    ASSERT_TRUE(driver.click("page.cell"));
    ASSERT_TRUE(driver.click("environment.learn"));
    ASSERT_TRUE(driver.click("page.recognise"));
    ASSERT_TRUE(driver.begin("recognise.now", 300.0)) << driver.error_text();
    ASSERT_TRUE(driver.wait_for("recognise.now", 300.0)) << driver.error_text();
    EXPECT_EQ(driver.find("recognise.verdict")->label, "Found");
}

}  // namespace
}  // namespace gripscan::test
