#include "core/sim/sim_cell.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>

#include "core/base/units.h"
#include "core/camera/frame_client.h"
#include "core/robot/gsp_link.h"
#include "tests/support/temporary_folder.h"

namespace gripscan {
namespace {

std::string error_of(const SimCellSettings& settings) {
    const auto cell = SimCell::create(settings);
    return cell ? "" : cell.error().message;
}

bool same(const cv::Mat& a, const cv::Mat& b) {
    return a.size() == b.size() && cv::countNonZero(a != b) == 0;
}

bool same(const StereoFrame& a, const StereoFrame& b) {
    return same(a.left, b.left) && same(a.right, b.right);
}

/// Small pictures, and an arm that hardly takes time.
SimCellSettings quick(std::uint64_t seed, std::vector<std::string> faults = {}) {
    return {.seed = seed, .image_fraction = 4, .faults = std::move(faults), .time_scale = 200.0};
}

/// A cell and the link to its controller, as the procedure has them.
class LinkedCell {
  public:
    explicit LinkedCell(const SimCellSettings& settings)
        : cell(SimCell::create(settings).value()), robot_(settings_for(cell)) {
        robot_.connect().value();
    }
    /// The robot's joint 6 once it stands there, deg.
    double turn_to(double angle_deg) {
        constexpr double kAtOnce_deg = 40.0;  // the controller takes no longer motion
        double stands_deg = deg_from_rad(robot_.read().value().joints_rad[5]);
        do {
            const double left_deg = angle_deg - stands_deg;
            const double to_deg = std::abs(left_deg) > kAtOnce_deg
                                      ? stands_deg + std::copysign(kAtOnce_deg, left_deg)
                                      : angle_deg;
            const auto reading = robot_.turn_joint6({++id_, rad_from_deg(to_deg), 10.0}, {});
            EXPECT_TRUE(reading) << reading.error().message;
            if (!reading) return 0.0;
            stands_deg = deg_from_rad(reading->joints_rad[5]);
            if (to_deg == angle_deg) return stands_deg;
        } while (true);
    }
    StereoFrame picture_at(double angle_deg, const FrameRequest& request) {
        turn_to(angle_deg);
        return cell.source().grab(request).value();
    }

    SimCell cell;

  private:
    static gsp::GspSettings settings_for(const SimCell& cell) {
        gsp::GspSettings settings;
        settings.motion_port = cell.motion_port();
        settings.monitor_port = cell.monitor_port();
        settings.max_step_deg = 360.0;
        return settings;
    }
    gsp::GspLink robot_;
    int id_ = 0;
};

nlohmann::json truth_of(const SimCell& cell) {
    const test::TemporaryFolder folder;
    EXPECT_TRUE(cell.write_truth(folder.path()));
    std::ifstream file(folder / "truth.json");
    return nlohmann::json::parse(file);
}

TEST(SimCell, SaysWhatIsWrongWithItsSettings) {
    EXPECT_NE(error_of({.gripper = "magnet"}).find("'magnet'; there are two-finger"),
              std::string::npos);
    EXPECT_NE(error_of({.object = "egg"}).find("'egg'; there are carton"), std::string::npos);
    EXPECT_NE(error_of({.noise_levels = -1.0}).find("noise"), std::string::npos);
    EXPECT_NE(error_of({.blur_px = 1e9}).find("blur"), std::string::npos);
    EXPECT_NE(error_of({.texture_contrast = std::nan("")}).find("contrast"), std::string::npos);
    EXPECT_NE(error_of({.image_fraction = 0}).find("images"), std::string::npos);
    EXPECT_NE(error_of({.faults = {"gremlin"}}).find("'gremlin'; there are delay"),
              std::string::npos);
    EXPECT_NE(error_of({.step_deg = 0.0}).find("steps"), std::string::npos);
    EXPECT_NE(error_of({.start_joint6_deg = 400.0}).find("joint 6"), std::string::npos);
    EXPECT_NE(error_of({.time_scale = -1.0}).find("time"), std::string::npos);
    EXPECT_GE(sim_grippers().size(), 5U);
    EXPECT_GE(sim_objects().size(), 5U);
}

TEST(SimCell, ShowsTheArmAsItStands) {
    LinkedCell linked({.seed = 2, .time_scale = 200.0});
    EXPECT_EQ(linked.cell.start_joint6_rad(), rad_from_deg(-180.0));
    const auto first = linked.cell.source().grab({0, 1});
    ASSERT_TRUE(first);
    EXPECT_EQ(first->left.type(), CV_8U);
    EXPECT_EQ(first->left.size(), cv::Size(1280, 960));
    EXPECT_EQ(first->right.size(), cv::Size(1280, 960));
    const StereoFrame second = linked.picture_at(-170.0, {1, 1});
    cv::Mat changed;
    cv::absdiff(first->left, second.left, changed);
    // Noise alone hardly reaches 15 levels (five of its deviations); the gripper's change does.
    EXPECT_GT(cv::countNonZero(changed > 15), 2000);

    // The cell moves like the value it is, and goes on working.
    SimCell moved = std::move(linked.cell);
    ASSERT_TRUE(moved.source().grab({2, 1}));
    const test::TemporaryFolder folder;
    ASSERT_TRUE(moved.write_truth(folder / "truth"));
    for (const char* name : {"truth.json", "surface.ply", "visible.ply"}) {
        EXPECT_TRUE(std::filesystem::exists(folder / "truth" / name));
    }
}

TEST(SimCell, WithoutArmTheRegionIsEmptyAndTheSame) {
    SimCellSettings bare = quick(5);
    bare.with_arm = false;
    LinkedCell with(quick(5));
    LinkedCell without(bare);
    EXPECT_EQ(with.cell.region().min_m, without.cell.region().min_m);
    EXPECT_EQ(with.cell.region().max_m, without.cell.region().max_m);
    const auto first = without.cell.source().grab({0, 1});
    ASSERT_TRUE(first);
    EXPECT_TRUE(same(*first, without.picture_at(60.0, {0, 1})));
}

TEST(SimCell, AskedAgainItGivesTheSameBytes) {
    LinkedCell linked(quick(3));
    const StereoFrame first = linked.picture_at(-170.0, {1, 1});
    const StereoFrame compared = linked.cell.source().grab({1, 1, 1}).value();
    EXPECT_FALSE(same(first, compared));
    EXPECT_TRUE(same(first, linked.cell.source().grab({1, 1, 0}).value()));
    EXPECT_TRUE(same(compared, linked.cell.source().grab({1, 1, 1}).value()));
}

TEST(SimCell, KilledAndStartedAgainItShowsTheSameAtTheSameAngle) {
    const std::vector<std::string> faults = {"loose@2", "bump@3", "slip@2", "backlash@3"};
    std::vector<StereoFrame> undisturbed;
    {
        LinkedCell linked(quick(6, faults));
        for (int k = 0; k <= 4; ++k) {
            undisturbed.push_back(linked.picture_at(-180.0 + 10.0 * k, {k, 1}));
        }
    }
    LinkedCell again(quick(6, faults));
    EXPECT_TRUE(same(undisturbed[4], again.picture_at(-140.0, {4, 1})));
}

TEST(SimCell, TheFramePortGivesWhatTheCameraGives) {
    SimCellSettings settings = quick(4);
    settings.serve_frames = true;
    auto cell = SimCell::create(settings).value();
    FrameClientSettings port;
    port.port = cell.frames_port().value();
    const auto client = FrameClient::connect(port);
    ASSERT_TRUE(client) << client.error().message;
    const frames::Description& told = (*client)->description();
    EXPECT_EQ(told.rig.K_left, cell.rig().K_left);
    EXPECT_EQ(told.rig.D_right, cell.rig().D_right);
    EXPECT_EQ(told.rig.T_right_left.matrix(), cell.rig().T_right_left.matrix());
    EXPECT_EQ(told.rig.image, cell.rig().image);
    EXPECT_EQ(told.region.value().max_m, cell.region().max_m);
    EXPECT_EQ(told.axis_hint.value(), cell.axis_hint());
    const StereoFrame direct = cell.source().grab({7, 2}).value();
    const auto served = (*client)->grab({7, 2});
    ASSERT_TRUE(served) << served.error().message;
    EXPECT_TRUE(same(direct, *served));
}

TEST(SimCell, TruthTellsWhatTheFaultsDid) {
    struct Case {
        const char* fault;
        double turned_deg;  ///< from the first capture to the one 20° on
        double slipped_mm;
    };
    // Repeatability is 0.005°: five deviations of the difference of two angles.
    constexpr double kNear_deg = 0.04;
    for (const Case& c : {Case{"ratio=1.1", 22.0, 0.0}, Case{"sign", -20.0, 0.0},
                          Case{"backlash@2=0.8", 19.2, 0.0}, Case{"slip@2=2.5", 20.0, 2.5}}) {
        LinkedCell linked(quick(2, {c.fault}));
        (void)linked.picture_at(-180.0, {0, 1});
        // The encoder notices nothing.
        EXPECT_NEAR(linked.turn_to(-160.0), -160.0, 0.03);
        (void)linked.cell.source().grab({1, 1}).value();
        const auto truth = truth_of(linked.cell);
        const Pose T_first_second =
            pose_from_row_major(
                truth.at("captures").at(1).at("T_first_k").get<std::array<double, 16>>())
                .value();
        const Pose T_second_first = T_first_second.inverse();
        const Eigen::Vector3d axis = linked.cell.axis_hint();
        EXPECT_NEAR(deg_from_rad(rotation_vector(T_second_first.linear()).dot(axis)), c.turned_deg,
                    kNear_deg)
            << c.fault;
        // Out of the flange is against the axis of joint 6, whose turn is positive about it.
        const auto on_axis = truth.at("axis").at("point_m").get<std::array<double, 3>>();
        const Eigen::Vector3d p(on_axis[0], on_axis[1], on_axis[2]);
        EXPECT_NEAR((T_second_first * p - p).dot(-axis) * kMmPerM, c.slipped_mm, 0.01) << c.fault;
    }
}

TEST(SimCell, AHandBeforeTheGripperIsSeen) {
    LinkedCell clean(quick(8));
    LinkedCell disturbed(quick(8, {"intruder@2"}));
    EXPECT_TRUE(same(clean.picture_at(-170.0, {1, 1}), disturbed.picture_at(-170.0, {1, 1})));
    const StereoFrame without = clean.picture_at(-160.0, {2, 1});
    const StereoFrame with = disturbed.picture_at(-160.0, {2, 1});
    cv::Mat changed;
    cv::absdiff(without.left, with.left, changed);
    // 40 mm by 80 mm at 0.7 m are 14 px by 28 px in the small picture; most of them change.
    EXPECT_GT(cv::countNonZero(changed > 10), 250);
    EXPECT_TRUE(same(clean.picture_at(-170.0, {1, 1}), disturbed.picture_at(-170.0, {1, 1})));
}

TEST(SimCell, GlareIsGoneWithTheNextAttempt) {
    LinkedCell clean(quick(8));
    LinkedCell disturbed(quick(8, {"glare@1"}));
    const StereoFrame bright = disturbed.picture_at(-170.0, {1, 1});
    (void)clean.picture_at(-170.0, {1, 1});
    EXPECT_GT(cv::countNonZero(bright.left == 255), 500);
    EXPECT_TRUE(same(clean.cell.source().grab({1, 2}).value(),
                     disturbed.cell.source().grab({1, 2}).value()));
    EXPECT_TRUE(same(clean.picture_at(-160.0, {2, 1}), disturbed.picture_at(-160.0, {2, 1})));
}

}  // namespace
}  // namespace gripscan
