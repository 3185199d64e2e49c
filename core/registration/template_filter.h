// Which points of a template are kept, and what the kept ones are like.
#pragma once

#include <optional>
#include <vector>

#include "core/base/for_each.h"
#include "core/cloud/cloud.h"

namespace gripscan {

struct TemplateFilter {
    std::optional<Box> crop;      ///< in the template's frame, m; nothing: all of it
    bool invert_crop = false;     ///< keep what lies outside
    int min_seen = 1;             ///< views that saw a point
    double denoise_sigmas = 0.0;  ///< 0: off
    int denoise_neighbours = 20;

    friend bool operator==(const TemplateFilter&, const TemplateFilter&) = default;
};

/// What the filter did, in the order in which it does it.
struct FilterCounts {
    std::size_t all = 0;
    std::size_t cut_off = 0;   ///< by the crop
    std::size_t too_few = 0;   ///< seen by fewer views than asked, of those that are left
    std::size_t outliers = 0;  ///< of those that are left then
    std::size_t kept = 0;
    /// Entry n: points left by the crop that n views saw. Empty where no point knows its views.
    std::vector<std::size_t> seen_by;

    friend bool operator==(const FilterCounts&, const FilterCounts&) = default;
};

struct FilteredTemplate {
    std::vector<std::size_t> kept;  ///< indices, rising
    FilterCounts counts;
};

/// Crop, then the seen-count (a cloud without one passes), then the statistical filter: a point
/// whose mean distance to its neighbours exceeds the mean over all points by more than so many of
/// their standard deviations is an outlier. A crop without volume holds nothing.
[[nodiscard]] FilteredTemplate filter_template(const Cloud& cloud, const TemplateFilter& filter,
                                               const ForEach& for_each);

/// A template in figures; those of no points are zero.
struct TemplateFacts {
    std::size_t points = 0;
    std::optional<Box> bounds;      ///< of its points
    double spacing_m = 0.0;         ///< median distance to the nearest other point
    std::optional<double> sigma_m;  ///< median standard deviation, where it is known
    bool has_normals = false;
};

[[nodiscard]] TemplateFacts template_facts(const Cloud& cloud, const ForEach& for_each);

}  // namespace gripscan
