#include "app/cell_out.h"

#include "core/base/atomic_file.h"
#include "core/base/number_text.h"
#include "core/stereo/rig_file.h"

namespace gripscan::app {
namespace {

std::string list(const Eigen::Vector3d& v) {
    return fmt::format("[{}, {}, {}]", text_from_number(v.x()), text_from_number(v.y()),
                       text_from_number(v.z()));
}

std::string cell_text(const SimCell& cell) {
    std::string text = "format: gripscan-cell/1\n";
    text += fmt::format(
        "robot: {{dialect: gsp1, host: 127.0.0.1, port: {}, monitor_port: {}, speed_percent: 10, "
        "settle_ms: 300}}\n",
        cell.motion_port(), cell.monitor_port());
    text += fmt::format("camera: {{driver: frames, host: 127.0.0.1, port: {}}}\n",
                        cell.frames_port().value());
    text += "rig: rig.yaml\n";
    text += fmt::format("region: {{min: {}, max: {}}}\n", list(cell.region().min_m),
                        list(cell.region().max_m));
    text += fmt::format("axis_hint: {}\n", list(cell.axis_hint()));
    return text;
}

}  // namespace

Status write_cell_files(const SimCell& cell, const std::filesystem::path& folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure) {
        return input_error("cannot make the folder {}: {}", folder.string(), failure.message());
    }
    if (Status s = save_rig(folder / "rig.yaml", cell.rig()); !s) return s;
    return write_file_atomically(folder / "cell.yaml", cell_text(cell));
}

}  // namespace gripscan::app
