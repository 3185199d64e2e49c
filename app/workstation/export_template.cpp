#include "app/workstation/export_template.h"

#include <nlohmann/json.hpp>

#include "app/workstation/stoppable_loop.h"
#include "core/base/atomic_file.h"
#include "core/base/units.h"
#include "core/cloud/cloud_file.h"
#include "core/geometry/axis_frame.h"

namespace gripscan::app {
namespace {
namespace fs = std::filesystem;

void drop_unwanted(Cloud& cloud, const ui::ExportWish& wish) {
    if (!wish.normals) cloud.normals.clear();
    if (!wish.intensity) cloud.intensity.clear();
    if (!wish.seen) cloud.seen.clear();
    if (!wish.sigma) cloud.sigma.clear();
}

using Json = nlohmann::ordered_json;

Json crop_json(const TemplateFilter& filter) {
    if (!filter.crop) return {};
    const Eigen::Vector3d& a = filter.crop->min_m;
    const Eigen::Vector3d& b = filter.crop->max_m;
    return {{"min", {a.x(), a.y(), a.z()}},
            {"max", {b.x(), b.y(), b.z()}},
            {"inverted", filter.invert_crop}};
}

Json filter_json(const TemplateFilter& filter) {
    return {{"crop_m", crop_json(filter)},
            {"min_seen", filter.min_seen},
            {"denoise_sigmas", filter.denoise_sigmas},
            {"denoise_neighbours", filter.denoise_neighbours}};
}

/// gripscan-export/1: what a file without a header for it cannot say of itself.
std::string sidecar(const TurnReport& report, const ui::ExportWish& wish, const Cloud& cloud) {
    const auto& closure = report.closure_after;
    return Json{{"format", "gripscan-export/1"},
                {"file", wish.file.filename().string()},
                {"software", GRIPSCAN_VERSION},
                {"points", cloud.size()},
                {"unit", wish.millimetres ? "mm" : "m"},
                {"frame", wish.axis_frame ? "axis" : "camera"},
                {"steps", report.steps.size()},
                {"accepted", trusted_steps(report)},
                {"closure_deg", closure ? Json(deg_from_rad(closure->angle_rad)) : Json()},
                {"closure_mm", closure ? Json(closure->shift_m * kMmPerM) : Json()},
                {"filter", filter_json(wish.filter)}}
               .dump(2) +
           "\n";
}

/// The points as they are wanted. Errors: none are left, no axis is known, cancelled.
Result<Cloud> wanted_cloud(const TurnReport& report, const ui::ExportWish& wish,
                           const Progress& progress, const ForEach& for_each) {
    const FilteredTemplate filtered =
        filter_template(report.merged, wish.filter, stoppable(for_each, progress.stop));
    if (progress.cancelled()) return cancelled_error();
    Cloud cloud = select(report.merged, filtered.kept);
    if (cloud.empty()) {
        return input_error("nothing is left to export: the filters take all {} points away",
                           report.merged.size());
    }
    drop_unwanted(cloud, wish);
    if (!wish.axis_frame) return cloud;
    if (!report.axis) {
        return input_error("no joint axis is known for this turn; export in the camera's frame");
    }
    return transformed(cloud, T_axis_camera(report.axis->axis, centroid(cloud)));
}

Status save_sidecar(const TurnReport& report, const ui::ExportWish& wish, const Cloud& cloud,
                    const Progress& progress) {
    if (progress.cancelled()) return cancelled_error();
    return write_file_atomically(fs::path(wish.file.string() + ".json"),
                                 sidecar(report, wish, cloud));
}

}  // namespace

JournalFields journal_fields(const ui::ExportWish& wish) {
    return {{"file", wish.file.string()},
            {"unit", wish.millimetres ? "mm" : "m"},
            {"frame", wish.axis_frame ? "axis" : "camera"},
            {"filter", filter_json(wish.filter).dump()}};
}

JournalFields journal_fields(const Exported& exported) {
    return {{"file", exported.file.string()},
            {"points", std::to_string(exported.points)},
            {"bytes", std::to_string(exported.bytes)}};
}

Result<Exported> export_template(const TurnReport& report, const ui::ExportWish& wish,
                                 const Progress& progress, const ForEach& for_each) {
    constexpr std::size_t kStages = 3;
    std::error_code code;
    if (fs::exists(wish.file, code)) {
        return input_error("{} is there already; choose another name, nothing is overwritten",
                           wish.file.string());
    }
    progress.tell("filter", 0, kStages);
    const auto cloud = wanted_cloud(report, wish, progress, for_each);
    if (!cloud) return forward_error(cloud.error());
    progress.tell("write", 1, kStages);
    if (progress.cancelled()) return cancelled_error();
    fs::create_directories(wish.file.parent_path(), code);
    CloudFileOptions options;
    options.encoding = wish.encoding;
    options.metres_per_unit = wish.millimetres ? 0.001 : 1.0;
    if (Status saved = save_cloud(wish.file, *cloud, options); !saved) {
        return forward_error(saved.error());
    }
    progress.tell("sidecar", 2, kStages);
    if (Status saved = save_sidecar(report, wish, *cloud, progress); !saved) {
        fs::remove(wish.file, code);  // without its sidecar it cannot say what it is
        return forward_error(saved.error());
    }
    return Exported{wish.file, cloud->size(), fs::file_size(wish.file, code)};
}

}  // namespace gripscan::app
