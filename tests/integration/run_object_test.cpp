// An object in the simulated gripper, from the gripper's own registration to its template.
#include <gmock/gmock.h>

#include "tests/integration/program.h"
#include "tests/support/temporary_folder.h"

namespace gripscan::test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

/// The gripper's registration, made once; steps of 20° keep it short.
const fs::path& gripper_session() {
    static const TemporaryFolder folder;
    static const fs::path session = [] {
        fs::path made = folder / "gripper";
        const auto result =
            run_program({"run", "gripper", "--step-deg", "20", "--out", made.string()});
        EXPECT_EQ(result.status, 0) << result.err;
        return made;
    }();
    return session;
}

Arguments turn(const fs::path& session, const Arguments& more = {}) {
    Arguments arguments{"run",        "object",
                        "--object",   "casting",
                        "--step-deg", "20",
                        "--gripper",  gripper_session().string(),
                        "--out",      session.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST(RunObject, AnObjectThatSlipsStopsTheRun) {
    const TemporaryFolder folder;
    for (const char* fault : {"object_slip@2=1", "object_twist@2=1"}) {
        const fs::path session = folder / std::string(fault).substr(0, 10);
        const auto result = run_program(turn(session, {"--fault", fault, "--json"}));
        EXPECT_EQ(result.status, 1) << fault << result.err;
        EXPECT_THAT(result.err, HasSubstr("1 -> 2: cause=slip")) << fault;
        EXPECT_THAT(result.err, HasSubstr("moved in the gripper")) << fault;
        const auto json = result.json();
        ASSERT_FALSE(json.is_null());
        EXPECT_TRUE(json["poses"].back().is_null()) << "what moved is not merged";
    }
}

TEST(RunObject, SaysWhatIsMissing) {
    const TemporaryFolder folder;
    const auto out = (folder / "s").string();
    const auto bare = run_program({"run", "object", "--object", "jug", "--out", out});
    EXPECT_EQ(bare.status, 2);
    EXPECT_THAT(bare.err, HasSubstr("--gripper is missing"));
    const auto empty =
        run_program({"run", "object", "--gripper", folder.path().string(), "--out", out});
    EXPECT_EQ(empty.status, 2);
    EXPECT_THAT(empty.err, HasSubstr("--object is missing"));
    write_text(folder / "bare.xyz", "0 0 1\n0 0.1 1\n0.1 0 1\n");
    const auto unknown = run_program({"run", "object", "--object", "jug", "--gripper",
                                      (folder / "bare.xyz").string(), "--out", out});
    EXPECT_EQ(unknown.status, 2);
    EXPECT_THAT(unknown.err, HasSubstr("axis"));
    EXPECT_FALSE(fs::exists(folder / "s"));
}

}  // namespace
}  // namespace gripscan::test
