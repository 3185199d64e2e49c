// The text at the head of a PLY file: the elements in file order, each with its properties.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/cloud/number_type.h"

namespace gripscan {

struct PlyProperty {
    std::string name;
    NumberType type = NumberType::kFloat32;
    std::optional<NumberType> list_count;  ///< set for lists: the type of their length
};

struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    bool text = false;                          ///< the body is text
    ByteOrder byte_order = ByteOrder::kLittle;  ///< of a binary body
    std::size_t num_cols = 0;                   ///< of obj_info, 0: not given
    std::size_t num_rows = 0;
    std::vector<PlyElement> elements;
    std::size_t body_offset = 0;
    std::size_t body_line = 0;  ///< number of the first line after the head
};

/// Also checks that the file is long enough for what the header promises.
[[nodiscard]] Result<PlyHeader> parse_ply_header(std::string_view bytes);

}  // namespace gripscan
