#include "tests/render/synthetic_cell.h"

#include <cmath>
#include <numbers>

#include "core/base/seeded_random.h"
#include "ui/render/primitives.h"

namespace gripscan::test {
namespace {

using Eigen::Vector3d;
constexpr double kPi = std::numbers::pi;
const Vector3d kCentre(0.0, 0.0, 0.7);

struct Sample {
    Vector3d p;
    Vector3d n;
};

Sample on_cylinder(SeededRandom& random) {
    const double angle = random.uniform(0.0, 2.0 * kPi);
    const Vector3d n(0.0, std::cos(angle), std::sin(angle));
    return {kCentre + Vector3d(random.uniform(-0.05, 0.05), 0, 0) + 0.035 * n, n};
}

Sample on_box(SeededRandom& random, const Vector3d& centre, const Vector3d& half) {
    const int axis = static_cast<int>(random.uniform(0.0, 3.0));
    const double side = random.uniform() < 0.5 ? -1.0 : 1.0;
    Vector3d p(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    p(axis) = side;
    return {kCentre + centre + p.cwiseProduct(half), side * Vector3d::Unit(axis)};
}

Sample on_part(SeededRandom& random) {
    const double which = random.uniform();
    if (which < 0.5) return on_cylinder(random);
    if (which < 0.8) return on_box(random, {0.0, -0.035, 0.0}, {0.03, 0.012, 0.03});
    const double x = which < 0.9 ? -0.03 : 0.03;
    return on_box(random, {x, 0.05, 0.0}, {0.008, 0.02, 0.012});
}

/// The step that looks at a normal most directly: the turn goes about x.
int step_of(const Vector3d& n, int steps) {
    const double angle = std::atan2(n.y(), -n.z()) + kPi;
    return std::min(steps - 1, static_cast<int>(angle / (2.0 * kPi) * steps));
}

}  // namespace

std::vector<ui::PointChunk> synthetic_part(std::size_t points, int steps) {
    SeededRandom random(7);
    std::vector<std::shared_ptr<Cloud>> clouds;
    std::vector<std::shared_ptr<std::vector<float>>> residuals;
    for (int i = 0; i < steps; ++i) {
        clouds.push_back(std::make_shared<Cloud>());
        residuals.push_back(std::make_shared<std::vector<float>>());
    }
    for (std::size_t i = 0; i < points; ++i) {
        const Sample s = on_part(random);
        const auto step = static_cast<std::size_t>(step_of(s.n, steps));
        Cloud& cloud = *clouds[step];
        const double noise = 0.0002 * random.normal();
        cloud.points.push_back((s.p + noise * s.n).cast<float>());
        cloud.normals.push_back(s.n.cast<float>());
        cloud.intensity.push_back(static_cast<float>(110.0 + 60.0 * std::sin(400.0 * s.p.x()) *
                                                                 std::sin(400.0 * s.p.y())));
        cloud.sigma.push_back(static_cast<float>(0.0002 + 0.002 * std::abs(s.p.x())));
        cloud.seen.push_back(static_cast<std::uint16_t>(1 + 240.0 * (s.p.x() + 0.05)));
        residuals[step]->push_back(static_cast<float>(std::abs(noise)));
    }
    std::vector<ui::PointChunk> chunks;
    for (int i = 0; i < steps; ++i) {
        const auto index = static_cast<std::size_t>(i);
        ui::PointChunk chunk;
        chunk.id = index + 1;
        chunk.cloud = clouds[index];
        chunk.residual_m = residuals[index];
        chunk.step = static_cast<std::uint16_t>(i + 1);
        chunks.push_back(std::move(chunk));
    }
    return chunks;
}

ui::LineBatch synthetic_lines(const ui::Theme& theme, const Vector3d& eye_m) {
    using ui::HiddenStyle;
    ui::LineBatch lines;
    const Axis axis{kCentre, Vector3d::UnitX()};
    const Pose here = Pose(Eigen::Translation3d(kCentre));
    ui::add_grid(lines, kCentre + Vector3d(0, 0.11, 0), Vector3d::UnitY(), 0.4, 0.05,
                 {theme.text.with_alpha(0.08), 1.0F, {}, HiddenStyle::kGone});
    ui::add_box(lines, {{-0.11, -0.1, -0.1}, {0.11, 0.1, 0.1}}, here,
                {theme.text_third, 1.0F, {}, HiddenStyle::kFaint});
    ui::add_box(lines, {{0.055, -0.03, -0.03}, {0.15, 0.03, 0.03}}, here,
                {theme.gripper, 1.6F, {}, HiddenStyle::kFaint});
    ui::add_axis(lines, axis, -0.16, 0.32, {theme.axis, 1.6F, {14, 4, 3, 4}});
    ui::add_arc(lines, axis, kCentre + Vector3d(-0.09, -0.07, 0), 0.0, 2.4, {theme.axis, 2.4F});
    ui::add_arc(lines, axis, kCentre + Vector3d(-0.09, -0.07, 0), 2.4, 2.0 * kPi,
                {theme.text_third, 1.0F});
    ui::add_capsule(lines, kCentre + Vector3d(0.17, 0, 0), kCentre + Vector3d(0.3, 0, 0), 0.04,
                    eye_m, {theme.text_third, 1.2F});
    ui::add_cross(lines, kCentre, 0.008, {theme.accent_text, 1.2F, {}, HiddenStyle::kSame});
    RectifiedRig rig;
    rig.image = {640, 480};
    rig.f_px = 700.0;
    rig.cx_left_px = rig.cx_right_px = 320.0;
    rig.cy_px = 240.0;
    rig.baseline_m = 0.12;
    ui::add_frustum(lines, rig, 0.12, {theme.text_third, 1.0F, {2, 5, 0, 0}});
    return lines;
}

}  // namespace gripscan::test
