// Items about what is where it should not be.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/base/units.h"
#include "core/procedure/cell_items.h"

namespace gripscan {
namespace {

constexpr double kMm2PerM2 = 1e6;

double total_mm2(const std::vector<Piece>& pieces) {
    return std::accumulate(pieces.begin(), pieces.end(), 0.0, [](double sum, const Piece& piece) {
        return sum + kMm2PerM2 * piece.area_m2;
    });
}

/// "2 pieces …, the largest of 430 mm² at (12, −40, 700) mm"
std::string listed(const std::vector<Piece>& pieces, std::string_view what) {
    if (pieces.empty()) return fmt::format("nothing {}", what);
    const Piece& largest =
        *std::max_element(pieces.begin(), pieces.end(),
                          [](const Piece& a, const Piece& b) { return a.area_m2 < b.area_m2; });
    const Eigen::Vector3d at_mm = kMmPerM * largest.centre_m;
    return fmt::format("{} {} {}, the largest of {:.0f} mm² at ({:.0f}, {:.0f}, {:.0f}) mm",
                       pieces.size(), pieces.size() == 1 ? "piece" : "pieces", what,
                       kMm2PerM2 * largest.area_m2, at_mm.x(), at_mm.y(), at_mm.z());
}

constexpr std::string_view kClear =
    "take it out of the registration area, or make the region smaller";
constexpr std::string_view kClearOrTurn =
    "take it out of the registration area, or make the region smaller; where it is a part of the "
    "gripper, turn joint 6 until the camera sees it whole";

}  // namespace

CellCheckItem alone_item(const CellFacts& facts, const CellLimits& limits) {
    if (facts.still) {
        return with_sentence(at_most("alone", total_mm2(*facts.still), limits.apart_mm2, "mm²"),
                             listed(*facts.still, "stood still while the gripper turned"), kClear);
    }
    if (!facts.apart) return skipped("alone", "mm²", facts.apart.error());
    if (facts.far_apart && total_mm2(*facts.far_apart) > limits.apart_mm2) {
        return with_sentence(at_most("alone", total_mm2(*facts.far_apart), limits.apart_mm2, "mm²"),
                             listed(*facts.far_apart, "far apart from the gripper"), kClearOrTurn);
    }
    CellCheckItem item = at_most("alone", total_mm2(*facts.apart), limits.apart_mm2, "mm²");
    if (item.outcome == CheckOutcome::kFailed) item.outcome = CheckOutcome::kWarned;
    return with_sentence(std::move(item), listed(*facts.apart, "apart from the gripper"),
                         "look whether that is a part of it; the warm-up will tell");
}

CellCheckItem joint_item(const CellFacts& facts, const CellLimits& limits) {
    constexpr std::string_view kEndSooner =
        "let the region end before the wrist: a joint in it makes the gripper deform";
    if (facts.wrist_distance_m) {
        const double mm = kMmPerM * *facts.wrist_distance_m;
        return with_sentence(at_least("joint", mm, limits.wrist_mm, "mm"),
                             fmt::format("the wrist is {:.0f} mm outside the region", mm),
                             kEndSooner);
    }
    if (!facts.still_at_arm) return skipped("joint", "mm²", facts.still_at_arm.error());
    return with_sentence(at_most("joint", total_mm2(*facts.still_at_arm), limits.apart_mm2, "mm²"),
                         listed(*facts.still_at_arm, "of the arm's side stood still"), kEndSooner);
}

CellCheckItem sweep_item(const CellFacts& facts, const CellLimits& limits) {
    if (!facts.sweep) return skipped("sweep", "mm", facts.sweep.error());
    const double radius_mm = kMmPerM * facts.sweep->gripper_radius_m;
    const double clearance_mm = kMmPerM * facts.sweep->free_radius_m - radius_mm;
    return with_sentence(
        at_least("sweep", clearance_mm, limits.clearance_mm, "mm"),
        fmt::format("the gripper reaches {:.0f} mm from the axis, the nearest that the camera sees "
                    "stand still is {:.0f} mm further out",
                    radius_mm, clearance_mm),
        "make room around the gripper");
}

}  // namespace gripscan
