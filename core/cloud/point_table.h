// What a point file holds before it becomes a Cloud: named columns of numbers, and the grid. Every
// format reads into and writes from this table, so that names and clean-up have one place.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/cloud/cloud.h"

namespace gripscan {

struct PointTable {
    struct Column {
        std::string name;
        std::vector<double> values;  ///< one a row; NaN: not known
    };

    std::size_t rows = 0;
    std::vector<Column> columns;
    /// With a grid the rows are its cells, row by row, and empty cells have NaN coordinates.
    std::size_t grid_width = 0;
    std::size_t grid_height = 0;
    std::optional<Eigen::Vector3d> viewpoint;

    [[nodiscard]] const Column* find(std::string_view name) const;
};

/// The columns gripscan knows, in the order they are written.
[[nodiscard]] std::span<const std::string_view> known_columns();
/// Counts are whole numbers; all other columns are single-precision floats.
[[nodiscard]] bool is_count_column(std::string_view name);
/// Our name of a column ("nx" is normal_x); empty if gripscan has no use for it.
[[nodiscard]] std::string_view known_column(std::string_view name_in_file);

/// Rows whose coordinates are not finite are removed. A column of normals, intensity, sigma or
/// seen-counts is taken only if it makes sense in every row that is left: half-known data would
/// pass for known. Lengths are multiplied by metres_per_unit.
[[nodiscard]] Result<Cloud> cloud_from_table(const PointTable& table, double metres_per_unit);

/// Lengths are divided by metres_per_unit; every value is one a file can hold exactly.
[[nodiscard]] PointTable table_from_cloud(const Cloud& cloud, double metres_per_unit);

}  // namespace gripscan
