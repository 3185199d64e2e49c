#include "ui/views/stereo_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/procedure/cell_limits.h"
#include "ui/theme/shown_number.h"

namespace gripscan::ui {
namespace {

constexpr double kRowError_px = 0.30;  ///< beyond it the matcher looks in the wrong row
constexpr double kUnequal = 0.15;      ///< share by which the two means may differ
constexpr double kLostShare = 0.01;    ///< of the pairs that were due
constexpr double kLongAgo_s = 5.0;     ///< what was measured then is no live number any more

std::string percent(double share, int decimals = 0) {
    return shown_number(100.0 * share, decimals);
}

FactState within(bool good) {
    return good ? FactState::kGood : FactState::kWarning;
}
std::string with_reason(std::string meaning, const std::string& why_not_measured) {
    return why_not_measured.empty() ? meaning
                                    : meaning + " Not measured: " + why_not_measured + ".";
}

StereoFact mean_fact(const StereoHealth& left, const std::optional<StereoHealth>& right) {
    StereoFact fact{"Mean level", shown_number(left.mean_intensity, 0), {}, "equal", {}, {}};
    fact.tooltip =
        "Mean brightness in the registration area, 0 to 255. Both cameras should see the same "
        "light: they may differ by 15 %.";
    if (!right) {
        fact.limit = fmt::format("≥ {}", shown_number(CellLimits{}.least_brightness, 0));
        fact.state = within(left.mean_intensity >= CellLimits{}.least_brightness);
        return fact;
    }
    fact.right = shown_number(right->mean_intensity, 0);
    const double larger = std::max(left.mean_intensity, right->mean_intensity);
    fact.state = within(std::abs(left.mean_intensity - right->mean_intensity) <= kUnequal * larger);
    return fact;
}

StereoFact fill_fact(const PairFacts& pair) {
    const double limit = CellLimits{}.least_fill_percent;
    return {"Fill %",
            pair.fill ? percent(*pair.fill) : "–",
            {},
            fmt::format("≥ {}", shown_number(limit, 0)),
            pair.fill ? within(100.0 * *pair.fill >= limit) : FactState::kNone,
            with_reason("Share of the textured pixels in the registration area that have a depth "
                        "there.",
                        pair.why_no_fill)};
}

StereoFact saturated_fact(const StereoHealth& left, const std::optional<StereoHealth>& right) {
    const double limit = CellLimits{}.saturated_percent;
    const double most = std::max(left.saturated, right ? right->saturated : 0.0);
    return {"Saturated %",
            percent(left.saturated, 1),
            right ? percent(right->saturated, 1) : std::string(),
            fmt::format("≤ {}", shown_number(limit, 1)),
            within(100.0 * most <= limit),
            "Share of the pixels in the registration area without a gradation: too bright or "
            "black. Stereo finds nothing there."};
}

StereoFact row_error_fact(const PairFacts& pair) {
    std::string meaning =
        "Median vertical shift between the images. More means that the cameras have moved since "
        "they were calibrated.";
    if (pair.row_error_px && pair.row_error_sd_px > 0.0) {
        meaning +=
            fmt::format(" One standard deviation: {} px.", shown_number(pair.row_error_sd_px, 3));
    }
    return {
        "Row error px",
        pair.row_error_px ? shown_number(*pair.row_error_px, 2) : "–",
        {},
        fmt::format("≤ {}", shown_number(kRowError_px, 2)),
        pair.row_error_px ? within(std::abs(*pair.row_error_px) <= kRowError_px) : FactState::kNone,
        with_reason(std::move(meaning), pair.why_no_row_error)};
}

void add_rate(const LiveStereo& live, std::vector<StereoFact>& facts) {
    const LostPairs& lost = live.lost;
    const auto all = static_cast<double>(lost.all());
    const auto due = all + static_cast<double>(live.number);
    facts.push_back(
        {"Frames /s",
         shown_number(live.rate_hz, 1),
         {},
         fmt::format("{} lost", lost.all()),
         within(all <= kLostShare * due),
         fmt::format("Pairs that arrive. Lost since the camera was opened: {} of {}. {} were not "
                     "delivered, {} were due while the pair before was still being taken, {} came "
                     "and were followed by the next before they were drawn. More than 1 %: lower "
                     "the frame rate or give the camera a line of its own.",
                     lost.all(), lost.all() + live.number, lost.not_delivered, lost.late,
                     lost.not_shown)});
}

/// Fill and row error as a capture was measured; what is no number was not.
PairFacts facts_of(const StereoHealth& health) {
    PairFacts facts;
    if (std::isfinite(health.fill)) facts.fill = health.fill;
    if (std::isfinite(health.row_error_px)) facts.row_error_px = health.row_error_px;
    return facts;
}

std::shared_ptr<const StereoPicture> picture_of(const Snapshot& snapshot, int index) {
    for (const ShownCapture& capture : snapshot.captures) {
        if (capture.index == index) return capture.picture;
    }
    return nullptr;
}

/// The capture at the end of the selected step, else the last one in use; nothing: there is none.
std::optional<int> selected_capture(const Snapshot& snapshot) {
    if (snapshot.procedure == nullptr) return std::nullopt;
    const auto table = table_of(*snapshot.procedure);
    if (!snapshot.follows_last && snapshot.selected_row < table.size()) {
        return table[snapshot.selected_row].row.to;
    }
    const CaptureRecord* last = snapshot.procedure->data.last_used();
    return last == nullptr ? std::nullopt : std::optional(last->index);
}

double cross(const Eigen::Vector2d& o, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return (a.x() - o.x()) * (b.y() - o.y()) - (a.y() - o.y()) * (b.x() - o.x());
}

std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points) {
    std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
        return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
    });
    std::vector<Eigen::Vector2d> hull;
    for (int way = 0; way < 2; ++way) {
        const std::size_t base = hull.size();
        for (const auto& p : points) {
            while (hull.size() >= base + 2 && cross(hull[hull.size() - 2], hull.back(), p) <= 0.0) {
                hull.pop_back();
            }
            hull.push_back(p);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

bool inside(const cv::Mat& image, int x, int y) {
    return x >= 0 && y >= 0 && x < image.cols && y < image.rows;
}

}  // namespace

ShownPicture shown_picture(const Snapshot& snapshot, bool with_disparity) {
    ShownPicture shown;
    const LiveStereo& live = snapshot.live;
    if (live.on && live.trouble.empty() && live.picture && snapshot.follows_last) {
        const bool has_disparity = live.matched && !live.matched->disparity.empty();
        if (!with_disparity || !has_disparity) {
            return {live.picture, true, "live", {}, has_disparity};
        }
        const bool now = live.picture->t_s - live.matched->t_s <= kLongAgo_s;
        return {live.matched, true, now ? "live" : "live, matched earlier", {}, true};
    }
    if (!live.trouble.empty()) {
        shown.why_not_live = live.trouble;
    } else if (!live.why_off.empty()) {
        shown.why_not_live = live.why_off;
    } else if (!snapshot.follows_last) {
        shown.why_not_live = "a step of Table 1 is selected";
    } else {
        shown.why_not_live = live.on ? "waiting for the first images" : "live images are off";
    }
    if (const auto capture = selected_capture(snapshot)) {
        shown.picture = picture_of(snapshot, *capture);
        if (shown.picture) shown.title = fmt::format("capture {}", *capture);
    }
    if (!shown.picture && live.picture) {
        shown.picture = live.picture;
        shown.title = "last live";
    }
    shown.has_disparity = shown.picture && !shown.picture->disparity.empty();
    return shown;
}

PairFacts pair_facts(const Snapshot& snapshot, const ShownPicture& shown) {
    if (!shown.picture) return {};
    const LiveStereo& live = snapshot.live;
    const bool of_live = shown.picture == live.picture || shown.picture == live.matched;
    if (!of_live) {
        return shown.picture->left_health ? facts_of(*shown.picture->left_health) : PairFacts{};
    }
    if (live.matched && live.picture && live.picture->t_s - live.matched->t_s <= kLongAgo_s) {
        return live.matched_facts;
    }
    const std::string why =
        live.why_not_matched.empty() ? "no live pair was matched yet" : live.why_not_matched;
    return {std::nullopt, why, std::nullopt, 0.0, why};
}

std::vector<StereoFact> stereo_facts(const Snapshot& snapshot, const ShownPicture& shown) {
    std::vector<StereoFact> facts;
    if (shown.picture && shown.picture->left_health) {
        const StereoHealth& left = *shown.picture->left_health;
        const auto& right = shown.picture->right_health;
        const PairFacts pair = pair_facts(snapshot, shown);
        facts.push_back(mean_fact(left, right));
        facts.push_back(fill_fact(pair));
        facts.push_back(saturated_fact(left, right));
        facts.push_back(row_error_fact(pair));
    }
    if (shown.live) add_rate(snapshot.live, facts);
    if (snapshot.cell.rig) {
        facts.push_back({"Baseline mm",
                         shown_number(kMmPerM * snapshot.cell.rig->baseline_m, 2),
                         {},
                         fmt::format("{} px", shown_number(snapshot.cell.rig->f_px, 0)),
                         FactState::kNone,
                         "Distance of the two cameras, and their focal length in pixels. Angles do "
                         "not depend on the baseline, sizes do."});
    }
    return facts;
}

std::vector<Eigen::Vector2d> area_outline_px(const CellFrame& cell, Eye eye) {
    if (!cell.rig || !cell.region || cell.region->min_m.z() <= 0.0) return {};
    const double baseline_m = eye == Eye::kRight ? cell.rig->baseline_m : 0.0;
    const double cx = eye == Eye::kRight ? cell.rig->cx_right_px : cell.rig->cx_left_px;
    std::vector<Eigen::Vector2d> corners;
    for (const Eigen::Vector3d& p : cell.region->corners()) {
        const double scale = cell.rig->f_px / p.z();
        corners.emplace_back(scale * (p.x() - baseline_m) + cx, scale * p.y() + cell.rig->cy_px);
    }
    return convex_hull(std::move(corners));
}

DisparityRange disparity_range(const StereoPicture& picture, const CellFrame& cell) {
    DisparityRange range;
    if (cell.rig && cell.region && cell.region->min_m.z() > 0.0) {
        range.far_px = cell.rig->disparity_px(cell.region->max_m.z());
        range.near_px = cell.rig->disparity_px(cell.region->min_m.z());
    } else {
        std::vector<float> known;
        for (int y = 0; y < picture.disparity.rows; y += 4) {
            const auto* row = picture.disparity.ptr<float>(y);
            for (int x = 0; x < picture.disparity.cols; x += 4) {
                if (std::isfinite(row[x])) known.push_back(row[x]);
            }
        }
        if (known.empty()) return range;
        std::sort(known.begin(), known.end());
        range.far_px = known[known.size() / 50];
        range.near_px =
            std::max(range.far_px + 1.0, static_cast<double>(known[known.size() * 49 / 50]));
    }
    const auto text = [&](double disparity_px) {
        return cell.rig ? shown_number(kMmPerM * cell.rig->depth_m(disparity_px), 0) + " mm"
                        : shown_number(disparity_px, 1) + " px";
    };
    range.far_mm = text(range.far_px);
    range.near_mm = text(range.near_px);
    return range;
}

std::string row_text(int row, const std::optional<double>& row_error_px) {
    if (!row_error_px) return fmt::format("row {}", row);
    return fmt::format("row {}  Δy {} px", row, shown_number(*row_error_px, 2));
}

std::string level_text(const cv::Mat& grey, int x, int y) {
    if (!inside(grey, x, y)) return {};
    return fmt::format("{}, {}: {}", x, y, grey.at<std::uint8_t>(y, x));
}

std::string disparity_text(const StereoPicture& picture, const CellFrame& cell, int x, int y) {
    if (!inside(picture.disparity, x, y)) return {};
    const double d = picture.disparity.at<float>(y, x);
    if (!std::isfinite(d)) return fmt::format("{}, {}: none", x, y);
    std::string text = fmt::format("{}, {}: {} px", x, y, shown_number(d, 2));
    if (cell.rig) text += ", " + shown_number(kMmPerM * cell.rig->depth_m(d), 1) + " mm";
    return text;
}

}  // namespace gripscan::ui
