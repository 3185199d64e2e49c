#include "tests/tools/clutter_view.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include "core/base/progress.h"
#include "core/base/seeded_random.h"
#include "core/base/units.h"
#include "core/robot/kinematics.h"
#include "core/sim/cell_layout.h"
#include "core/sim/grippers.h"
#include "core/sim/objects.h"
#include "core/sim/ray_scene.h"
#include "core/sim/seeds.h"
#include "core/sim/sim_camera.h"
#include "core/sim/sim_cell.h"
#include "core/sim/surface_samples.h"
#include "core/stereo/rectifier.h"
#include "core/stereo/stereo_cloud.h"

namespace gripscan::test {
namespace {

using sim::SceneModel;

/// Objects are as wide as the first gripper opens.
constexpr double kOpening_m = 0.046;
const std::vector<std::string> kGrippers{"two-finger", "three-finger"};
const std::vector<std::string> kObjects{"carton", "jug", "bracket", "hexagon"};

bool is_gripper(const std::string& name) {
    return std::find(kGrippers.begin(), kGrippers.end(), name) != kGrippers.end();
}

std::vector<sim::Part> parts_of(const std::string& name) {
    return is_gripper(name) ? sim::make_gripper(name).parts : sim::make_object(name, kOpening_m);
}

Eigen::Matrix3d random_rotation(SeededRandom& random) {
    const Eigen::Quaterniond q(random.normal(), random.normal(), random.normal(), random.normal());
    return q.normalized().toRotationMatrix();
}

/// Where something goes, in the camera frame; z says how far away.
Pose random_place(SeededRandom& random, double near_m, double far_m) {
    Pose T = Pose::Identity();
    T.linear() = random_rotation(random);
    const double z = random.uniform(near_m, far_m);
    T.translation() = Eigen::Vector3d(random.uniform(-0.20, 0.12) * z / 0.74,
                                      random.uniform(-0.16, 0.16) * z / 0.74, z);
    return T;
}

double radius_m(const std::vector<sim::Part>& parts) {
    double radius = 0.0;
    for (const sim::Part& part : parts) {
        for (const auto& v : part.mesh.vertices) radius = std::max(radius, v.norm());
    }
    return radius;
}

/// Something that is none of the templates.
std::vector<sim::Part> junk(SeededRandom& random) {
    sim::Part part{"junk", {}, {}};
    part.material.albedo = random.uniform(0.35, 0.65);
    switch (random.next() % 4) {
        case 0:
            part.mesh = sim::chamfered_box({random.uniform(0.02, 0.09), random.uniform(0.02, 0.09),
                                            random.uniform(0.02, 0.09)},
                                           0.002);
            break;
        case 1: {
            const double half = random.uniform(0.02, 0.05);
            part.mesh = sim::cylinder(random.uniform(0.012, 0.04), -half, half);
            break;
        }
        case 2:
            part.mesh = sim::sphere(random.uniform(0.02, 0.045));
            break;
        default:
            return sim::make_object("casting", random.uniform(0.04, 0.055));
    }
    return {part};
}

struct Ball {
    Eigen::Vector3d centre_m;
    double radius_m;
};

class Builder {
  public:
    explicit Builder(const ClutterSettings& settings)
        : settings_(settings),
          random_(settings.seed * 7919 + 17),
          layout_(sim::make_layout(settings.seed)) {
        layout_.rig = sim::shrunk(layout_.rig, settings.image_fraction);
        layout_.joints_rad[5] = random_.uniform(-3.0, 3.0);
        layout_.joints_rad[4] += random_.uniform(-0.10, 0.10);
        layout_.joints_rad[3] += random_.uniform(-0.15, 0.15);
    }

    [[nodiscard]] Result<ClutterView> make(const ForEach& for_each);

  private:
    struct Placed {
        std::string name;
        Pose T_world_template;
        std::size_t body;
        std::size_t first_part, parts;
    };

    void build_arm();
    void put(const std::vector<sim::Part>& parts, const Pose& T_camera_part);
    [[nodiscard]] bool free_for(const Eigen::Vector3d& centre_m, double radius_m) const;
    void scatter();
    [[nodiscard]] TrueTemplate truth(const Placed& placed, sim::RayScene& scene) const;
    [[nodiscard]] Result<Cloud> take(const ForEach& for_each);

    ClutterSettings settings_;
    SeededRandom random_;
    sim::CellLayout layout_;
    SceneModel model_;
    std::vector<Placed> placed_;
    std::vector<Ball> taken_;  ///< camera frame
};

/// The arm, mostly with a gripper that is a template, half of the time with an object in it.
void Builder::build_arm() {
    sim::SceneContents contents;
    if (settings_.templates_present) {
        contents.gripper = kGrippers[random_.next() % 3 == 0 ? 1 : 0];
        if (random_.next() % 2 == 0) contents.object = kObjects[random_.next() % kObjects.size()];
        // Objects are made for the opening of their gripper, the templates for the first one's. A
        // carton that is some millimetres wider is no template, and is no fair "absent" either.
        if (!contents.object.empty() && sim::make_gripper(contents.gripper).opening_m != kOpening_m)
            contents.object = "casting";
    } else {
        contents.gripper = random_.next() % 2 == 0 ? "suction" : "parallel-wide";
    }
    contents.texture_contrast = kSimTextureLevels / sim::kGripperLevel;
    contents.seed = settings_.seed;
    const Pose T_world_tool = tool_pose(layout_.joints_rad);
    contents.gripper_centre_m = T_world_tool * Eigen::Vector3d(0, 0, sim::kGripperCentre_m);
    model_ = sim::make_scene(contents);
    const sim::Gripper gripper = sim::make_gripper(contents.gripper);
    const Pose T_camera_tool = layout_.T_world_camera.inverse() * T_world_tool;
    taken_.push_back({T_camera_tool * Eigen::Vector3d(0, 0, 0.07), 0.14});
    if (!settings_.templates_present) return;
    placed_.push_back({contents.gripper, T_world_tool, SceneModel::kTool, 0, gripper.parts.size()});
    if (contents.object.empty() || contents.object == "casting") return;
    placed_.push_back({contents.object, T_world_tool * gripper.T_tool_grasp, SceneModel::kTool,
                       gripper.parts.size(),
                       model_.bodies[SceneModel::kTool].parts.size() - gripper.parts.size()});
}

void Builder::put(const std::vector<sim::Part>& parts, const Pose& T_camera_part) {
    auto& body = model_.bodies[SceneModel::kIntruder];
    const Pose T = layout_.T_world_camera * T_camera_part;
    for (sim::Part part : parts) {
        part.mesh = sim::moved(part.mesh, T);
        part.material.texture = {.cell_m = 0.012,
                                 .octaves = 4,
                                 .gain = 1.25,
                                 .contrast = kSimTextureLevels / sim::kGripperLevel};
        part.material.texture.seed = static_cast<std::uint32_t>(random_.next());
        body.parts.push_back(std::move(part));
    }
}

bool Builder::free_for(const Eigen::Vector3d& centre_m, double radius_m) const {
    return std::all_of(taken_.begin(), taken_.end(), [&](const Ball& b) {
        return (b.centre_m - centre_m).norm() > b.radius_m + radius_m;
    });
}

/// Objects lying about, clutter around, and one or two things between them and the camera.
void Builder::scatter() {
    const auto place = [&](const std::vector<sim::Part>& parts, double near_m, double far_m) {
        for (int attempt = 0; attempt < 40; ++attempt) {
            const Pose T = random_place(random_, near_m, far_m);
            const double radius = radius_m(parts);
            if (!free_for(T.translation(), radius)) continue;
            put(parts, T);
            taken_.push_back({T.translation(), radius});
            return std::optional<Pose>(T);
        }
        return std::optional<Pose>();
    };
    auto& body = model_.bodies[SceneModel::kIntruder];
    if (settings_.templates_present) {
        const int lying = 1 + static_cast<int>(random_.next() % 2);
        for (int i = 0; i < lying; ++i) {
            const std::string name = kObjects[random_.next() % kObjects.size()];
            const bool there = std::any_of(placed_.begin(), placed_.end(),
                                           [&](const Placed& p) { return p.name == name; });
            if (there) continue;
            const std::size_t first = body.parts.size();
            const auto parts = parts_of(name);
            if (const auto T = place(parts, 0.62, 0.85)) {
                placed_.push_back({name, layout_.T_world_camera * *T, SceneModel::kIntruder, first,
                                   parts.size()});
            }
        }
    }
    const int around = 2 + static_cast<int>(random_.next() % 3);
    for (int i = 0; i < around; ++i) place(junk(random_), 0.60, 0.90);
    const int in_front = 1 + static_cast<int>(random_.next() % 2);
    for (int i = 0; i < in_front; ++i) place(junk(random_), 0.48, 0.58);
}

TrueTemplate Builder::truth(const Placed& placed, sim::RayScene& scene) const {
    TrueTemplate t;
    t.name = placed.name;
    t.T_camera_template = layout_.T_world_camera.inverse() * placed.T_world_template;
    SceneModel alone;
    alone.bodies[SceneModel::kIntruder].parts = {};
    for (sim::Part part : parts_of(placed.name)) {
        part.mesh = sim::moved(part.mesh, placed.T_world_template);
        alone.bodies[SceneModel::kIntruder].parts.push_back(std::move(part));
    }
    auto single = sim::RayScene::create(alone);
    if (!single) return t;
    std::array<Pose, SceneModel::kBodies> still;
    still.fill(Pose::Identity());
    single->place(still);
    const Eigen::Vector3f eye = layout_.T_world_left().translation().cast<float>();
    int facing = 0, seen = 0, detail_facing = 0, detail_seen = 0;
    for (const sim::Part& part : alone.bodies[SceneModel::kIntruder].parts) {
        for (const auto& s : sim::sample_surface(part.mesh, 0.003)) {
            const Eigen::Vector3f p = (s.point_m + 2e-4 * s.normal).cast<float>();
            const bool tells = part.name == "tab";
            detail_facing += tells ? 1 : 0;
            if (s.normal.cast<float>().dot(eye - p) <= 0.0F || single->blocked(eye, p)) continue;
            ++facing;
            if (scene.blocked(eye, p)) continue;
            ++seen;
            detail_seen += tells ? 1 : 0;
        }
    }
    t.visible = facing > 0 ? static_cast<double>(seen) / facing : 0.0;
    // Of a detail all around, at best about half faces the camera.
    if (detail_facing > 0) t.telling_detail = 2.0 * detail_seen / detail_facing;
    return t;
}

Result<Cloud> Builder::take(const ForEach& for_each) {
    const Box region{{-0.30, -0.24, 0.42}, {0.24, 0.24, 1.00}};
    const JointAngles joints = layout_.joints_rad;
    auto camera = sim::SimCamera::create(
        layout_, model_, region, {{0.6, 2.0}, sim::seed_for(settings_.seed, sim::Use::kNoise), 0.0},
        [joints](const FrameRequest&) {
            sim::Moment moment;
            moment.true_rad = joints;
            moment.intruder = true;
            return moment;
        },
        for_each);
    if (!camera) return forward_error(camera.error());
    const auto frame = (*camera)->grab({});
    if (!frame) return forward_error(frame.error());
    const auto rectifier = Rectifier::create(layout_.rig);
    if (!rectifier) return forward_error(rectifier.error());
    const auto rectified = rectifier->rectify(*frame);
    if (!rectified) return forward_error(rectified.error());
    auto made = stereo_cloud(*rectified, rectifier->rig(), region, {}, {}, for_each);
    if (!made) return forward_error(made.error());
    return std::move(made->cloud);
}

Result<ClutterView> Builder::make(const ForEach& for_each) {
    build_arm();
    scatter();
    ClutterView view;
    auto cloud = take(for_each);
    if (!cloud) return forward_error(cloud.error());
    view.cloud = std::move(*cloud);
    auto scene = sim::RayScene::create(model_);
    if (!scene) return forward_error(scene.error());
    sim::Moment moment;
    moment.true_rad = layout_.joints_rad;
    moment.intruder = true;
    scene->place(sim::body_poses(moment));
    for (const Placed& placed : placed_) view.present.push_back(truth(placed, *scene));
    return view;
}

}  // namespace

std::vector<std::string> exam_templates() {
    std::vector<std::string> all = kGrippers;
    all.insert(all.end(), kObjects.begin(), kObjects.end());
    return all;
}

sim::Mesh template_mesh(const std::string& name) {
    sim::Mesh mesh;
    for (const sim::Part& part : parts_of(name)) sim::append(mesh, part.mesh);
    return mesh;
}

Result<ClutterView> make_clutter_view(const ClutterSettings& settings, const ForEach& for_each) {
    return Builder(settings).make(for_each);
}

}  // namespace gripscan::test
