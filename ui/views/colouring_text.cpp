#include "ui/views/colouring_text.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace gripscan::ui {
namespace {

/// What colours a point, in the unit of the colouring; nothing: the cloud does not say.
std::optional<double> value_of(const Colouring& colouring, const SceneCloud& cloud, std::size_t i) {
    const Cloud& points = *cloud.cloud;
    switch (colouring.by) {
        case ColourBy::kResidual:
            if (!cloud.residual_m || i >= cloud.residual_m->size()) return std::nullopt;
            if ((*cloud.residual_m)[i] < 0.0F) return std::nullopt;
            return (*cloud.residual_m)[i] / colouring.per_unit;
        case ColourBy::kSigma:
            if (points.sigma.empty()) return std::nullopt;
            return points.sigma[i] / colouring.per_unit;
        case ColourBy::kSeen:
            if (points.seen.empty()) return std::nullopt;
            return points.seen[i];
        case ColourBy::kDepth:
            return (cloud.T_first_cloud * points.points[i].cast<double>()).z() / colouring.per_unit;
        default:
            return std::nullopt;
    }
}

/// Values of an even sample of every visible cloud, rising.
std::vector<double> sampled_values(const Colouring& colouring, const SceneParts& parts) {
    constexpr std::size_t kOfACloud = 1500;
    std::vector<double> values;
    for (const SceneCloud& cloud : parts.clouds) {
        if (!cloud.visible) continue;
        const std::size_t stride = std::max<std::size_t>(1, cloud.cloud->size() / kOfACloud);
        for (std::size_t i = 0; i < cloud.cloud->size(); i += stride) {
            if (const auto value = value_of(colouring, cloud, i)) values.push_back(*value);
        }
    }
    std::sort(values.begin(), values.end());
    return values;
}

double quantile(const std::vector<double>& values, double q) {
    return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1))];
}

/// 1, 2 or 5 times a power of ten, not less than the value.
double round_up(double value) {
    if (!(value > 0.0)) return 1.0;
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (value <= step * power * 1.0001) return step * power;
    }
    return 10.0 * power;
}

template <typename Has>
bool any_visible(const SceneParts& parts, Has has) {
    return std::any_of(parts.clouds.begin(), parts.clouds.end(),
                       [&](const SceneCloud& cloud) { return cloud.visible && has(cloud); });
}

std::size_t visible_clouds(const SceneParts& parts) {
    return static_cast<std::size_t>(
        std::ranges::count_if(parts.clouds, [](const SceneCloud& cloud) { return cloud.visible; }));
}

}  // namespace

const std::vector<Colouring>& colourings() {
    using enum ColourBy;
    static const std::vector<Colouring> kAll{
        {kStep, "colour.step", "Step", "the step that saw the point", ColourMap::kStep, "", 0},
        {kImage, "colour.image", "Image", "brightness in the left image", std::nullopt, "", 0},
        {kResidual, "colour.residual", "Residual", "distance to the other views",
         ColourMap::kResidual, "mm", 2, 0.001, true},
        {kSeen, "colour.seen", "Seen count", "views that saw the point", ColourMap::kSeen, "", 0,
         1.0, true},
        {kDepth, "colour.depth", "Depth", "along the left camera's z", ColourMap::kDepth, "mm", 0,
         0.001, true},
        {kNormal, "colour.normal", "Normal", "direction of the surface as colour", std::nullopt, "",
         0},
        {kSigma, "colour.sigma", "Standard deviation", "of the point along its ray",
         ColourMap::kResidual, "mm", 2, 0.001, true},
    };
    return kAll;
}

const Colouring& colouring(ColourBy by) {
    for (const Colouring& candidate : colourings()) {
        if (candidate.by == by) return candidate;
    }
    throw std::out_of_range("colouring: this one has no legend");
}

std::string why_no_colouring(ColourBy by, const SceneParts& parts) {
    if (parts.kind == SceneKind::kEmpty) return "there is no cloud yet";
    switch (by) {
        case ColourBy::kResidual:
            if (parts.kind == SceneKind::kTemplate) return "in the template the views are merged";
            if (parts.kind == SceneKind::kFound) return "this is a single view";
            return visible_clouds(parts) > 1 ? "" : "there is no other view to compare with yet";
        case ColourBy::kSeen:
            return any_visible(parts, [](const auto& c) { return !c.cloud->seen.empty(); })
                       ? ""
                       : "known of the merged template: see the Template page";
        case ColourBy::kSigma:
            return any_visible(parts, [](const auto& c) { return !c.cloud->sigma.empty(); })
                       ? ""
                       : "these clouds do not say how sure their points are";
        case ColourBy::kNormal:
            return any_visible(parts, [](const auto& c) { return c.cloud->has_normals(); })
                       ? ""
                       : "these clouds have no normals";
        case ColourBy::kImage:
            return any_visible(parts, [](const auto& c) { return !c.cloud->intensity.empty(); })
                       ? ""
                       : "these clouds came without an image";
        case ColourBy::kStep:
            if (parts.kind == SceneKind::kFound) return "this is a single view";
            return parts.kind == SceneKind::kTemplate ? "in the template the steps are merged" : "";
        case ColourBy::kDepth:
        case ColourBy::kChunk:
            break;
    }
    return {};
}

ColourBy usual_colouring(const SceneParts& parts) {
    switch (parts.kind) {
        case SceneKind::kPair:
        case SceneKind::kFound:
            return ColourBy::kChunk;
        case SceneKind::kTemplate:
            return why_no_colouring(ColourBy::kSeen, parts).empty() ? ColourBy::kSeen
                                                                    : ColourBy::kDepth;
        default:
            return ColourBy::kStep;
    }
}

LegendRange usual_range(ColourBy by, const SceneParts& parts, int min_seen) {
    if (by == ColourBy::kStep) return {1.0, std::max(2.0, static_cast<double>(parts.steps_total))};
    if (by == ColourBy::kChunk) return {};
    const auto values = sampled_values(colouring(by), parts);
    if (values.empty()) return {};
    switch (by) {
        case ColourBy::kResidual:
        case ColourBy::kSigma:
            return {0.0, round_up(2.0 * quantile(values, 0.5))};
        case ColourBy::kSeen:
            return {static_cast<double>(min_seen),
                    std::max(static_cast<double>(min_seen + 1), values.back())};
        default: {  // depth: near is the high end
            const double near = std::floor(quantile(values, 0.01));
            return {std::max(near + 1.0, std::ceil(quantile(values, 0.99))), near};
        }
    }
}

}  // namespace gripscan::ui
