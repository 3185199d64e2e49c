#include "app/cell_out.h"

#include "app/console.h"
#include "core/session/cell_file.h"
#include "core/stereo/rig_file.h"

namespace gripscan::app {
namespace {

constexpr const char* kHere = "127.0.0.1";

CellFile cell_file_of(const SimCell& cell, const std::filesystem::path& rig) {
    CellFile file;
    file.robot = CellRobot{.dialect = "gsp1",
                           .host = kHere,
                           .port = cell.motion_port(),
                           .monitor_port = cell.monitor_port()};
    file.camera = FrameServer{kHere, cell.frames_port().value()};
    file.rig = rig;
    file.region = cell.region();
    file.axis_hint = cell.axis_hint();
    file.T_robot_camera = cell.T_robot_camera();
    return file;
}

}  // namespace

Status write_cell_files(const SimCell& cell, const std::filesystem::path& folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure) {
        return input_error("cannot make the folder {}: {}", folder.string(), failure.message());
    }
    const auto rig = folder / "rig.yaml";
    if (Status s = save_rig(rig, cell.rig()); !s) return s;
    return save_cell_file(folder / "cell.yaml", cell_file_of(cell, rig));
}

Status write_truth(const SimCell& cell, const std::filesystem::path& folder,
                   const Context& context) {
    if (cell.has_truth()) return cell.write_truth(folder);
    say(context,
        fmt::format("no picture was taken, so there is no truth to write to {}", folder.string()));
    return {};
}

}  // namespace gripscan::app
