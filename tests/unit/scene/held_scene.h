// A synthetic gripper that holds an object, and its template as a registration would leave it.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/base/units.h"
#include "core/registration/merge.h"
#include "core/scene/gripper_template.h"
#include "tests/support/synthetic_views.h"

namespace gripscan::test {

/// Room for both.
inline const ViewSettings kSceneView{.width_px = 170, .height_px = 130};

struct HeldScene {
    SolidPart gripper;
    SolidPart object;  ///< in the gripper's frame as it is gripped

    explicit HeldScene(std::uint64_t seed) : gripper(asymmetric_part(seed)) {
        using enum Primitive::Kind;
        SeededRandom random(seed + 77);
        object.texture = SolidTexture(seed + 2000, 25.0);
        // Between the fingers, which are 35 mm apart and end at x = 48 mm, and 30 mm beyond them.
        object.primitives = {
            {kBox, {0.052, 0.001, -0.004}, {0.026, 0.0155, random.uniform(0.018, 0.024)}},
            {kCylinder, {0.082, 0.004, 0.006}, {0.010, 0.009, 0.009}},
            {kBox, {0.066, -0.004, 0.020}, {0.008, random.uniform(0.006, 0.010), 0.010}}};
    }

    /// Both as one camera sees them; the object moved in the gripper by `slip` (gripper's frame).
    [[nodiscard]] Cloud view(double turn_rad, std::uint64_t noise_seed,
                             const Pose& slip = Pose::Identity()) const {
        const Pose T = part_turned(cell_axis(), turn_rad);
        const Cloud a = view_of(gripper, T, kSceneView, noise_seed);
        const Cloud b = view_of(object, T * slip, kSceneView, noise_seed + 1);
        return nearer_of(a, b);
    }

    /// Is this point of a view, given in the camera frame, the object's?
    [[nodiscard]] bool is_objects(const Eigen::Vector3d& p_m, double turn_rad) const {
        const Pose T_part_camera = part_turned(cell_axis(), turn_rad).inverse();
        const Eigen::Vector3d eye = T_part_camera.translation();
        const Ray ray{eye, (T_part_camera * p_m - eye).normalized()};
        const auto own = object.hit(ray);
        const auto other = gripper.hit(ray);
        return own && (!other || *own < *other);
    }

    /// Of the bare gripper, seen from all around every 15°.
    [[nodiscard]] GripperTemplate registered(std::uint64_t seed) const {
        std::vector<Cloud> clouds;
        for (int k = 0; k < 24; ++k) {
            clouds.push_back(view_of(gripper, part_turned(cell_axis(), rad_from_deg(15.0 * k)),
                                     kSceneView, seed * 100 + static_cast<std::uint64_t>(k)));
        }
        std::vector<PosedView> views;
        for (int k = 0; k < 24; ++k) {
            views.push_back({&clouds[static_cast<std::size_t>(k)],
                             turn_about(cell_axis(), rad_from_deg(-15.0 * k)), nullptr});
        }
        auto made =
            make_gripper_template(merge_views(views, {}, for_each_in_order), cell_axis(), 0.0);
        return std::move(*made);
    }

  private:
    static void take(const Cloud& from, std::size_t i, Cloud& to) {
        to.points.push_back(from.points[i]);
        to.normals.push_back(from.normals[i]);
        to.sigma.push_back(from.sigma[i]);
        to.intensity.push_back(from.intensity[i]);
        to.cell.push_back(from.cell[i]);
    }
    static Cloud nearer_of(const Cloud& a, const Cloud& b) {
        Cloud both;
        both.grid_width = a.grid_width;
        both.grid_height = a.grid_height;
        both.viewpoint = a.viewpoint;
        const auto in_a = point_of_cell(a);
        const auto in_b = point_of_cell(b);
        for (std::size_t cell = 0; cell < in_a.size(); ++cell) {
            const auto i = static_cast<std::size_t>(in_a[cell]);
            const auto j = static_cast<std::size_t>(in_b[cell]);
            if (in_a[cell] < 0 && in_b[cell] < 0) continue;
            const bool first =
                in_b[cell] < 0 || (in_a[cell] >= 0 && a.points[i].z() < b.points[j].z());
            first ? take(a, i, both) : take(b, j, both);
        }
        return both;
    }
};

}  // namespace gripscan::test
