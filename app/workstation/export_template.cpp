#include "app/workstation/export_template.h"

#include "core/cloud/cloud_file.h"
#include "core/report/axis_frame.h"

namespace gripscan::app {
namespace {
namespace fs = std::filesystem;

void drop_unwanted(Cloud& cloud, const ui::ExportWish& wish) {
    if (!wish.normals) cloud.normals.clear();
    if (!wish.intensity) cloud.intensity.clear();
    if (!wish.seen) cloud.seen.clear();
    if (!wish.sigma) cloud.sigma.clear();
}

}  // namespace

Result<Exported> export_template(const TurnReport& report, const ui::ExportWish& wish,
                                 const ForEach& for_each) {
    std::error_code code;
    if (fs::exists(wish.file, code)) {
        return input_error("{} is there already; choose another name, nothing is overwritten",
                           wish.file.string());
    }
    const FilteredTemplate filtered = filter_template(report.merged, wish.filter, for_each);
    Cloud cloud = select(report.merged, filtered.kept);
    if (cloud.empty()) {
        return input_error("nothing is left to export: the filters take all {} points away",
                           report.merged.size());
    }
    drop_unwanted(cloud, wish);
    if (wish.axis_frame) {
        if (!report.axis) {
            return input_error(
                "no joint axis is known for this turn; export in the camera's frame");
        }
        cloud = transformed(cloud, T_axis_camera(report.axis->axis, centroid(cloud)));
    }
    CloudFileOptions options;
    options.encoding = wish.encoding;
    options.metres_per_unit = wish.millimetres ? 0.001 : 1.0;
    if (Status saved = save_cloud(wish.file, cloud, options); !saved) {
        return forward_error(saved.error());
    }
    return Exported{wish.file, cloud.size(), fs::file_size(wish.file, code)};
}

}  // namespace gripscan::app
