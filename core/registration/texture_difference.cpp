#include "core/registration/texture_difference.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/registration/texture_rows.h"

namespace gripscan {
namespace {

/// Texture is compared where the surfaces meet this closely, in radii of the part.
constexpr double kGateShare = 0.03;

}  // namespace

std::optional<double> texture_difference(const Surface& source, const Surface& target,
                                         const Alignment& at, int scale) {
    const double gate_m = kGateShare * std::max(source.radius_m, target.radius_m);
    const auto rows = texture_rows(source, target, at.T_target_source, scale, gate_m, at.centre_m);
    if (rows.empty()) return std::nullopt;
    std::vector<double> sizes;
    for (const ResidualRow& row : rows) sizes.push_back(std::abs(row.residual));
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    return *middle;
}

}  // namespace gripscan
