#include "core/session/alignment_file.h"

#include <array>

#include "core/base/atomic_file.h"
#include "core/base/number_text.h"
#include "core/session/cell_file.h"
#include "core/session/yaml_parts.h"

namespace gripscan {
namespace {

constexpr std::array<std::pair<const char*, std::optional<Pose> AlignmentFile::*>, 4> kPoses = {
    {{"T_robot_camera", &AlignmentFile::T_robot_camera},
     {"T_flange_camera", &AlignmentFile::T_flange_camera},
     {"T_flange_board", &AlignmentFile::T_flange_board},
     {"T_robot_board", &AlignmentFile::T_robot_board}}};

constexpr std::array<std::pair<const char*, double AlignmentFile::*>, 7> kNumbers = {
    {{"spread_mm", &AlignmentFile::spread_mm},
     {"spread_deg", &AlignmentFile::spread_deg},
     {"spread_max_mm", &AlignmentFile::spread_max_mm},
     {"spread_max_deg", &AlignmentFile::spread_max_deg},
     {"reprojection_px", &AlignmentFile::reprojection_px},
     {"sd_mm", &AlignmentFile::sd_mm},
     {"sd_deg", &AlignmentFile::sd_deg}}};

/// By the format it claims; what it is worth its own reader says.
bool is_cell_file(const std::filesystem::path& path) {
    const auto text = read_whole_file(path);
    return text && text->find("gripscan-cell/1") != std::string::npos;
}

}  // namespace

Status save_alignment(const std::filesystem::path& path, const AlignmentFile& file) {
    std::string text = "format: gripscan-alignment/1\n";
    for (const auto& [key, member] : kPoses) {
        if (file.*member) text += pose_line(key, *(file.*member));
    }
    if (!file.method.empty()) text += fmt::format("method: {}\n", yaml_quoted(file.method));
    text += fmt::format("views: {}\n", file.views);
    for (const auto& [key, member] : kNumbers) {
        text += fmt::format("{}: {}\n", key, text_from_number(file.*member));
    }
    return write_file_atomically(path, text);
}

Result<AlignmentFile> load_alignment(const std::filesystem::path& path) {
    const auto text = read_whole_file(path);
    if (!text) return forward_error(text.error());
    StrictYaml yaml = StrictYaml::parse(path, *text);
    require_format(yaml, "gripscan-alignment/1");
    AlignmentFile file;
    for (const auto& [key, member] : kPoses) file.*member = read_pose(yaml, key);
    file.method = yaml.text("method").value_or("");
    file.views = static_cast<int>(yaml.number("views").value_or(0.0));
    for (const auto& [key, member] : kNumbers) file.*member = yaml.number(key).value_or(0.0);
    yaml.reject_other_keys();
    if (!file.T_robot_camera && !file.T_flange_camera) {
        yaml.fail("T_robot_camera", "is missing (or T_flange_camera, where the robot carries it)");
    }
    if (Status status = yaml.status(); !status) return forward_error(status.error());
    return file;
}

Result<Pose> load_standing_camera(const std::filesystem::path& path) {
    if (is_cell_file(path)) {
        return input_error(
            "{} is a cell file; name the file that `gripscan calibrate robot` wrote, or write the "
            "16 numbers of T_robot_camera themselves",
            path.string());
    }
    const auto file = load_alignment(path);
    if (!file) return forward_error(file.error());
    if (file->T_robot_camera) return *file->T_robot_camera;
    return input_error("{} is of a camera on the flange; here it must stand still", path.string());
}

Result<Pose> load_robot_camera(const std::filesystem::path& path) {
    if (is_cell_file(path)) {
        const auto cell = load_cell_file(path);
        if (!cell) return forward_error(cell.error());
        if (cell->T_robot_camera) return *cell->T_robot_camera;
        return input_error("the cell file {} does not say where the camera stands (alignment)",
                           path.string());
    }
    return load_standing_camera(path);
}

}  // namespace gripscan
