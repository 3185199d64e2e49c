#include "core/session/session.h"

#include <gmock/gmock.h>

#include <opencv2/core/mat.hpp>

#include "core/base/units.h"
#include "core/camera/image_file.h"
#include "core/stereo/rig_file.h"
#include "tests/support/synthetic_session.h"

namespace gripscan {
namespace {

using testing::HasSubstr;

class SessionFolder : public testing::Test {
  protected:
    void SetUp() override {
        test::SyntheticTurnSettings settings;
        settings.captures = 3;
        settings.samples = 600;
        ASSERT_NO_FATAL_FAILURE(test::write_synthetic_session(session_, settings));
    }

    /// Makes the captures images of 64 x 48 px.
    void use_images() {
        StereoRig rig;
        rig.image = {64, 48};
        rig.K_left << 60, 0, 31.5, 0, 60, 23.5, 0, 0, 1;
        rig.K_right = rig.K_left;
        rig.T_right_left.translation().x() = -0.1;
        ASSERT_TRUE(save_rig(session_ / "rig.yaml", rig));
        std::string table = "index,left,right,cloud\n";
        for (int k = 0; k < 3; ++k) {
            const std::string left = fmt::format("frames/{}_l.png", k);
            const std::string right = fmt::format("frames/{}_r.png", k);
            std::filesystem::create_directories(session_ / "frames");
            const cv::Mat image(48, 64, CV_8UC1, cv::Scalar(10 * k));
            ASSERT_TRUE(save_png(session_ / left, image));
            ASSERT_TRUE(save_png(session_ / right, image));
            table += fmt::format("{},{},{},\n", k, left, right);
        }
        test::write_text(session_ / "captures.csv", table);
    }

    std::string problem() const {
        const auto session = open_session(session_);
        if (!session) return session.error().message;
        const Status checked = check_session_files(*session, {}, for_each_in_order);
        return checked ? "no problem" : checked.error().message;
    }

    test::TemporaryFolder folder_;
    std::filesystem::path session_ = folder_ / "sitzung";
};

TEST_F(SessionFolder, WithCloudsAloneIsValid) {
    EXPECT_EQ(problem(), "no problem");
}

TEST_F(SessionFolder, WithImagesAndRigIsValid) {
    use_images();
    EXPECT_EQ(problem(), "no problem");
}

TEST_F(SessionFolder, GoesToThePipelineInTheCodesUnits) {
    test::replace_in_file(session_ / "captures.csv", "2,20,-70", "2,20.5,-70.25");
    const auto session = open_session(session_);
    ASSERT_TRUE(session) << session.error().message;
    const TurnRecording recording = recording_of(*session);
    ASSERT_EQ(recording.captures.size(), 3u);
    EXPECT_DOUBLE_EQ(*recording.captures[2].commanded_rad, rad_from_deg(20.5));
    EXPECT_DOUBLE_EQ(*recording.captures[2].joint6_rad, rad_from_deg(-70.25));
    EXPECT_FALSE(recording.captures[2].other_joints_rad);
    EXPECT_TRUE(recording.captures[2].load_cloud);
    EXPECT_FALSE(recording.captures[2].load_images);
    EXPECT_DOUBLE_EQ(compute_settings_of(*session).turn.step_rad, rad_from_deg(10.0));
}

TEST_F(SessionFolder, TheUsualStepStandsInForAMissingNominalOne) {
    test::replace_in_file(session_ / "session.yaml", "step_deg: 10\n", "");
    test::replace_in_file(session_ / "captures.csv", "1,10,-80", "1,7,-83");
    test::replace_in_file(session_ / "captures.csv", "2,20,-70", "2,14,-76");
    const auto session = open_session(session_);
    ASSERT_TRUE(session) << session.error().message;
    EXPECT_DOUBLE_EQ(compute_settings_of(*session).turn.step_rad, rad_from_deg(7.0));
}

TEST_F(SessionFolder, ARetakeCountsItsAttempts) {
    test::write_text(session_ / "captures.csv",
                     "index,cloud,status\n0,clouds/000.pcd,\n1,clouds/001.pcd,superseded\n"
                     "2,clouds/001.pcd,superseded\n3,clouds/001.pcd,used\n4,clouds/002.pcd,\n");
    const auto session = open_session(session_);
    ASSERT_TRUE(session) << session.error().message;
    const TurnRecording recording = recording_of(*session);
    EXPECT_FALSE(recording.captures[1].used);
    EXPECT_EQ(recording.captures[3].attempts, 3);
    EXPECT_EQ(recording.captures[4].attempts, 1);
}

TEST_F(SessionFolder, ModeAndNoteReachThePipeline) {
    test::write_text(session_ / "captures.csv",
                     "index,cloud,mode,note\n0,clouds/000.pcd,,\n"
                     "1,clouds/001.pcd,axis-locked,\n2,clouds/002.pcd,free,seen by eye\n");
    const auto session = open_session(session_);
    ASSERT_TRUE(session) << session.error().message;
    const TurnRecording recording = recording_of(*session);
    EXPECT_EQ(recording.captures[0].mode, TurnMode::kFree);
    EXPECT_EQ(recording.captures[1].mode, TurnMode::kAxisLocked);
    EXPECT_EQ(recording.captures[1].note, "");
    EXPECT_EQ(recording.captures[2].mode, TurnMode::kFree);
    EXPECT_EQ(recording.captures[2].note, "seen by eye");
}

TEST_F(SessionFolder, NamesWhatIsAbsent) {
    std::filesystem::remove(session_ / "clouds/001.pcd");
    EXPECT_THAT(problem(), testing::AllOf(HasSubstr("capture 1"), HasSubstr("001.pcd")));
    std::filesystem::remove(session_ / "captures.csv");
    EXPECT_THAT(problem(), HasSubstr("captures.csv"));
    std::filesystem::remove(session_ / "session.yaml");
    EXPECT_THAT(problem(), HasSubstr("session.yaml"));
    std::filesystem::remove_all(session_);
    EXPECT_THAT(problem(), HasSubstr("does not exist"));
    test::write_text(session_, "a file");
    EXPECT_THAT(problem(), HasSubstr("not a folder"));
}

TEST_F(SessionFolder, FilesOfRowsThatAreNotUsedAreCheckedToo) {
    test::write_text(session_ / "captures.csv",
                     "index,cloud,status\n0,clouds/000.pcd,\n1,clouds/gone.pcd,excluded\n"
                     "2,clouds/002.pcd,\n");
    EXPECT_THAT(problem(), HasSubstr("gone.pcd"));
}

TEST_F(SessionFolder, NamesATruncatedCloud) {
    const std::string whole = test::read_text(session_ / "clouds/002.pcd");
    test::write_text(session_ / "clouds/002.pcd", whole.substr(0, whole.size() / 2));
    EXPECT_THAT(problem(), testing::AllOf(HasSubstr("capture 2"), HasSubstr("002.pcd")));
}

/// Cut anywhere: an image library fills the rest with grey and says nothing.
TEST_F(SessionFolder, NamesATruncatedImageWhereverItIsCut) {
    use_images();
    const std::string whole = test::read_text(session_ / "frames/1_r.png");
    for (std::size_t cut = 0; cut < whole.size(); cut += 7) {
        test::write_text(session_ / "frames/1_r.png", whole.substr(0, cut));
        EXPECT_THAT(problem(), testing::AllOf(HasSubstr("capture 1"), HasSubstr("1_r.png"))) << cut;
    }
}

TEST_F(SessionFolder, NamesAnImageWithDamagedBytes) {
    use_images();
    std::string bytes = test::read_text(session_ / "frames/1_r.png");
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 0x55);
    test::write_text(session_ / "frames/1_r.png", bytes);
    EXPECT_THAT(problem(), HasSubstr("1_r.png"));
}

TEST_F(SessionFolder, NamesAnImageOfAnotherSize) {
    use_images();
    ASSERT_TRUE(save_png(session_ / "frames/2_l.png", cv::Mat(48, 60, CV_8UC1, cv::Scalar(1))));
    EXPECT_THAT(problem(),
                testing::AllOf(HasSubstr("capture 2"), HasSubstr("60 x 48"), HasSubstr("64 x 48")));
}

TEST_F(SessionFolder, ARowNeedsSomethingToComputeFrom) {
    test::write_text(session_ / "captures.csv", "index,cloud\n0,clouds/000.pcd\n1,\n");
    EXPECT_THAT(problem(), HasSubstr("captures.csv:3"));
    test::write_text(session_ / "captures.csv", "index,left,cloud\n0,a.png,clouds/000.pcd\n");
    EXPECT_THAT(problem(), HasSubstr("only one image"));
    test::write_text(session_ / "captures.csv", "index,left,right\n0,a.png,b.png\n");
    EXPECT_THAT(problem(), HasSubstr("no rig.yaml"));
    test::write_text(session_ / "captures.csv", "index,cloud\n0,clouds/000.pcd\n");
    EXPECT_THAT(problem(), HasSubstr("at least two"));
}

TEST_F(SessionFolder, CheckingStopsWhenCancelled) {
    const auto session = open_session(session_);
    ASSERT_TRUE(session);
    std::stop_source stop;
    stop.request_stop();
    const Status checked =
        check_session_files(*session, Progress{stop.get_token(), {}}, for_each_in_order);
    ASSERT_FALSE(checked);
    EXPECT_EQ(checked.error().kind, ErrorKind::kCancelled);
}

}  // namespace
}  // namespace gripscan
