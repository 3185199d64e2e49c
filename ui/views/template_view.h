// What the template page and the export dialog say, without drawing.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ui/views/snapshot.h"

namespace gripscan::ui {

/// The crop as it is edited: the user's, else the bounds of the whole template.
[[nodiscard]] std::optional<Box> edited_crop(const Snapshot& snapshot);

/// The filter with one side of its crop moved, mm; sides never cross: the other one gives way.
enum class CropSide { kFrom, kTo, kSize };
[[nodiscard]] TemplateFilter with_crop_side(const Snapshot& snapshot, int axis, CropSide side,
                                            double value_mm);
/// The cuboid drawn in to the points that are kept; why it cannot be, else nothing.
[[nodiscard]] std::string why_no_fit(const Snapshot& snapshot);
[[nodiscard]] TemplateFilter fitted_crop(const Snapshot& snapshot);

/// Largest seen-count of the template; 1 where it does not know its views.
[[nodiscard]] int most_seen(const Snapshot& snapshot);

/// Is the turn behind the template trusted, and what it rests on.
struct TrustText {
    Verdict verdict = Verdict::kReject;
    std::string word;      ///< "Trusted", "To be checked", "Not trusted"
    std::string sentence;  ///< "36 steps, 1 check, 0 rejected. Closed: `0.07`°, `0.24` mm"
};
[[nodiscard]] std::optional<TrustText> trust_text(const Snapshot& snapshot);

enum class CloudFormat { kPcd, kPly, kXyz };
[[nodiscard]] CloudFormat format_of(const std::filesystem::path& file);
[[nodiscard]] std::filesystem::path with_format(std::filesystem::path file, CloudFormat format);

/// About how many bytes the file will have.
[[nodiscard]] std::uint64_t export_bytes(std::size_t points, const Cloud& cloud,
                                         const ExportWish& wish);

/// exports/NAME_v1.pcd in the session's folder, numbered up until nothing lies there.
[[nodiscard]] std::filesystem::path suggested_file(const Snapshot& snapshot);

/// Why nothing can be written, in words; empty: it can.
[[nodiscard]] std::string export_problem(const Snapshot& snapshot, const ExportWish& wish);

}  // namespace gripscan::ui
