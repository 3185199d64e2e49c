#include "ui/gl/shader_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "tests/support/egl_context.h"
#include "tests/support/temporary_folder.h"
#include "ui/resources/resource_file.h"

namespace gripscan::ui {
namespace {

namespace fs = std::filesystem;

class Shaders : public testing::Test {
  protected:
    void SetUp() override { ASSERT_NE(context_, nullptr); }
    void TearDown() override { ::unsetenv("GRIPSCAN_RESOURCES"); }
    std::unique_ptr<test::EglContext> context_ = test::EglContext::make();
};

/// Every *.frag goes with the *.vert of its name, or with screen.vert where there is none.
TEST_F(Shaders, EveryFileCompilesAndLinks) {
    const fs::path folder = fs::path(GRIPSCAN_SOURCE_DIR) / "shaders";
    std::set<std::string> unused;
    for (const auto& entry : fs::directory_iterator(folder)) {
        unused.insert(entry.path().filename().string());
    }
    ASSERT_FALSE(unused.empty());
    for (const std::string& fragment : std::set<std::string>(unused)) {
        if (!fragment.ends_with(".frag")) continue;
        std::string vertex = fs::path(fragment).stem().string() + ".vert";
        if (!fs::exists(folder / vertex)) vertex = "screen.vert";
        const auto program = ShaderProgram::load(vertex, fragment);
        EXPECT_TRUE(program.has_value()) << program.error().message;
        unused.erase(vertex);
        unused.erase(fragment);
    }
    EXPECT_THAT(unused, testing::IsEmpty()) << "these are in no program";
}

TEST_F(Shaders, AMistakeIsToldWithItsFile) {
    const test::TemporaryFolder folder;
    test::write_text(folder / "shaders/a.vert", "#version 330 core\nvoid main() { oops; }\n");
    test::write_text(folder / "shaders/a.frag", "#version 330 core\nvoid main() {}\n");
    ::setenv("GRIPSCAN_RESOURCES", folder.path().c_str(), 1);
    const auto program = ShaderProgram::load("a.vert", "a.frag");
    ASSERT_FALSE(program.has_value());
    EXPECT_THAT(program.error().message, testing::HasSubstr("shaders/a.vert"));
    EXPECT_THAT(program.error().message, testing::HasSubstr("oops"));
}

TEST_F(Shaders, AMissingFileIsToldWithThePlacesAndTheCure) {
    const test::TemporaryFolder folder;
    ::setenv("GRIPSCAN_RESOURCES", folder.path().c_str(), 1);
    const auto program = ShaderProgram::load("absent.vert", "absent.frag");
    ASSERT_FALSE(program.has_value());
    EXPECT_THAT(program.error().message, testing::HasSubstr(folder.path().string()));
    EXPECT_THAT(program.error().message, testing::HasSubstr("share/gripscan"));
    EXPECT_THAT(program.error().message, testing::HasSubstr("set GRIPSCAN_RESOURCES"));
}

TEST_F(Shaders, TheFolderOfTheEnvironmentComesFirst) {
    const test::TemporaryFolder folder;
    test::write_text(folder / "shaders/points.vert", "other");
    ::setenv("GRIPSCAN_RESOURCES", folder.path().c_str(), 1);
    EXPECT_EQ(read_resource("shaders/points.vert").value(), "other");
    ::unsetenv("GRIPSCAN_RESOURCES");
    EXPECT_NE(read_resource("shaders/points.vert").value(), "other");
}

}  // namespace
}  // namespace gripscan::ui
