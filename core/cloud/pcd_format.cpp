#include "core/cloud/pcd_format.h"

#include <pcl/io/lzf.h>

#include <cmath>
#include <limits>

#include "core/base/number_text.h"
#include "core/cloud/number_writer.h"
#include "core/cloud/pcd_header.h"
#include "core/cloud/text_scan.h"

namespace gripscan {
namespace {

/// A column of the file that gripscan takes.
struct Taken {
    std::size_t number = 0;  ///< position among the numbers of a point
    std::size_t offset = 0;  ///< position among the bytes of a point
    std::size_t size = 0;    ///< bytes
    NumberType type = NumberType::kFloat32;
    std::vector<double>* values = nullptr;
};

/// Makes the table's columns and tells where in the file they are.
std::vector<Taken> take_columns(const PcdHeader& header, PointTable& table) {
    std::vector<Taken> taken;
    table.columns.reserve(known_columns().size());
    std::size_t number = 0;
    std::size_t offset = 0;
    for (const PcdField& field : header.fields) {
        const std::string_view name = known_column(field.name);
        const std::size_t size = size_of(field.type);
        if (!name.empty() && field.count == 1 && table.find(name) == nullptr) {
            table.columns.push_back({std::string(name), std::vector<double>(table.rows)});
            taken.push_back({number, offset, size, field.type, &table.columns.back().values});
        }
        number += field.count;
        offset += field.count * size;
    }
    return taken;
}

Status decode_ascii(const PcdHeader& header, std::string_view body, PointTable& table) {
    const auto taken = take_columns(header, table);
    const std::size_t numbers = header.numbers_per_point();
    LineScanner lines(body);
    std::vector<std::string_view> words;
    std::vector<double> point(numbers);
    for (std::size_t row = 0; row < table.rows; ++row) {
        const auto line = lines.next_with_content();
        const std::size_t line_number = header.body_line + lines.line_number() - 1;
        if (!line) {
            return input_error("the file is cut off: {} of {} points are there", row, table.rows);
        }
        split_words(*line, kBlanks, words);
        if (words.size() != numbers) {
            return input_error("line {}: {} numbers instead of {}", line_number, words.size(),
                               numbers);
        }
        for (std::size_t i = 0; i < numbers; ++i) {
            const auto value = value_from_word(words[i]);
            if (!value) return input_error("line {}: '{}' is no number", line_number, words[i]);
            point[i] = *value;
        }
        for (const Taken& t : taken) (*t.values)[row] = point[t.number];
    }
    if (lines.next_with_content()) {
        return input_error("line {}: more points than the {} of the head",
                           header.body_line + lines.line_number() - 1, table.rows);
    }
    return {};
}

void decode_binary(const PcdHeader& header, std::string_view body, PointTable& table) {
    const std::size_t step = header.bytes_per_point();
    for (const Taken& t : take_columns(header, table)) {
        for (std::size_t row = 0; row < table.rows; ++row) {
            (*t.values)[row] = number_at(body.data() + row * step + t.offset, t.type);
        }
    }
}

/// Compressed files hold field after field instead of point after point.
Status decode_compressed(const PcdHeader& header, std::string_view body, PointTable& table) {
    const std::size_t packed_size = number_at<std::uint32_t>(body.data(), ByteOrder::kLittle);
    const std::size_t size = number_at<std::uint32_t>(body.data() + 4, ByteOrder::kLittle);
    body.remove_prefix(8);
    if (size != header.points() * header.bytes_per_point()) {
        return input_error("{} bytes of points do not fit the head, which asks for {}", size,
                           header.points() * header.bytes_per_point());
    }
    if (packed_size > body.size()) {
        return input_error("the file is cut off: {} of {} compressed bytes are there", body.size(),
                           packed_size);
    }
    std::string unpacked(size, '\0');
    if (size > 0 && pcl::lzfDecompress(body.data(), static_cast<unsigned>(packed_size),
                                       unpacked.data(), static_cast<unsigned>(size)) != size) {
        return input_error("the compressed points are damaged");
    }
    for (const Taken& t : take_columns(header, table)) {
        const char* begin = unpacked.data() + t.offset * table.rows;
        for (std::size_t row = 0; row < table.rows; ++row) {
            (*t.values)[row] = number_at(begin + row * t.size, t.type);
        }
    }
    return {};
}

std::string header_text(const PointTable& table, PcdEncoding encoding) {
    std::string names;
    std::string sizes;
    std::string types;
    std::string counts;
    for (const auto& column : table.columns) {
        const bool count = is_count_column(column.name);
        names += ' ' + column.name;
        sizes += count ? " 2" : " 4";
        types += count ? " U" : " F";
        counts += " 1";
    }
    const bool grid = table.grid_width > 0;
    const std::string viewpoint =
        !table.viewpoint
            ? std::string()
            : fmt::format("VIEWPOINT {} {} {} 1 0 0 0\n", text_from_number(table.viewpoint->x()),
                          text_from_number(table.viewpoint->y()),
                          text_from_number(table.viewpoint->z()));
    const std::string_view data = encoding == PcdEncoding::kAscii    ? "ascii"
                                  : encoding == PcdEncoding::kBinary ? "binary"
                                                                     : "binary_compressed";
    return fmt::format(
        "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS{}\nSIZE{}\nTYPE{}\n"
        "COUNT{}\nWIDTH {}\nHEIGHT {}\n{}POINTS {}\nDATA {}\n",
        names, sizes, types, counts, grid ? table.grid_width : table.rows,
        grid ? table.grid_height : 1, viewpoint, table.rows, data);
}

Result<std::string> compressed_body(const PointTable& table) {
    std::string plain;
    for (const auto& column : table.columns) {
        for (const double value : column.values) append_binary(plain, column.name, value);
    }
    if (plain.size() > std::numeric_limits<std::uint32_t>::max() / 2) {
        return input_error("{} bytes are too many for a compressed PCD; use binary", plain.size());
    }
    // LZF falls behind by one byte in 32 on data that do not compress.
    std::string packed(plain.size() + plain.size() / 16 + 64, '\0');
    const std::uint32_t plain_size = static_cast<std::uint32_t>(plain.size());
    const std::uint32_t packed_size =
        plain.empty() ? 0
                      : pcl::lzfCompress(plain.data(), plain_size, packed.data(),
                                         static_cast<std::uint32_t>(packed.size()));
    if (packed_size == 0 && !plain.empty()) {
        return input_error("the points cannot be compressed; use binary");
    }
    packed.resize(packed_size);
    std::string body;
    append_little_endian(body, packed_size);
    append_little_endian(body, plain_size);
    return body + packed;
}

}  // namespace

Result<PointTable> decode_pcd(std::string_view bytes) {
    const auto header = parse_pcd_header(bytes);
    if (!header) return forward_error(header.error());
    PointTable table;
    table.rows = header->points();
    if (header->height > 1) {
        table.grid_width = header->width;
        table.grid_height = header->height;
    }
    table.viewpoint = header->viewpoint;
    const std::string_view body = bytes.substr(header->body_offset);
    Status status;
    switch (header->encoding) {
        case PcdEncoding::kAscii:
            status = decode_ascii(*header, body, table);
            break;
        case PcdEncoding::kBinary:
            decode_binary(*header, body, table);
            break;
        case PcdEncoding::kCompressed:
            status = decode_compressed(*header, body, table);
            break;
    }
    if (!status) return forward_error(status.error());
    return table;
}

Result<std::string> encode_pcd(const PointTable& table, PcdEncoding encoding) {
    std::string bytes = header_text(table, encoding);
    if (encoding == PcdEncoding::kCompressed) {
        auto body = compressed_body(table);
        if (!body) return body;
        return bytes + *body;
    }
    for (std::size_t row = 0; row < table.rows; ++row) {
        if (encoding == PcdEncoding::kAscii) {
            append_text_row(bytes, table, row);
        } else {
            for (const auto& column : table.columns) {
                append_binary(bytes, column.name, column.values[row]);
            }
        }
    }
    return bytes;
}

}  // namespace gripscan
