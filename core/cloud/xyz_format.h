// Points as plain text, one a line: x y z and perhaps more, with blanks, commas or semicolons
// between the numbers. What further columns mean is only known if a comment line names them all,
// as gripscan's own files do ("# x y z normal_x …"); else they must be numbers and are dropped.
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/cloud/point_table.h"

namespace gripscan {

/// The message names the line; the caller adds the file.
[[nodiscard]] Result<PointTable> decode_xyz(std::string_view bytes);

/// Only the points: a grid and a viewpoint have no place here.
[[nodiscard]] std::string encode_xyz(const PointTable& table);

}  // namespace gripscan
