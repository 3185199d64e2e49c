#include "core/session/alignment_file.h"

#include <algorithm>

#include "core/base/atomic_file.h"
#include "core/session/strict_yaml.h"

namespace gripscan {

Result<Pose> load_alignment(const std::filesystem::path& path) {
    const auto text = read_whole_file(path);
    if (!text) return forward_error(text.error());
    StrictYaml yaml = StrictYaml::parse(path, *text);
    const auto numbers = yaml.numbers("alignment", 16);
    if (const Status read = yaml.status(); !read) return forward_error(read.error());
    if (!numbers) {
        return input_error("{} has no key 'alignment' with the 16 numbers of T_robot_camera",
                           path.string());
    }
    std::array<double, 16> values{};
    std::copy(numbers->begin(), numbers->end(), values.begin());
    const auto T = pose_from_row_major(values);
    if (!T) {
        return input_error("{}: 'alignment' is no rigid motion (row-major 4 x 4, metres)",
                           path.string());
    }
    return *T;
}

}  // namespace gripscan
