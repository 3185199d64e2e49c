#include "ui/views/template_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "core/base/units.h"
#include "core/report/table1.h"

namespace gripscan::ui {
namespace {
namespace fs = std::filesystem;

constexpr double kLeastSide_m = 1e-4;

std::string lower_extension(const fs::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

/// Bytes of one field in a file of numbers, and about as many letters as text.
std::uint64_t field_bytes(bool text, std::uint64_t binary, std::uint64_t letters) {
    return text ? letters : binary;
}

}  // namespace

std::optional<Box> edited_crop(const Snapshot& snapshot) {
    if (snapshot.filter.crop) return snapshot.filter.crop;
    if (!snapshot.shown_template) return std::nullopt;
    return snapshot.shown_template->whole_facts.bounds;
}

TemplateFilter with_crop_side(const Snapshot& snapshot, int axis, CropSide side, double value_mm) {
    TemplateFilter filter = snapshot.filter;
    Box box = edited_crop(snapshot).value_or(Box{});
    const double value_m = value_mm / kMmPerM;
    double& from = box.min_m[axis];
    double& to = box.max_m[axis];
    switch (side) {
        case CropSide::kFrom:
            from = value_m;
            to = std::max(to, from + kLeastSide_m);
            break;
        case CropSide::kTo:
            to = value_m;
            from = std::min(from, to - kLeastSide_m);
            break;
        case CropSide::kSize: {
            const double middle = 0.5 * (from + to);
            from = middle - 0.5 * std::max(value_m, kLeastSide_m);
            to = middle + 0.5 * std::max(value_m, kLeastSide_m);
            break;
        }
    }
    filter.crop = box;
    return filter;
}

std::string why_no_fit(const Snapshot& snapshot) {
    if (!snapshot.shown_template) return "There is no template yet.";
    if (snapshot.filter.invert_crop) {
        return "An inverted cuboid cuts away what is inside: turn Invert off first.";
    }
    if (!snapshot.shown_template->kept_facts.bounds) return "No point is kept.";
    return {};
}

TemplateFilter fitted_crop(const Snapshot& snapshot) {
    TemplateFilter filter = snapshot.filter;
    filter.crop = snapshot.shown_template->kept_facts.bounds;
    // A cloud file holds single precision: the outermost points shall stay inside.
    constexpr double kMargin_m = 1e-6;
    filter.crop->min_m.array() -= kMargin_m;
    filter.crop->max_m.array() += kMargin_m;
    return filter;
}

int most_seen(const Snapshot& snapshot) {
    if (!snapshot.shown_template || !snapshot.shown_template->whole) return 1;
    const auto& seen = snapshot.shown_template->whole->seen;
    return seen.empty() ? 1 : std::max<int>(1, *std::max_element(seen.begin(), seen.end()));
}

std::optional<TrustText> trust_text(const Snapshot& snapshot) {
    if (!snapshot.solved) return std::nullopt;
    const TurnReport& report = snapshot.solved->report;
    const TurnSummary summary = summary_of(report);
    TrustText text;
    text.verdict = summary.rejected > 0 ? Verdict::kReject
                   : summary.checks > 0 ? Verdict::kCheck
                                        : Verdict::kAccept;
    text.word = summary.rejected > 0 ? "Not trusted"
                : summary.checks > 0 ? "To be checked"
                                     : "Trusted";
    text.sentence = fmt::format("`{}` steps, `{}` to be checked, `{}` rejected. ", summary.steps,
                                summary.checks, summary.rejected);
    text.sentence += report.closure_after
                         ? fmt::format("Closed: `{:.2f}°`, `{:.2f} mm`",
                                       deg_from_rad(report.closure_after->angle_rad),
                                       report.closure_after->shift_m * kMmPerM)
                         : "Not closed.";
    return text;
}

CloudFormat format_of(const fs::path& file) {
    const std::string extension = lower_extension(file);
    return extension == ".ply"   ? CloudFormat::kPly
           : extension == ".xyz" ? CloudFormat::kXyz
                                 : CloudFormat::kPcd;
}

fs::path with_format(fs::path file, CloudFormat format) {
    return file.replace_extension(format == CloudFormat::kPly   ? ".ply"
                                  : format == CloudFormat::kXyz ? ".xyz"
                                                                : ".pcd");
}

std::uint64_t export_bytes(std::size_t points, const Cloud& cloud, const ExportWish& wish) {
    const CloudFormat format = format_of(wish.file);
    const bool text = format == CloudFormat::kXyz || wish.encoding == PcdEncoding::kAscii;
    std::uint64_t bytes = field_bytes(text, 12, 36);
    if (wish.normals && cloud.has_normals()) bytes += field_bytes(text, 12, 36);
    if (wish.intensity && !cloud.intensity.empty()) bytes += field_bytes(text, 4, 8);
    if (wish.sigma && !cloud.sigma.empty()) bytes += field_bytes(text, 4, 14);
    if (wish.seen && !cloud.seen.empty()) bytes += field_bytes(text, 4, 3);
    bytes *= points;
    // Coordinates hardly compress; counts and normals do a little.
    const bool packed = format == CloudFormat::kPcd && wish.encoding == PcdEncoding::kCompressed;
    return packed ? bytes * 9 / 10 : bytes;
}

fs::path suggested_file(const Snapshot& snapshot) {
    const fs::path folder =
        snapshot.session ? snapshot.session->folder / "exports" : fs::path("exports");
    const std::string name =
        snapshot.session && !snapshot.session->name.empty() ? snapshot.session->name : "template";
    std::error_code code;
    for (int number = 1;; ++number) {
        const fs::path file = folder / fmt::format("{}_v{}.pcd", name, number);
        if (!fs::exists(file, code)) return file;
    }
}

std::string export_problem(const Snapshot& snapshot, const ExportWish& wish) {
    if (!snapshot.shown_template) return "There is no template yet.";
    if (snapshot.shown_template->counts.kept == 0) return "The filter keeps no point.";
    if (wish.file.empty() || !wish.file.has_stem()) return "Type the file to write.";
    const std::string extension = lower_extension(wish.file);
    if (extension != ".pcd" && extension != ".ply" && extension != ".xyz") {
        return "The name must end with .pcd, .ply or .xyz.";
    }
    if (wish.axis_frame && !(snapshot.solved && snapshot.solved->report.axis)) {
        return "The axis of joint 6 is not known: choose the camera frame.";
    }
    std::error_code code;
    if (fs::exists(wish.file, code)) {
        return "There is a file of this name: nothing is overwritten. Choose another.";
    }
    return {};
}

}  // namespace gripscan::ui
