// Templates and views of parts made of boxes and cylinders.
#pragma once

#include <memory>
#include <vector>

#include "core/recognition/template_model.h"
#include "tests/support/solid_part.h"
#include "tests/support/synthetic_views.h"

namespace gripscan::test {

/// The part's surface as seen from 26 sides without noise, its own frame.
[[nodiscard]] inline Cloud surface_of(const SolidPart& part) {
    ViewSettings settings;
    settings.noise_m = 0.0;
    settings.width_px = 130;
    settings.height_px = 130;
    Cloud all;
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            for (int z = -1; z <= 1; ++z) {
                if (x == 0 && y == 0 && z == 0) continue;
                Pose T_camera_part = Pose::Identity();
                T_camera_part.linear() = Eigen::Quaterniond::FromTwoVectors(
                                             Eigen::Vector3d(x, y, z), Eigen::Vector3d::UnitZ())
                                             .toRotationMatrix();
                T_camera_part.translation() = Eigen::Vector3d(0.0, 0.0, 0.6);
                const Cloud seen =
                    transformed(view_of(part, T_camera_part, settings, 1), T_camera_part.inverse());
                all.points.insert(all.points.end(), seen.points.begin(), seen.points.end());
                all.normals.insert(all.normals.end(), seen.normals.begin(), seen.normals.end());
            }
        }
    }
    return thinned(all, 1.2e-3);
}

[[nodiscard]] inline std::shared_ptr<const TemplateModel> model_of(const SolidPart& part,
                                                                   const std::string& name) {
    const auto model = make_template_model(name, surface_of(part), {}, {}, for_each_in_order);
    return model ? *model : nullptr;
}

/// All parts of a scene in one view; the nearest surface of each ray counts.
[[nodiscard]] inline Cloud view_of_all(const std::vector<std::pair<SolidPart, Pose>>& placed,
                                       const ViewSettings& settings, std::uint64_t seed) {
    std::vector<Cloud> views;
    for (const auto& [part, T] : placed) views.push_back(view_of(part, T, settings, seed));
    Cloud all;
    all.grid_width = settings.width_px;
    all.grid_height = settings.height_px;
    all.viewpoint = Eigen::Vector3f::Zero();
    std::vector<std::vector<std::int32_t>> index;
    for (const Cloud& view : views) index.push_back(point_of_cell(view));
    for (int cell = 0; cell < settings.width_px * settings.height_px; ++cell) {
        std::optional<Eigen::Vector3f> nearest;
        for (std::size_t v = 0; v < views.size(); ++v) {
            const std::int32_t i = index[v][static_cast<std::size_t>(cell)];
            if (i < 0) continue;
            const Eigen::Vector3f& p = views[v].points[static_cast<std::size_t>(i)];
            if (!nearest || p.z() < nearest->z()) nearest = p;
        }
        if (!nearest) continue;
        all.points.push_back(*nearest);
        all.sigma.push_back(static_cast<float>(settings.noise_m));
        all.cell.push_back(cell);
    }
    estimate_normals(all, {}, for_each_in_order);
    return all;
}

}  // namespace gripscan::test
