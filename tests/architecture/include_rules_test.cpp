#include "tests/architecture/include_rules.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gripscan::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

const std::vector<SourceFile>& tree() {
    static const auto files = read_source_tree(GRIPSCAN_SOURCE_DIR);
    return files;
}

TEST(Architecture, EveryIncludeGoesWhereTheTableAllows) {
    EXPECT_THAT(include_breaches(tree()), IsEmpty());
}

TEST(Architecture, EveryLinkGoesWhereTheTableAllows) {
    EXPECT_THAT(link_breaches(tree()), IsEmpty());
}

TEST(Architecture, NoPathOfASingleMachine) {
    EXPECT_THAT(machine_path_breaches(tree()), IsEmpty());
}

TEST(Architecture, TheTreeIsReallyRead) {
    const auto has = [](std::string_view path) {
        return std::any_of(tree().begin(), tree().end(),
                           [&](const SourceFile& f) { return f.path == path; });
    };
    EXPECT_TRUE(has("core/base/result.h"));
    EXPECT_TRUE(has("core/cloud/pcd_format.cpp"));
    EXPECT_TRUE(has("app/main.cpp"));
    EXPECT_TRUE(has("run.sh"));
    EXPECT_TRUE(has(".ci/run"));
    EXPECT_GT(tree().size(), 80U);
}

// The checkers themselves: a breach made up for each rule.

std::vector<std::string> breaches_of(const std::string& path, const std::string& text) {
    return include_breaches({{path, text}});
}

TEST(IncludeRules, KnowTheTableOfFolders) {
    EXPECT_THAT(folders_known_by("base"), ElementsAre("base"));
    EXPECT_THAT(folders_known_by("registration"),
                ElementsAre("base", "cloud", "geometry", "registration"));
    EXPECT_THAT(folders_known_by("sim"),
                ElementsAre("base", "camera", "concurrency", "geometry", "robot", "sim"));
    EXPECT_TRUE(folders_known_by("report").contains("stereo"));
    EXPECT_FALSE(folders_known_by("report").contains("sim"));
    EXPECT_THAT(folders_known_by("helpers"), IsEmpty());
}

TEST(IncludeRules, ReportUpwardIncludesWithFileAndLine) {
    EXPECT_THAT(breaches_of("core/registration/a.cpp",
                            "#include \"core/cloud/cloud.h\"\n"
                            "  #  include \"core/concurrency/worker_pool.h\"\n"),
                ElementsAre(HasSubstr("core/registration/a.cpp:2")));
    EXPECT_THAT(breaches_of("core/base/a.h", "#include \"core/geometry/pose.h\"\n"), SizeIs(1));
    EXPECT_THAT(breaches_of("core/sim/a.cpp", "#include \"core/cloud/cloud.h\"\n"), SizeIs(1));
    EXPECT_THAT(breaches_of("core/base/a.h", "#include \"result.h\"\n"), SizeIs(1));
    EXPECT_THAT(breaches_of("core/base/a.h", "#include \"app/context.h\"\n"), SizeIs(1));
    EXPECT_THAT(breaches_of("core/new_folder/a.h", "#include \"core/base/result.h\"\n"), SizeIs(1));
    EXPECT_THAT(breaches_of("ui/a.cpp", "#include \"app/context.h\"\n"), SizeIs(1));
    EXPECT_THAT(breaches_of("app/a.cpp", "#include \"tests/support/test_data.h\"\n"), SizeIs(1));
}

TEST(IncludeRules, KnowTheRoomsOfTheWindow) {
    EXPECT_THAT(breaches_of("ui/widgets/a.cpp", "#include \"ui/theme/theme.h\"\n"), IsEmpty());
    EXPECT_THAT(breaches_of("ui/widgets/a.cpp", "#include \"ui/imgui_compat.h\"\n"), IsEmpty());
    EXPECT_THAT(breaches_of("ui/theme/a.cpp", "#include \"ui/widgets/button.h\"\n"), SizeIs(1));
    EXPECT_THAT(breaches_of("ui/widgets/a.cpp", "#include \"ui/gl/gl_object.h\"\n"), SizeIs(1));
    EXPECT_THAT(breaches_of("ui/attic/a.cpp", "#include \"ui/theme/theme.h\"\n"), SizeIs(1));
}

TEST(IncludeRules, KeepLibrariesInTheirPlaces) {
    for (const char* gui : {"<imgui.h>", "<GLFW/glfw3.h>", "<epoxy/gl.h>"}) {
        EXPECT_THAT(breaches_of("core/report/a.cpp", fmt::format("#include {}\n", gui)), SizeIs(1));
        EXPECT_THAT(breaches_of("ui/shell/a.cpp", fmt::format("#include {}\n", gui)), IsEmpty());
    }
    EXPECT_THAT(breaches_of("ui/panels/a.cpp", "#include <epoxy/gl.h>\n"), SizeIs(1));
    EXPECT_THAT(breaches_of("core/cloud/a.h", "#include <pcl/point_types.h>\n"), SizeIs(1));
    EXPECT_THAT(breaches_of("core/cloud/a.cpp", "#include <pcl/point_types.h>\n"), SizeIs(1));
    EXPECT_THAT(breaches_of("core/cloud/pcd_format.cpp", "#include <pcl/io/lzf.h>\n"), IsEmpty());
    EXPECT_THAT(breaches_of("core/geometry/a.cpp", "#include <opencv2/core.hpp>\n"), SizeIs(1));
    EXPECT_THAT(breaches_of("core/stereo/a.h", "#include <opencv2/calib3d.hpp>\n"), SizeIs(1));
    EXPECT_THAT(breaches_of("core/cloud/a.cpp", "#include <boost/any.hpp>\n"), SizeIs(1));
    EXPECT_THAT(breaches_of("core/cloud/a.cpp", "#include <GL/gl.h>\n"), SizeIs(1));
    EXPECT_THAT(breaches_of("core/cloud/a.cpp", "#include <vector>\n#include <sys/stat.h>\n"),
                IsEmpty());
}

TEST(IncludeRules, ReadTheLinksOfCMake) {
    EXPECT_THAT(link_breaches({{"core/cloud/CMakeLists.txt",
                                "gripscan_library(cloud PUBLIC gripscan_geometry\n"
                                "  gripscan_camera) # gripscan_report\n"}}),
                ElementsAre(HasSubstr("core/cloud does not know core/camera")));
}

TEST(IncludeRules, FindMachinePaths) {
    const std::string home = "/home";
    EXPECT_THAT(machine_path_breaches({{"run.sh", "cd " + home + "/someone/gripscan\n"}}),
                SizeIs(1));
    EXPECT_THAT(
        machine_path_breaches({{"a.md", "\"" + home + "/x\"\nframes/work/x /usr/include\n"}}),
        SizeIs(1));
}

}  // namespace
}  // namespace gripscan::test
