#include "core/procedure/compute_turn.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "core/concurrency/worker_pool.h"
#include "tests/support/synthetic_turn.h"

namespace gripscan {
namespace {

using testing::HasSubstr;

TurnRecording recording_of(const std::vector<Cloud>& views, double step_deg) {
    TurnRecording recording;
    for (std::size_t k = 0; k < views.size(); ++k) {
        RecordedCapture capture;
        capture.index = static_cast<int>(k);
        capture.commanded_rad = rad_from_deg(static_cast<double>(k) * step_deg);
        capture.load_cloud = [cloud = views[k]]() -> Result<Cloud> { return cloud; };
        recording.captures.push_back(std::move(capture));
    }
    return recording;
}

TurnRecording small_recording(int captures = 4) {
    test::SyntheticTurnSettings settings;
    settings.captures = captures;
    return recording_of(test::synthetic_turn(settings), settings.step_deg);
}

Result<ComputedTurn> compute(const TurnRecording& recording, const Progress& progress = {},
                             const ForEach& for_each = for_each_in_order) {
    return compute_turn(recording, ComputeTurnSettings{}, progress, for_each);
}

/// The noise of 0.2 mm over some 6000 points a view leaves a few hundredths of a degree.
TEST(ComputeTurn, FindsTheTurnOfASyntheticBody) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        test::SyntheticTurnSettings settings;
        settings.seed = seed;
        settings.captures = 4;
        const auto computed =
            compute(recording_of(test::synthetic_turn(settings), settings.step_deg));
        ASSERT_TRUE(computed) << computed.error().message;
        ASSERT_EQ(computed->report.steps.size(), 3u);
        for (const auto& step : computed->report.steps) {
            ASSERT_TRUE(step.icp_rad);
            EXPECT_NEAR(deg_from_rad(*step.icp_rad), 10.0, 0.15) << "seed " << seed;
            EXPECT_EQ(step.verdict, Verdict::kAccept) << step.sentence;
        }
    }
}

TEST(ComputeTurn, PosesHaveAnEntryForEveryLine) {
    TurnRecording recording = small_recording(4);
    RecordedCapture retaken = recording.captures[1];
    retaken.used = false;
    recording.captures.insert(recording.captures.begin() + 1, retaken);
    for (std::size_t i = 0; i < recording.captures.size(); ++i) {
        recording.captures[i].index = static_cast<int>(2 * i);
    }
    const auto computed = compute(recording);
    ASSERT_TRUE(computed) << computed.error().message;
    ASSERT_EQ(computed->report.poses.size(), 5u);
    EXPECT_TRUE(computed->report.poses[0]);
    EXPECT_FALSE(computed->report.poses[1]) << "not used";
    for (const std::size_t used : {2u, 3u, 4u}) EXPECT_TRUE(computed->report.poses[used]) << used;
    EXPECT_EQ(computed->report.steps[0].from, 0);
    EXPECT_EQ(computed->report.steps[0].to, 4) << "steps link used captures by their index";
}

TEST(ComputeTurn, AMissingCaptureIsALargerStep) {
    TurnRecording recording = small_recording(5);
    recording.captures.erase(recording.captures.begin() + 2);
    const auto computed = compute(recording);
    ASSERT_TRUE(computed) << computed.error().message;
    const auto& step = computed->report.steps.at(1);
    EXPECT_EQ(step.from, 1);
    EXPECT_EQ(step.to, 3);
    EXPECT_NEAR(deg_from_rad(*step.icp_rad), 20.0, 0.2);
    EXPECT_EQ(step.verdict, Verdict::kAccept) << step.sentence;
}

TEST(ComputeTurn, DoesNotDependOnTheThreads) {
    const TurnRecording recording = small_recording(4);
    const auto alone = compute(recording);
    WorkerPool pool(3);
    const auto together = compute(recording, {}, pool.for_each());
    ASSERT_TRUE(alone && together);
    for (std::size_t i = 0; i < alone->report.steps.size(); ++i) {
        EXPECT_EQ(alone->report.steps[i].icp_rad, together->report.steps[i].icp_rad);
        EXPECT_EQ(alone->report.steps[i].T->matrix(), together->report.steps[i].T->matrix());
    }
    ASSERT_EQ(alone->report.merged.size(), together->report.merged.size());
    EXPECT_EQ(alone->report.merged.points, together->report.merged.points);
}

TEST(ComputeTurn, NamesTheCaptureThatCannotBeLoaded) {
    TurnRecording recording = small_recording(4);
    recording.captures[2].load_cloud = []() -> Result<Cloud> { return input_error("gone: x.pcd"); };
    recording.captures[3].load_cloud = []() -> Result<Cloud> { return input_error("gone: y.pcd"); };
    WorkerPool pool(3);
    const auto computed = compute(recording, {}, pool.for_each());
    ASSERT_FALSE(computed);
    EXPECT_THAT(computed.error().message, HasSubstr("x.pcd")) << "the first one in order";
}

TEST(ComputeTurn, SaysThatTheRegionHoldsNothing) {
    TurnRecording recording = small_recording(3);
    recording.region = Box{{1.0, 1.0, 1.0}, {2.0, 2.0, 2.0}};
    const auto computed = compute(recording);
    ASSERT_FALSE(computed);
    EXPECT_THAT(computed.error().message, HasSubstr("no capture has points"));
}

TEST(ComputeTurn, CropsCloudsToTheRegionUnlessToldNotTo) {
    TurnRecording recording = small_recording(3);
    // Along the axis, so that the cut stays where it is while the body turns.
    const double cut_x = test::synthetic_axis().point_m.x() + 0.01;
    recording.region = Box{{-1.0, -1.0, 0.0}, {cut_x, 1.0, 1.0}};
    const auto beyond = [&](const Result<ComputedTurn>& computed) {
        const auto& points = computed->report.merged.points;
        // The axis is tilted by some degrees: a turned point leaves the cut by a few millimetres.
        return std::count_if(points.begin(), points.end(),
                             [&](const Eigen::Vector3f& p) { return p.x() > cut_x + 0.005; });
    };
    ComputeTurnSettings settings;
    const auto cropped = compute_turn(recording, settings, {}, for_each_in_order);
    settings.crop = false;
    const auto whole = compute_turn(recording, settings, {}, for_each_in_order);
    ASSERT_TRUE(cropped) << cropped.error().message;
    ASSERT_TRUE(whole) << whole.error().message;
    EXPECT_EQ(beyond(cropped), 0);
    EXPECT_GT(beyond(whole), 500);
}

TEST(ComputeTurn, ImagesNeedARig) {
    TurnRecording recording = small_recording(3);
    recording.captures[1].load_images = []() -> Result<StereoFrame> { return StereoFrame{}; };
    const auto computed = compute(recording);
    ASSERT_FALSE(computed);
    EXPECT_THAT(computed.error().message, HasSubstr("no stereo rig"));
}

TEST(ComputeTurn, StopsWhenCancelled) {
    std::stop_source stop;
    const Progress progress{stop.get_token(), [&](std::string_view, std::size_t done, std::size_t) {
                                if (done == 2) stop.request_stop();
                            }};
    const auto computed = compute(small_recording(4), progress);
    ASSERT_FALSE(computed);
    EXPECT_EQ(computed.error().kind, ErrorKind::kCancelled);
}

}  // namespace
}  // namespace gripscan
