// The PCD format of the Point Cloud Library, version 0.7 and its forerunners. Decoding trusts
// nothing in the file: sizes are checked before memory is asked for, and a word that is no number
// is an error (PCL's own reader takes it for zero).
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/cloud/cloud_file.h"
#include "core/cloud/point_table.h"

namespace gripscan {

/// The message says what is wrong and in which line; the caller adds the file.
[[nodiscard]] Result<PointTable> decode_pcd(std::string_view bytes);

/// Without a viewpoint the line VIEWPOINT is left out: PCL's default would claim the origin.
[[nodiscard]] Result<std::string> encode_pcd(const PointTable& table, PcdEncoding encoding);

}  // namespace gripscan
