#include "core/cloud/ply_header.h"

#include <array>

#include "core/cloud/text_scan.h"

namespace gripscan {
namespace {

constexpr std::size_t kMaxHeaderLines = 2000;
constexpr std::size_t kMaxProperties = 256;
constexpr std::size_t kMaxElements = 64;

using Words = std::vector<std::string_view>;

std::optional<NumberType> type_from_word(std::string_view word) {
    using enum NumberType;
    static constexpr std::array<std::pair<std::string_view, NumberType>, 16> kTypes{
        {{"char", kInt8},
         {"int8", kInt8},
         {"uchar", kUint8},
         {"uint8", kUint8},
         {"short", kInt16},
         {"int16", kInt16},
         {"ushort", kUint16},
         {"uint16", kUint16},
         {"int", kInt32},
         {"int32", kInt32},
         {"uint", kUint32},
         {"uint32", kUint32},
         {"float", kFloat32},
         {"float32", kFloat32},
         {"double", kFloat64},
         {"float64", kFloat64}}};
    for (const auto& [name, type] : kTypes) {
        if (name == word) return type;
    }
    return std::nullopt;
}

Status read_format(const Words& words, PlyHeader& header) {
    const std::string_view name = words.size() == 3 ? words[1] : "";
    if (name == "ascii") {
        header.text = true;
    } else if (name == "binary_little_endian" || name == "binary_big_endian") {
        header.byte_order = name == "binary_big_endian" ? ByteOrder::kBig : ByteOrder::kLittle;
    } else {
        return input_error(
            "format must be ascii, binary_little_endian or binary_big_endian, and a version");
    }
    return {};
}

Status read_element(const Words& words, PlyHeader& header) {
    const auto count = words.size() == 3 ? count_from_word(words[2]) : std::nullopt;
    if (!count) return input_error("element needs a name and a count");
    if (header.elements.size() == kMaxElements) return input_error("too many elements");
    header.elements.push_back({std::string(words[1]), *count, {}});
    return {};
}

Status read_property(const Words& words, PlyHeader& header) {
    if (header.elements.empty()) return input_error("property before the first element");
    auto& properties = header.elements.back().properties;
    if (properties.size() == kMaxProperties) return input_error("too many properties");
    const bool list = words.size() == 5 && words[1] == "list";
    if (!list && words.size() != 3) return input_error("property needs a type and a name");
    const auto type = type_from_word(words[words.size() - 2]);
    const auto list_count = list ? type_from_word(words[2]) : std::nullopt;
    if (!type || (list && !list_count)) return input_error("property of a type PLY does not know");
    properties.push_back({std::string(words.back()), *type, list_count});
    return {};
}

Status read_obj_info(const Words& words, PlyHeader& header) {
    if (words.size() != 3) return {};
    std::size_t* target = words[1] == "num_cols"   ? &header.num_cols
                          : words[1] == "num_rows" ? &header.num_rows
                                                   : nullptr;
    if (target == nullptr) return {};
    const auto count = count_from_word(words[2]);
    if (!count) return input_error("{} {} is no count", words[1], words[2]);
    *target = *count;
    return {};
}

Status read_line(const Words& words, PlyHeader& header) {
    if (words[0] == "format") return read_format(words, header);
    if (words[0] == "element") return read_element(words, header);
    if (words[0] == "property") return read_property(words, header);
    if (words[0] == "obj_info") return read_obj_info(words, header);
    if (words[0] == "comment") return {};
    return input_error("'{}' is no keyword of PLY", words[0].substr(0, 40));
}

/// The fewest bytes one entry of the element can take.
std::size_t least_size(const PlyElement& element, bool text) {
    std::size_t size = 0;
    for (const PlyProperty& property : element.properties) {
        size += text ? 2 : size_of(property.list_count.value_or(property.type));
    }
    return size;
}

Status check_length(const PlyHeader& header, std::size_t present) {
    // The last line of a text may lack its end.
    if (header.text) ++present;
    for (const PlyElement& element : header.elements) {
        const std::size_t least = least_size(element, header.text);
        if (least == 0 && element.count > 0) {
            return input_error("element {} has no properties", element.name);
        }
        if (least > 0 && element.count > present / least) {
            return input_error(
                "the file is cut off: {} entries of element {} are promised, room "
                "is for {} at most",
                element.count, element.name, present / least);
        }
        present -= element.count * least;
    }
    return {};
}

}  // namespace

Result<PlyHeader> parse_ply_header(std::string_view bytes) {
    LineScanner lines(bytes);
    const auto magic = lines.next();
    if (!magic || *magic != "ply") return input_error("this is no PLY file: no 'ply' at its head");
    PlyHeader header;
    bool format_seen = false;
    Words words;
    while (lines.line_number() < kMaxHeaderLines) {
        const auto line = lines.next();
        if (!line) break;
        split_words(*line, kBlanks, words);
        if (words.empty()) continue;
        if (words[0] == "end_header") {
            if (!format_seen) return input_error("the head has no line format");
            header.body_offset = lines.offset();
            header.body_line = lines.line_number() + 1;
            if (const Status s = check_length(header, bytes.size() - header.body_offset); !s) {
                return forward_error(s.error());
            }
            return header;
        }
        format_seen = format_seen || words[0] == "format";
        if (const Status status = read_line(words, header); !status) {
            return input_error("line {}: {}", lines.line_number(), status.error().message);
        }
    }
    return input_error("the head of the PLY file has no line end_header");
}

}  // namespace gripscan
