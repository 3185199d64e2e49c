// Which points of a template are kept.
#pragma once

#include <optional>

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

}  // namespace gripscan
