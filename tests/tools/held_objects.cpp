// held_objects turn|slip WORK_FOLDER [options]: objects in the simulated gripper without robot and
// session, so that many can be tried: rendered, matched, taken apart, registered, measured.
//   turn: one object's whole turn; its template against the truth, as JSON.
//   slip: steps during which an object moves in the gripper by 1 mm or 1 deg, and as many clean
//   ones.
// The gripper's own template is registered first and kept in WORK_FOLDER.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "core/base/seeded_random.h"
#include "core/base/units.h"
#include "core/cloud/cloud_file.h"
#include "core/concurrency/worker_pool.h"
#include "core/registration/diagnosed_step.h"
#include "core/registration/grip_slip.h"
#include "core/registration/solve_turn.h"
#include "core/robot/kinematics.h"
#include "core/scene/held_pose.h"
#include "core/scene/split_view.h"
#include "core/sim/seeds.h"
#include "core/sim/sim_camera.h"
#include "core/sim/truth.h"
#include "core/stereo/rectifier.h"
#include "core/stereo/stereo_cloud.h"
#include "tests/tools/template_score.h"

namespace gripscan::test {
namespace {
namespace fs = std::filesystem;

struct Arguments {
    std::string mode;
    std::string folder;
    std::uint64_t seed = 1;
    std::string gripper = "two-finger";
    std::string object = "carton";
    double step_deg = 10.0;
    unsigned fraction = 1;
    std::string trim = "auto";
    int trials = 20;
    int first = 0;     ///< capture of the turn
    int captures = 0;  ///< of the turn; 0: all of it
};

void must(const Status& status) {
    if (!status) throw std::runtime_error(status.error().message);
}

/// The cell as it stands with joint 6 at some angle and the object where it has slid to.
class Cell {
  public:
    Cell(const Arguments& a, const std::string& object, const ForEach& for_each)
        : layout(sim::make_layout(a.seed)),
          for_each_(for_each),
          kept_(fs::path(a.folder) / "views" /
                fmt::format("{}-{}-{}-{}", a.gripper, object, a.seed, a.fraction)) {
        layout.rig = sim::shrunk(layout.rig, a.fraction);
        sim::SceneContents contents;
        contents.gripper = a.gripper;
        contents.object = object;
        contents.texture_contrast = 14.0 / sim::kGripperLevel;
        contents.seed = a.seed;
        contents.gripper_centre_m = sim::body_poses(layout.joints_rad)[sim::SceneModel::kTool] *
                                    Eigen::Vector3d(0, 0, sim::kGripperCentre_m);
        model = sim::make_scene(contents);
        region = sim::registration_area(layout, model);
        const sim::CameraSettings optics{
            {0.6, 2.0}, sim::seed_for(a.seed, sim::Use::kNoise), 0.015};
        camera_ = sim::SimCamera::create(
                      layout, model, region, optics, [this](const FrameRequest&) { return moment; },
                      for_each)
                      .value();
        rectifier_.emplace(Rectifier::create(layout.rig).value());
        moment.true_rad = layout.joints_rad;
    }

    /// `number` makes the noise. Rendered once; afterwards read from the folder.
    Cloud cloud_at(double turn_rad, int number) {
        moment.true_rad[5] = layout.joints_rad[5] + turn_rad;
        grabbed_[number] = moment;
        const fs::path file = kept_ / fmt::format("{:.3f}-{}.pcd", deg_from_rad(turn_rad), number);
        if (!fs::exists(file)) {
            fs::create_directories(kept_);
            must(save_cloud(file, rendered(number)));
        }
        return load_cloud(file).value();
    }
    [[nodiscard]] double joint6_rad(double turn_rad) const {
        return layout.joints_rad[5] + turn_rad;
    }
    [[nodiscard]] ViewField field() const {
        const RectifiedRig& rig = rectifier_->rig();
        ViewField f;
        f.min = {-rig.cx_left_px / rig.f_px, -rig.cy_px / rig.f_px};
        f.max = {(rig.image.width - 1 - rig.cx_left_px) / rig.f_px,
                 (rig.image.height - 1 - rig.cy_px) / rig.f_px};
        f.baseline_m = rig.baseline_m;
        return f;
    }
    [[nodiscard]] const sim::Moments& grabbed() const { return grabbed_; }

    sim::CellLayout layout;
    sim::SceneModel model;
    Box region;
    sim::Moment moment;

  private:
    [[nodiscard]] Cloud rendered(int number) {
        const auto frame = rectifier_->rectify(camera_->grab({number, 1, 0}).value()).value();
        return stereo_cloud(frame, rectifier_->rig(), region, {}, {}, for_each_).value().cloud;
    }

    ForEach for_each_;
    fs::path kept_;
    sim::Moments grabbed_;
    std::unique_ptr<sim::SimCamera> camera_;
    std::optional<Rectifier> rectifier_;
};

TurnSettings settings_of(const Arguments& a, const Cell& cell) {
    TurnSettings settings;
    settings.step_rad = rad_from_deg(a.step_deg);
    settings.axis_hint = sim::joint6_axis_in_camera(cell.layout).direction;
    settings.region = cell.region;
    return settings;
}

/// Registered once; afterwards read from the folder.
GripperTemplate gripper_of(const Arguments& a, const ForEach& for_each) {
    const fs::path file =
        fs::path(a.folder) / fmt::format("{}-{}-{}.pcd", a.gripper, a.seed, a.fraction);
    const fs::path axis_file = fs::path(file).replace_extension(".axis");
    Axis axis;
    double joint6_rad = 0.0;
    if (!fs::exists(axis_file)) {
        Cell cell(a, "", for_each);
        std::vector<TurnView> views;
        for (double turn_deg = 0.0; turn_deg <= 360.0; turn_deg += a.step_deg) {
            TurnView view;
            view.index = static_cast<int>(views.size());
            view.joint6_rad = cell.joint6_rad(rad_from_deg(turn_deg));
            view.cloud = cell.cloud_at(rad_from_deg(turn_deg), view.index);
            views.push_back(std::move(view));
        }
        const auto report = solve_turn(views, settings_of(a, cell), {}, for_each).value();
        must(save_cloud(file, report.merged));
        std::ofstream out(axis_file);
        out << fmt::format("{:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g}\n",
                           report.axis->axis.point_m.x(), report.axis->axis.point_m.y(),
                           report.axis->axis.point_m.z(), report.axis->axis.direction.x(),
                           report.axis->axis.direction.y(), report.axis->axis.direction.z(),
                           cell.joint6_rad(0.0));
    }
    std::ifstream in(axis_file);
    for (int k = 0; k < 3; ++k) in >> axis.point_m(k);
    for (int k = 0; k < 3; ++k) in >> axis.direction(k);
    in >> joint6_rad;
    return make_gripper_template(load_cloud(file).value(), axis, joint6_rad).value();
}

SplitView prepared(const GripperTemplate& gripper, const Arguments& a, const Cell& cell,
                   const CaptureFacts& facts, Cloud scene) {
    ObjectSplitSettings split;
    if (a.trim == "cuboid") split.trim = TrimBy::kCuboid;
    if (a.trim == "surface") split.trim = TrimBy::kSurface;
    SplitView view = prepare_split_view(gripper, split, facts, std::move(scene));
    view.view.field = cell.field();
    return view;
}

void tell(const SplitView& made, const Cell& cell, const CaptureFacts& facts) {
    if (!made.split) return fmt::print(stderr, "capture {}: {}\n", facts.index, made.view.flaw);
    const GripperMatch& g = made.split->gripper;
    // Against the truth: both turns begin at the same place.
    sim::Moment begin;
    begin.true_rad = cell.layout.joints_rad;
    const Pose T_true = sim::T_camera_part(cell.layout, cell.grabbed().at(facts.index)) *
                        sim::T_camera_part(cell.layout, begin).inverse();
    const Pose error = g.T_camera_gripper * T_true.inverse();
    const Eigen::Vector3d at = made.split->gripper_cuboid.T_frame_cuboid.translation();
    fmt::print(stderr,
               "capture {}: gripper {:.3f} deg {:.3f} mm off, {:.2f} found {:.2f} hidden {:.2f} "
               "contradicted, observable {:.2f}, {}; {}: object {} reaching {} scattered {}\n",
               facts.index, deg_from_rad(rotation_angle_rad(error.linear())),
               kMmPerM * (error * at - at).norm(), g.matched, g.hidden, g.contradicted,
               g.observability, g.trusted ? "verified" : g.sentence, word(made.split->trimmed_by),
               made.split->object.size(), made.split->reaching_in, made.split->scattered);
}

/// Of the poses that the turn ends with, the worst: angle, and the shift of the object's middle.
void tell_poses(const TurnReport& report, const PreparedTurn& turn, const Cell& cell) {
    double worst_rad = 0.0;
    double worst_m = 0.0;
    std::size_t known = 0;
    const auto true_pose = [&](std::size_t k) {
        return sim::T_camera_part(cell.layout, cell.grabbed().at(turn.facts[k].index));
    };
    for (std::size_t k = 0; k < report.poses.size(); ++k) {
        if (!report.poses[k]) continue;
        ++known;
        const Pose T_first_true = true_pose(0) * true_pose(k).inverse();
        const Pose error = *report.poses[k] * T_first_true.inverse();
        const Eigen::Vector3d at = turn.views[0]->surface.centre_m;
        worst_rad = std::max(worst_rad, rotation_angle_rad(error.linear()));
        worst_m = std::max(worst_m, (error * at - at).norm());
    }
    fmt::print(stderr, "{} of {} captures posed, worst {:.3f} deg {:.3f} mm; scale {:.5f}\n", known,
               report.poses.size(), deg_from_rad(worst_rad), kMmPerM * worst_m,
               report.angle_scale.value_or(1.0));
}

int turn(const Arguments& a, const ForEach& for_each) {
    const GripperTemplate gripper = gripper_of(a, for_each);
    Cell cell(a, a.object, for_each);
    const TurnSettings settings = settings_of(a, cell);
    PreparedTurn turn;
    std::vector<Cloud> clouds;
    const int all = 1 + static_cast<int>(std::lround(360.0 / a.step_deg));
    const int end = a.captures > 0 ? std::min(all, a.first + a.captures) : all;
    for (int k = a.first; k < end; ++k) {
        const double turn_deg = k * a.step_deg;
        CaptureFacts facts;
        facts.index = k;
        facts.joint6_rad = cell.joint6_rad(rad_from_deg(turn_deg));
        clouds.push_back(cell.cloud_at(rad_from_deg(turn_deg), facts.index));
        turn.facts.push_back(facts);
    }
    std::vector<SplitView> made(clouds.size());
    for_each(made.size(), [&](std::size_t k) {
        made[k] = prepared(gripper, a, cell, turn.facts[k], std::move(clouds[k]));
    });
    for (std::size_t k = 0; k < made.size(); ++k) tell(made[k], cell, turn.facts[k]);
    for (const SplitView& one : made) turn.views.push_back(&one.view);
    turn.steps.resize(made.size() - 1);
    for_each(turn.steps.size(), [&](std::size_t i) {
        turn.steps[i].alignment = align_views(turn.facts[i], *turn.views[i], turn.facts[i + 1],
                                              *turn.views[i + 1], settings, {}, for_each_in_order)
                                      .value();
    });
    const auto report = finish_turn(turn, settings, {}, for_each);
    if (!report) {
        fmt::print(stderr, "{}\n", report.error().message);
        return 1;
    }
    for (const TurnStep& step : report->steps) {
        const GripSlip slip = step.grip_slip.value_or(GripSlip{});
        fmt::print(stderr,
                   "step {}: error {:.3f} deg, overlap {:.2f}, slip {:.3f} ± {:.3f} mm {:.3f} ± "
                   "{:.3f} deg, {} {}: {}\n",
                   step.index, deg_from_rad(step.error_rad.value_or(9.0)),
                   step.overlap.value_or(0.0), kMmPerM * slip.shift_m, kMmPerM * slip.sigma_shift_m,
                   deg_from_rad(slip.angle_rad), deg_from_rad(slip.sigma_angle_rad),
                   word(step.verdict), word(step.cause), step.sentence);
    }
    tell_poses(*report, turn, cell);
    const fs::path truth_folder = fs::path(a.folder) / "truth";
    must(sim::write_truth_files({cell.layout, cell.model, cell.region, cell.grabbed()},
                                truth_folder, for_each));
    const auto truth = load_object_truth(truth_folder).value();
    const TemplateScore score = score_template(report->merged, Pose::Identity(), truth);
    must(save_cloud(fs::path(a.folder) / fmt::format("{}-{}.pcd", a.object, a.seed),
                    report->merged));
    fmt::print(
        "{} seed {}: {} points, RMS {:.3f} mm, p99 {:.2f}, max {:.2f}, visible {:.4f}, foreign "
        "{:.4f}; {} of {} steps trusted\n",
        a.object, a.seed, score.points, score.rms_mm, score.p99_mm, score.max_mm, score.coverage,
        score.foreign, trusted_steps(*report), report->steps.size());
    return 0;
}

/// One step of a held object that moves by `slip` in the gripper; what was found.
std::string try_step(const Arguments& a, Cell& cell, const GripperTemplate& gripper,
                     double from_deg, const Pose& slip, int number, const ForEach& for_each) {
    std::array<SplitView, 2> views;
    std::array<CaptureFacts, 2> facts;
    for (std::size_t i = 0; i < 2; ++i) {
        const double turn_rad = rad_from_deg(from_deg + static_cast<double>(i) * a.step_deg);
        facts[i].index = 2 * number + static_cast<int>(i);
        facts[i].joint6_rad = cell.joint6_rad(turn_rad);
        cell.moment.T_part_object =
            i == 0 ? Pose::Identity()
                   : cell.model.T_tool_grasp * slip * cell.model.T_tool_grasp.inverse();
        views[i] = prepared(gripper, a, cell, facts[i], cell.cloud_at(turn_rad, facts[i].index));
    }
    const TurnSettings settings = settings_of(a, cell);
    StepFinding finding;
    finding.alignment =
        align_views(facts[0], views[0].view, facts[1], views[1].view, settings, {}, for_each)
            .value();
    const std::optional<ImageFault> none;
    const auto judged =
        diagnosed_step({facts[0], views[0].view, none}, {facts[1], views[1].view, none}, finding,
                       AxisEstimate{gripper.axis, 0.0, 0.0}, settings);
    const GripSlip found = judged.step.grip_slip.value_or(GripSlip{});
    fmt::print(stderr, "{:.3f} ± {:.3f} mm, {:.3f} ± {:.3f} deg: {} {}: {}\n",
               kMmPerM * found.shift_m, kMmPerM * found.sigma_shift_m,
               deg_from_rad(found.angle_rad), deg_from_rad(found.sigma_angle_rad),
               word(judged.step.verdict), word(judged.step.cause), judged.step.sentence);
    return judged.step.cause == Cause::kSlip ? "slip" : "no slip";
}

int slips(const Arguments& a, const ForEach& for_each) {
    const GripperTemplate gripper = gripper_of(a, for_each);
    Cell cell(a, a.object, for_each);
    SeededRandom random(a.seed + 500);
    int found_mm = 0;
    int found_deg = 0;
    int alarms = 0;
    for (int i = 0; i < a.trials; ++i) {
        const double from_deg = random.uniform(0.0, 360.0);
        const double towards = random.uniform(0.0, 2.0 * 3.14159265358979);
        Pose slid = Pose::Identity();
        slid.translation() = 1e-3 * Eigen::Vector3d(0.0, std::cos(towards), std::sin(towards));
        Pose turned = Pose::Identity();
        turned.linear() = rotation_from_vector({rad_from_deg(i % 2 == 0 ? 1.0 : -1.0), 0.0, 0.0});
        const int n = 3 * i + 1;
        if (try_step(a, cell, gripper, from_deg, slid, n, for_each) == "slip") ++found_mm;
        if (try_step(a, cell, gripper, from_deg, turned, n + 1, for_each) == "slip") ++found_deg;
        if (try_step(a, cell, gripper, from_deg, Pose::Identity(), n + 2, for_each) == "slip") {
            ++alarms;
        }
    }
    fmt::print("{} seed {}: 1 mm found in {} of {}, 1 deg in {} of {}, false alarms in {} of {}\n",
               a.object, a.seed, found_mm, a.trials, found_deg, a.trials, alarms, a.trials);
    return 0;
}

}  // namespace
}  // namespace gripscan::test

int main(int argc, char** argv) {
    using namespace gripscan;
    test::Arguments a;
    CLI::App app{"Objects in the simulated gripper, measured against the truth"};
    app.add_option("mode", a.mode, "turn or slip")
        ->required()
        ->check(CLI::IsMember({"turn", "slip"}));
    app.add_option("folder", a.folder, "where templates are kept")->required();
    app.add_option("--seed", a.seed);
    app.add_option("--gripper", a.gripper);
    app.add_option("--object", a.object);
    app.add_option("--step-deg", a.step_deg);
    app.add_option("--fraction", a.fraction, "of the camera's pixels a side: 1/N");
    app.add_option("--trim", a.trim);
    app.add_option("--trials", a.trials);
    app.add_option("--first", a.first, "capture of the turn to begin with");
    app.add_option("--captures", a.captures, "so many of the turn; 0: all");
    CLI11_PARSE(app, argc, argv);
    std::filesystem::create_directories(a.folder);
    WorkerPool pool(threads_wanted());
    return a.mode == "turn" ? test::turn(a, pool.for_each()) : test::slips(a, pool.for_each());
}
