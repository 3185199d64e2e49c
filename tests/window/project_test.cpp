// From the bare gripper to a grasp pose: gripper, object in it, both recognised in a view that is
// taken for it, by mouse and keys from outside.
#include <gtest/gtest.h>

#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>

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

TEST(Project, FromTheGripperToAGraspPose) {
    const TemporaryFolder folder;
    const fs::path home = folder / "home";
    OutsideDriver driver(home, {});
    ASSERT_TRUE(driver.click("start.simulated"));
    ASSERT_TRUE(driver.wait_for("step.check_cell")) << driver.error_text();
    ASSERT_TRUE(driver.click("page.cell"));
    type_into(driver, "plan.step", "30");
    ASSERT_TRUE(driver.click("page.procedure"));
    run_and_keep(driver, "library.0");

    // The object, held by the gripper that was registered.
    ASSERT_TRUE(driver.click("page.template"));
    ASSERT_TRUE(driver.click("object.register"));
    ASSERT_TRUE(driver.click("new.holds.carton"));
    type_into(driver, "new.step", "30");
    ASSERT_TRUE(driver.click("new.begin"));
    ASSERT_TRUE(driver.wait_for("step.check_cell", 300.0)) << driver.error_text();
    run_and_keep(driver, "library.1");

    // Both are found in a view that is taken now.
    ASSERT_TRUE(driver.click("recognise.now"));
    ASSERT_TRUE(driver.wait_for("found.1", 300.0)) << driver.error_text();
    const auto verdict = driver.find("recognise.verdict");
    ASSERT_TRUE(verdict);
    EXPECT_NE(verdict->label, "Nothing found");
    ASSERT_TRUE(driver.wait_for("recognise.copy"));

    // As one project: the object's sidecar names the gripper that held it, and how.
    bool held = false;
    for (const auto& entry : fs::directory_iterator(home / "gripscan/library")) {
        if (entry.path().extension() != ".json") continue;
        std::ifstream in(entry.path());
        const auto sidecar = nlohmann::json::parse(in, nullptr, false);
        held = held || (sidecar.contains("held") && !sidecar["held"].is_null());
    }
    EXPECT_TRUE(held);
}

}  // namespace
}  // namespace gripscan::test
