// The text at the head of a PCD file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/cloud/cloud_file.h"
#include "core/cloud/number_type.h"

namespace gripscan {

struct PcdField {
    std::string name;
    NumberType type = NumberType::kFloat32;
    std::size_t count = 1;  ///< numbers a point has in this field
};

struct PcdHeader {
    std::vector<PcdField> fields;
    std::size_t width = 0;
    std::size_t height = 1;
    std::optional<Eigen::Vector3d> viewpoint;
    PcdEncoding encoding = PcdEncoding::kAscii;
    std::size_t body_offset = 0;  ///< of the first byte after the line DATA
    std::size_t body_line = 0;    ///< number of the first line after it

    [[nodiscard]] std::size_t points() const { return width * height; }
    [[nodiscard]] std::size_t numbers_per_point() const;
    [[nodiscard]] std::size_t bytes_per_point() const;
};

/// Also checks that the file is long enough for what the header promises.
[[nodiscard]] Result<PcdHeader> parse_pcd_header(std::string_view bytes);

}  // namespace gripscan
