#include <gmock/gmock.h>

#include "core/camera/image_file.h"
#include "core/stereo/rig_file.h"
#include "tests/integration/program.h"
#include "tests/support/synthetic_session.h"

namespace gripscan::test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class BadInput : public testing::Test {
  protected:
    void SetUp() override {
        SyntheticTurnSettings settings;
        settings.captures = 4;
        settings.samples = 6000;
        ASSERT_NO_FATAL_FAILURE(write_synthetic_session(session_, settings));
    }

    void use_images() {
        StereoRig rig;
        rig.image = {160, 120};
        rig.K_left << 150, 0, 79.5, 0, 150, 59.5, 0, 0, 1;
        rig.K_right = rig.K_left;
        rig.T_right_left.translation().x() = -0.1;
        ASSERT_TRUE(save_rig(session_ / "rig.yaml", rig));
        std::string table = "index,left,right\n";
        for (int k = 0; k < 3; ++k) {
            const cv::Mat image(120, 160, CV_8UC1, cv::Scalar(100));
            fs::create_directories(session_ / "frames");
            ASSERT_TRUE(save_png(session_ / fmt::format("frames/{}_l.png", k), image));
            ASSERT_TRUE(save_png(session_ / fmt::format("frames/{}_r.png", k), image));
            table += fmt::format("{0},frames/{0}_l.png,frames/{0}_r.png\n", k);
        }
        write_text(session_ / "captures.csv", table);
    }

    /// Status 2, one line that says what, nothing written.
    void expect_refused(const std::vector<std::string>& parts) {
        const auto before = content_of(folder_.path());
        const auto result = run_program(
            {"replay", session_.string(), "--out", (folder_ / "out").string(), "--json"});
        EXPECT_EQ(result.status, 2) << result.err;
        EXPECT_EQ(result.out, "");
        for (const auto& part : parts) EXPECT_THAT(result.err, HasSubstr(part));
        EXPECT_EQ(content_of(folder_.path()), before) << "nothing may be written";
    }

    void truncate(const std::string& file) {
        const std::string bytes = read_text(session_ / file);
        write_text(session_ / file, bytes.substr(0, bytes.size() * 2 / 3));
    }

    TemporaryFolder folder_;
    fs::path session_ = folder_ / "sitzung ä";
};

TEST_F(BadInput, NoSession) {
    session_ = folder_ / "nowhere";
    expect_refused({"nowhere", "does not exist"});
}

TEST_F(BadInput, CaptureWithoutItsFile) {
    fs::remove(session_ / "clouds/002.pcd");
    expect_refused({"capture 2", "clouds/002.pcd"});
}

TEST_F(BadInput, TruncatedCloud) {
    truncate("clouds/001.pcd");
    expect_refused({"capture 1", "clouds/001.pcd"});
}

TEST_F(BadInput, TruncatedImage) {
    use_images();
    truncate("frames/1_r.png");
    expect_refused({"capture 1", "frames/1_r.png", "truncated"});
}

TEST_F(BadInput, ImageOfTheWrongSize) {
    use_images();
    ASSERT_TRUE(save_png(session_ / "frames/2_l.png", cv::Mat(120, 100, CV_8UC1, cv::Scalar(9))));
    expect_refused({"capture 2", "100 x 120", "160 x 120"});
}

TEST_F(BadInput, ImageThatIsNone) {
    use_images();
    write_text(session_ / "frames/0_l.png", "this is text");
    expect_refused({"capture 0", "frames/0_l.png"});
}

TEST_F(BadInput, NotANumberInTheTable) {
    replace_in_file(session_ / "captures.csv", "2,20,", "2,nan,");
    expect_refused({"captures.csv:4", "commanded_deg", "nan"});
}

TEST_F(BadInput, IndicesThatDoNotRise) {
    replace_in_file(session_ / "captures.csv", "2,20,", "1,20,");
    expect_refused({"captures.csv:4", "does not rise"});
}

TEST_F(BadInput, PathOutOfTheFolder) {
    replace_in_file(session_ / "captures.csv", "clouds/002.pcd", "../002.pcd");
    expect_refused({"captures.csv:4", "leaves the session folder"});
}

TEST_F(BadInput, RigWithTheWrongSignOrWithoutBaseline) {
    use_images();
    const std::string rig = read_text(session_ / "rig.yaml");
    const auto with_baseline = [&](const std::string& number) {
        std::string text = rig;
        const auto T = text.find("T:");
        const auto data = text.find("data: [", T) + 7;
        text.replace(data, text.find(',', data) - data, number);
        write_text(session_ / "rig.yaml", text);
    };
    with_baseline("0.1");
    expect_refused({"rig.yaml", "wrong sign"});
    with_baseline("0.");
    expect_refused({"rig.yaml", "baseline"});
    with_baseline(".nan");
    expect_refused({"rig.yaml"});
}

TEST_F(BadInput, RigCutShort) {
    use_images();
    truncate("rig.yaml");
    expect_refused({"rig.yaml"});
}

TEST_F(BadInput, EmptyRegion) {
    replace_in_file(session_ / "session.yaml", "max: [0.08,", "max: [-0.06,");
    expect_refused({"session.yaml:4", "region", "empty"});
}

TEST_F(BadInput, RegionWithoutAPoint) {
    replace_in_file(session_ / "session.yaml", "min: [-0.06, -0.08, 0.5], max: [0.08, 0.08, 0.7]",
                    "min: [1, 1, 1], max: [2, 2, 2]");
    expect_refused({"no capture has points", "region"});
}

TEST_F(BadInput, UnknownFormatAndUnknownKey) {
    replace_in_file(session_ / "session.yaml", "session/1", "session/7");
    expect_refused({"session.yaml:1", "session/7"});
    replace_in_file(session_ / "session.yaml", "session/7", "session/1");
    replace_in_file(session_ / "session.yaml", "step_deg", "step_degrees");
    expect_refused({"session.yaml:3", "step_degrees"});
}

TEST_F(BadInput, KindThatIsNotBuiltIn) {
    replace_in_file(session_ / "session.yaml", "kind: gripper", "kind: scene");
    expect_refused({"session.yaml", "kind scene"});
}

TEST_F(BadInput, ResultsThatWouldReplaceSomethingElse) {
    const auto refused = [&](const fs::path& out, const std::string& part) {
        const auto before = content_of(folder_.path());
        const auto result = run_program({"replay", session_.string(), "--out", out.string()});
        EXPECT_EQ(result.status, 2) << out;
        EXPECT_THAT(result.err, HasSubstr(part));
        EXPECT_EQ(content_of(folder_.path()), before);
    };
    refused(session_, "holds the session");
    refused(folder_.path(), "holds the session");
    write_text(folder_ / "a file", "precious");
    refused(folder_ / "a file", "it is a file");
    refused(folder_ / "a file/below", "not a folder");
    write_text(folder_ / "photos/cat.png", "precious");
    refused(folder_ / "photos", "cat.png");
    const auto result = run_program({"replay", session_.string(), "--out", "/proc/gripscan"});
    EXPECT_EQ(result.status, 2);
    EXPECT_THAT(result.err, HasSubstr("/proc/gripscan"));
}

/// A capture that the scans contradict: results are written, its steps are rejected, the view is
/// not merged.
class Contradiction : public BadInput {
  protected:
    void SetUp() override {
        SyntheticTurnSettings settings;
        settings.captures = 7;
        ASSERT_NO_FATAL_FAILURE(write_synthetic_session(session_, settings));
    }
    nlohmann::json replay() {
        const auto result = run_program(
            {"replay", session_.string(), "--out", (folder_ / "out").string(), "--json"});
        EXPECT_EQ(result.status, 1) << result.err;
        EXPECT_TRUE(fs::exists(folder_ / "out/report.html"));
        return result.json();
    }
    static std::string verdict(const nlohmann::json& json, int from, int to) {
        for (const auto& step : json["steps"]) {
            if (step["from"] == from && step["to"] == to) return step["verdict"];
        }
        return "no such step";
    }
};

TEST_F(Contradiction, ACaptureMislabelledByAStepIsRejectedWithItsIndex) {
    replace_in_file(session_ / "captures.csv", "3,30,-60,", "3,40,-50,");
    const auto json = replay();
    EXPECT_EQ(verdict(json, 2, 3), "reject");
    EXPECT_EQ(verdict(json, 3, 4), "reject");
    EXPECT_EQ(verdict(json, 1, 2), "accept");
    EXPECT_EQ(verdict(json, 4, 5), "accept");
    EXPECT_TRUE(json["poses"][3].is_null()) << "that view is not merged";
    EXPECT_TRUE(json["poses"][4].is_array()) << "those behind it are";
    EXPECT_EQ(json["steps"][2]["cause"], "mislabelled");
}

TEST_F(Contradiction, SwappedCapturesAreRejectedWithTheirIndices) {
    replace_in_file(session_ / "captures.csv", "clouds/002.pcd", "clouds/x.pcd");
    replace_in_file(session_ / "captures.csv", "clouds/003.pcd", "clouds/002.pcd");
    replace_in_file(session_ / "captures.csv", "clouds/x.pcd", "clouds/003.pcd");
    const auto json = replay();
    EXPECT_EQ(verdict(json, 1, 2), "reject");
    EXPECT_EQ(verdict(json, 2, 3), "reject");
    EXPECT_EQ(verdict(json, 3, 4), "reject");
    EXPECT_EQ(verdict(json, 0, 1), "accept");
    EXPECT_EQ(verdict(json, 4, 5), "accept");
    EXPECT_TRUE(json["poses"][2].is_null());
    EXPECT_TRUE(json["poses"][3].is_null());
}

}  // namespace
}  // namespace gripscan::test
