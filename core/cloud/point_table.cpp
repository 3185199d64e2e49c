#include "core/cloud/point_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace gripscan {
namespace {

constexpr std::array<std::string_view, 9> kColumns{
    "x", "y", "z", "normal_x", "normal_y", "normal_z", "intensity", "sigma", "seen"};
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kAliases{
    {{"nx", "normal_x"}, {"ny", "normal_y"}, {"nz", "normal_z"}}};

constexpr std::size_t kMaxCells = std::numeric_limits<std::int32_t>::max();

using Columns3 = std::array<const PointTable::Column*, 3>;

std::optional<Columns3> find_three(const PointTable& table, std::string_view x, std::string_view y,
                                   std::string_view z) {
    const Columns3 columns{table.find(x), table.find(y), table.find(z)};
    if (columns[0] == nullptr || columns[1] == nullptr || columns[2] == nullptr) return {};
    return columns;
}

Eigen::Vector3d row_of(const Columns3& columns, std::size_t row) {
    return {columns[0]->values[row], columns[1]->values[row], columns[2]->values[row]};
}

std::vector<Eigen::Vector3f> read_normals(const PointTable& table,
                                          const std::vector<std::size_t>& rows) {
    std::vector<Eigen::Vector3f> normals;
    const auto columns = find_three(table, "normal_x", "normal_y", "normal_z");
    if (!columns) return normals;
    normals.reserve(rows.size());
    for (const std::size_t row : rows) {
        const Eigen::Vector3d n = row_of(*columns, row);
        const double length = n.norm();
        if (!(length > 1e-6) || !std::isfinite(length)) return {};
        // A unit vector in floats stays as it is, so that files read back exactly.
        const Eigen::Vector3d unit =
            std::abs(length - 1.0) < 1e-6 ? n : Eigen::Vector3d(n / length);
        normals.push_back(unit.cast<float>());
    }
    return normals;
}

template <typename T, typename Usable>
std::vector<T> read_column(const PointTable& table, std::string_view name,
                           const std::vector<std::size_t>& rows, double scale, Usable usable) {
    std::vector<T> values;
    const PointTable::Column* column = table.find(name);
    if (column == nullptr) return values;
    values.reserve(rows.size());
    for (const std::size_t row : rows) {
        const double value = column->values[row] * scale;
        if (!usable(value)) return {};
        values.push_back(static_cast<T>(value));
    }
    return values;
}

bool fits_float(double value) {
    return std::abs(value) <= std::numeric_limits<float>::max();
}

/// Points and, with a grid, their cells; returns the rows they came from.
std::vector<std::size_t> take_finite_points(const PointTable& table, const Columns3& xyz,
                                            double metres_per_unit, Cloud& cloud) {
    std::vector<std::size_t> rows;
    const bool grid = table.grid_width > 0;
    for (std::size_t row = 0; row < table.rows; ++row) {
        const Eigen::Vector3d p = row_of(xyz, row) * metres_per_unit;
        if (!fits_float(p.x()) || !fits_float(p.y()) || !fits_float(p.z())) continue;
        cloud.points.push_back(p.cast<float>());
        if (grid) cloud.cell.push_back(static_cast<std::int32_t>(row));
        rows.push_back(row);
    }
    return rows;
}

PointTable::Column column_of(std::string_view name, std::size_t rows) {
    // A count has no NaN: an empty cell was seen by no view.
    const double empty =
        is_count_column(name) ? 0.0 : static_cast<double>(std::numeric_limits<float>::quiet_NaN());
    return {std::string(name), std::vector<double>(rows, empty)};
}

/// Appends a column and fills the rows of the points with value(i).
template <typename Value>
void add_column(PointTable& table, std::string_view name, const Cloud& cloud, Value value) {
    PointTable::Column column = column_of(name, table.rows);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        const std::size_t row = table.grid_width > 0 ? static_cast<std::size_t>(cloud.cell[i]) : i;
        column.values[row] = static_cast<double>(static_cast<float>(value(i)));
    }
    table.columns.push_back(std::move(column));
}

}  // namespace

const PointTable::Column* PointTable::find(std::string_view name) const {
    const auto found = std::find_if(columns.begin(), columns.end(),
                                    [&](const Column& column) { return column.name == name; });
    return found == columns.end() ? nullptr : &*found;
}

std::span<const std::string_view> known_columns() {
    return kColumns;
}

bool is_count_column(std::string_view name) {
    return name == "seen";
}

std::string_view known_column(std::string_view name_in_file) {
    for (const auto& [alias, name] : kAliases) {
        if (alias == name_in_file) return name;
    }
    const auto* const found = std::find(kColumns.begin(), kColumns.end(), name_in_file);
    return found == kColumns.end() ? std::string_view{} : *found;
}

Result<Cloud> cloud_from_table(const PointTable& table, double metres_per_unit) {
    const auto xyz = find_three(table, "x", "y", "z");
    if (!xyz) return input_error("the points have no fields x, y and z");
    if (table.grid_width > 0 && table.rows > kMaxCells) {
        return input_error("a grid of {} x {} cells is too large", table.grid_width,
                           table.grid_height);
    }
    Cloud cloud;
    const auto rows = take_finite_points(table, *xyz, metres_per_unit, cloud);
    cloud.normals = read_normals(table, rows);
    cloud.intensity = read_column<float>(table, "intensity", rows, 1.0, fits_float);
    cloud.sigma = read_column<float>(table, "sigma", rows, metres_per_unit,
                                     [](double s) { return s >= 0.0 && fits_float(s); });
    cloud.seen = read_column<std::uint16_t>(table, "seen", rows, 1.0, [](double n) {
        return n >= 0.0 && n <= std::numeric_limits<std::uint16_t>::max() && n == std::floor(n);
    });
    cloud.grid_width = static_cast<int>(table.grid_width);
    cloud.grid_height = static_cast<int>(table.grid_height);
    if (table.viewpoint) {
        cloud.viewpoint = (*table.viewpoint * metres_per_unit).cast<float>();
    }
    return cloud;
}

PointTable table_from_cloud(const Cloud& cloud, double metres_per_unit) {
    PointTable table;
    table.rows = cloud.size();
    // A grid of one row is a list to every reader.
    const bool grid = cloud.organised() && cloud.grid_height > 1;
    if (grid) {
        table.grid_width = static_cast<std::size_t>(cloud.grid_width);
        table.grid_height = static_cast<std::size_t>(cloud.grid_height);
        table.rows = table.grid_width * table.grid_height;
    }
    for (int axis = 0; axis < 3; ++axis) {
        add_column(table, kColumns[static_cast<std::size_t>(axis)], cloud, [&](std::size_t i) {
            return static_cast<double>(cloud.points[i][axis]) / metres_per_unit;
        });
    }
    for (int axis = 0; axis < 3 && cloud.has_normals(); ++axis) {
        add_column(table, kColumns[static_cast<std::size_t>(3 + axis)], cloud,
                   [&](std::size_t i) { return cloud.normals[i][axis]; });
    }
    if (!cloud.intensity.empty()) {
        add_column(table, "intensity", cloud, [&](std::size_t i) { return cloud.intensity[i]; });
    }
    if (!cloud.sigma.empty()) {
        add_column(table, "sigma", cloud, [&](std::size_t i) {
            return static_cast<double>(cloud.sigma[i]) / metres_per_unit;
        });
    }
    if (!cloud.seen.empty()) {
        add_column(table, "seen", cloud, [&](std::size_t i) { return cloud.seen[i]; });
    }
    if (cloud.viewpoint) {
        table.viewpoint =
            (cloud.viewpoint->cast<double>() / metres_per_unit).cast<float>().cast<double>();
    }
    return table;
}

}  // namespace gripscan
