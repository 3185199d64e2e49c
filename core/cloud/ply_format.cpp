#include "core/cloud/ply_format.h"

#include <cmath>
#include <limits>

#include "core/cloud/number_writer.h"
#include "core/cloud/ply_header.h"
#include "core/cloud/ply_rows.h"

namespace gripscan {
namespace {

constexpr double kNoVertex = -1.0;

// For properties gripscan has no use for: they are read, since they must be numbers, and dropped.
constexpr auto kDropNumber = [](std::size_t, std::size_t, double) { return Status{}; };
constexpr auto kDropList = [](std::size_t, const std::vector<double>&) { return Status{}; };

/// Takes what gripscan knows out of the rows of one file.
template <typename Rows>
class Decoder {
  public:
    Decoder(const PlyHeader& header, Rows rows) : header_(header), rows_(std::move(rows)) {}

    Status read() {
        for (const PlyElement& element : header_.elements) {
            Status status;
            if (element.name == "vertex") {
                status = read_vertices(element);
            } else if (element.name == "face" || element.name == "range_grid") {
                status = read_lists(element);
            } else {
                status = for_each_row(element, kDropNumber, kDropList);
            }
            if (!status) return status;
        }
        return rows_.end_of_body();
    }

    PointTable vertices;
    std::vector<Triangle> triangles;
    std::vector<double> vertex_of_cell;

  private:
    Status read_vertices(const PlyElement& element) {
        if (!vertices.columns.empty()) return input_error("element vertex appears twice");
        vertices.rows = element.count;
        std::vector<std::vector<double>*> targets;
        vertices.columns.reserve(element.properties.size());
        for (const PlyProperty& property : element.properties) {
            const std::string_view name = known_column(property.name);
            targets.push_back(nullptr);
            if (name.empty() || property.list_count || vertices.find(name) != nullptr) continue;
            vertices.columns.push_back({std::string(name), std::vector<double>(element.count)});
            targets.back() = &vertices.columns.back().values;
        }
        const auto store = [&](std::size_t row, std::size_t property, double value) {
            if (targets[property] != nullptr) (*targets[property])[row] = value;
            return Status{};
        };
        return for_each_row(element, store, kDropList);
    }

    Status read_lists(const PlyElement& element) {
        const bool faces = element.name == "face";
        const auto store = [&](std::size_t property, const std::vector<double>& list) {
            const std::string& name = element.properties[property].name;
            if (name != "vertex_indices" && name != "vertex_index") return Status{};
            return faces ? add_face(list) : add_cell(list);
        };
        return for_each_row(element, kDropNumber, store);
    }

    template <typename OnNumber, typename OnList>
    Status for_each_row(const PlyElement& element, OnNumber on_number, OnList on_list) {
        for (std::size_t row = 0; row < element.count; ++row) {
            if (Status s = rows_.begin_row(); !s) return s;
            for (std::size_t i = 0; i < element.properties.size(); ++i) {
                const PlyProperty& property = element.properties[i];
                if (property.list_count) {
                    if (Status s = read_list(property); !s) return s;
                    if (Status s = on_list(i, list_); !s) return s;
                } else {
                    const auto value = rows_.number(property.type);
                    if (!value) return forward_error(value.error());
                    if (Status s = on_number(row, i, *value); !s) return s;
                }
            }
            if (Status s = rows_.end_row(); !s) return s;
        }
        return {};
    }

    Status read_list(const PlyProperty& property) {
        const auto length = rows_.number(*property.list_count);
        if (!length) return forward_error(length.error());
        if (!(*length >= 0.0) || *length != std::floor(*length)) {
            return input_error("a list of {} entries", *length);
        }
        // A length beyond the file ends at the end of the file, before the memory does.
        list_.clear();
        for (double i = 0.0; i < *length; i += 1.0) {
            const auto value = rows_.number(property.type);
            if (!value) return forward_error(value.error());
            list_.push_back(*value);
        }
        return {};
    }

    [[nodiscard]] bool is_vertex(double index) const {
        return index >= 0.0 && index < static_cast<double>(vertices.rows) &&
               index < static_cast<double>(std::numeric_limits<std::uint32_t>::max()) &&
               index == std::floor(index);
    }

    /// Polygons become fans of triangles.
    Status add_face(const std::vector<double>& corners) {
        for (const double index : corners) {
            if (!is_vertex(index)) {
                return input_error("a face names vertex {} of {}", index, vertices.rows);
            }
        }
        for (std::size_t i = 2; i < corners.size(); ++i) {
            triangles.push_back({static_cast<std::uint32_t>(corners[0]),
                                 static_cast<std::uint32_t>(corners[i - 1]),
                                 static_cast<std::uint32_t>(corners[i])});
        }
        return {};
    }

    Status add_cell(const std::vector<double>& vertex) {
        if (vertex.size() > 1 || (vertex.size() == 1 && !is_vertex(vertex[0]))) {
            return input_error("a cell of the range grid names no vertex of the {}", vertices.rows);
        }
        vertex_of_cell.push_back(vertex.empty() ? kNoVertex : vertex[0]);
        return {};
    }

    const PlyHeader& header_;
    Rows rows_;
    std::vector<double> list_;
};

/// The vertices laid out on their grid.
Result<PointTable> on_grid(const PointTable& vertices, const std::vector<double>& vertex_of_cell,
                           const PlyHeader& header) {
    const std::size_t cells = vertex_of_cell.size();
    if (header.num_cols == 0 || header.num_rows == 0 || cells % header.num_cols != 0 ||
        cells / header.num_cols != header.num_rows) {
        return input_error("the range grid has {} cells; num_cols {} and num_rows {} do not fit",
                           cells, header.num_cols, header.num_rows);
    }
    PointTable grid;
    grid.rows = cells;
    grid.grid_width = header.num_cols;
    grid.grid_height = header.num_rows;
    for (const auto& column : vertices.columns) {
        PointTable::Column spread{column.name, std::vector<double>(cells, std::nan(""))};
        if (is_count_column(column.name)) spread.values.assign(cells, 0.0);
        for (std::size_t cell = 0; cell < cells; ++cell) {
            if (vertex_of_cell[cell] == kNoVertex) continue;
            spread.values[cell] = column.values[static_cast<std::size_t>(vertex_of_cell[cell])];
        }
        grid.columns.push_back(std::move(spread));
    }
    return grid;
}

template <typename Rows>
Result<PlyContent> decode(const PlyHeader& header, Rows rows) {
    Decoder<Rows> decoder(header, std::move(rows));
    if (const Status status = decoder.read(); !status) return forward_error(status.error());
    PlyContent content{std::move(decoder.vertices), std::move(decoder.triangles)};
    if (!decoder.vertex_of_cell.empty() && content.triangles.empty()) {
        auto grid = on_grid(content.points, decoder.vertex_of_cell, header);
        if (!grid) return forward_error(grid.error());
        content.points = std::move(*grid);
    }
    return content;
}

bool has_point(const PointTable& table, std::size_t row) {
    return table.grid_width == 0 || std::isfinite(table.columns[0].values[row]);
}

std::string header_text(const PointTable& table, std::size_t points, PlyEncoding encoding) {
    std::string text =
        fmt::format("ply\nformat {} 1.0\ncomment gripscan\n",
                    encoding == PlyEncoding::kAscii ? "ascii" : "binary_little_endian");
    if (table.grid_width > 0) {
        text += fmt::format("obj_info num_cols {}\nobj_info num_rows {}\n", table.grid_width,
                            table.grid_height);
    }
    text += fmt::format("element vertex {}\n", points);
    for (const auto& column : table.columns) {
        std::string_view name = column.name;
        if (name.starts_with("normal_")) name.remove_prefix(7);
        text += fmt::format("property {} {}{}\n", is_count_column(column.name) ? "ushort" : "float",
                            name.size() < column.name.size() ? "n" : "", name);
    }
    if (table.grid_width > 0) {
        text += fmt::format("element range_grid {}\nproperty list uchar int vertex_indices\n",
                            table.rows);
    }
    return text + "end_header\n";
}

void append_range_grid(std::string& bytes, const PointTable& table, PlyEncoding encoding) {
    std::int32_t vertex = 0;
    for (std::size_t row = 0; row < table.rows; ++row) {
        const bool filled = has_point(table, row);
        if (encoding == PlyEncoding::kAscii) {
            bytes += filled ? fmt::format("1 {}\n", vertex) : "0\n";
        } else {
            append_little_endian(bytes, static_cast<std::uint8_t>(filled ? 1 : 0));
            if (filled) append_little_endian(bytes, vertex);
        }
        if (filled) ++vertex;
    }
}

}  // namespace

Result<PlyContent> decode_ply(std::string_view bytes) {
    const auto header = parse_ply_header(bytes);
    if (!header) return forward_error(header.error());
    const std::string_view body = bytes.substr(header->body_offset);
    if (header->text) return decode(*header, PlyTextRows(body, header->body_line));
    return decode(*header, PlyBinaryRows(body, header->byte_order));
}

std::string encode_ply(const PointTable& table, PlyEncoding encoding) {
    std::size_t points = 0;
    for (std::size_t row = 0; row < table.rows; ++row) points += has_point(table, row) ? 1 : 0;
    std::string bytes = header_text(table, points, encoding);
    for (std::size_t row = 0; row < table.rows; ++row) {
        if (!has_point(table, row)) continue;
        if (encoding == PlyEncoding::kAscii) {
            append_text_row(bytes, table, row);
        } else {
            for (const auto& column : table.columns) {
                append_binary(bytes, column.name, column.values[row]);
            }
        }
    }
    if (table.grid_width > 0) append_range_grid(bytes, table, encoding);
    return bytes;
}

}  // namespace gripscan
