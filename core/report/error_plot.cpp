#include "core/report/error_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/units.h"

namespace gripscan {
namespace {

constexpr double kWidth = 1000.0;
constexpr double kHeight = 300.0;
constexpr double kLeft = 58.0;
constexpr double kRight = 16.0;
constexpr double kTop = 14.0;
constexpr double kBottom = 40.0;

double error_deg(const TurnStep& step) {
    return deg_from_rad(*step.error_rad);
}

class ErrorPlot {
  public:
    explicit ErrorPlot(const TurnReport& report) : report_(report) {
        limit_deg_ = deg_from_rad(report.limits.angle_rad);
        top_deg_ = 1.35 * limit_deg_;
        for (const auto& step : report.steps) {
            if (step.sigma_rad) top_deg_ = std::max(top_deg_, 1.2 * deg_from_rad(*step.sigma_rad));
            // Up to four limits the scale follows the errors; what lies beyond is clipped and
            // named.
            if (step.error_rad) {
                const double error = std::abs(error_deg(step));
                top_deg_ = std::max(top_deg_, std::min(1.15 * error, 4.0 * limit_deg_));
            }
        }
    }

    std::string svg() const {
        std::string text = fmt::format(
            "<svg viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"error of every step\">\n",
            kWidth, kHeight);
        text += band(report_.limits.sigmas, "band-wide") + band(1.0, "band");
        text += grid() + limits() + step_labels();
        for (std::size_t i = 0; i < report_.steps.size(); ++i) text += mark(i);
        text += values_beyond();
        return text + "</svg>\n";
    }

  private:
    [[nodiscard]] double x(double step) const {
        const double n = static_cast<double>(report_.steps.size());
        return kLeft + (kWidth - kLeft - kRight) * (step + 0.5) / n;
    }
    [[nodiscard]] double y(double deg) const {
        const double share = 0.5 - 0.5 * std::clamp(deg / top_deg_, -1.0, 1.0);
        return kTop + (kHeight - kTop - kBottom) * share;
    }

    /// Predicted spread about zero: a stair, each step with its own sigma.
    [[nodiscard]] std::string band(double sigmas, std::string_view name) const {
        std::string text;
        for (std::size_t i = 0; i < report_.steps.size(); ++i) {
            if (!report_.steps[i].sigma_rad) continue;
            const double half = sigmas * deg_from_rad(*report_.steps[i].sigma_rad);
            const double left = x(static_cast<double>(i) - 0.5);
            text += fmt::format(
                "<rect class=\"{}\" x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" "
                "height=\"{:.2f}\"/>\n",
                name, left, y(half), x(static_cast<double>(i) + 0.5) - left, y(-half) - y(half));
        }
        return text;
    }

    [[nodiscard]] std::string grid() const {
        constexpr std::array kSteps{0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0};
        double spacing = kSteps.back();
        for (const double candidate : kSteps) {
            if (top_deg_ / candidate <= 4.0) {
                spacing = candidate;
                break;
            }
        }
        std::string text;
        const int n = static_cast<int>(top_deg_ / spacing);
        for (int i = -n; i <= n; ++i) {
            const double deg = i * spacing;
            text += fmt::format(
                "<line class=\"{}\" x1=\"{:.0f}\" x2=\"{:.0f}\" y1=\"{:.2f}\" y2=\"{:.2f}\"/>"
                "<text class=\"tick\" x=\"{:.0f}\" y=\"{:.2f}\" text-anchor=\"end\">{:g}</text>\n",
                i == 0 ? "zero" : "grid", kLeft, kWidth - kRight, y(deg), y(deg), kLeft - 8.0,
                y(deg) + 4.0, deg);
        }
        return text + fmt::format(
                          "<text class=\"tick\" transform=\"translate(14 {:.0f}) rotate(-90)\" "
                          "text-anchor=\"middle\">error (deg)</text>\n",
                          y(0.0));
    }

    [[nodiscard]] std::string limits() const {
        std::string text;
        for (const double sign : {-1.0, 1.0}) {
            text += fmt::format(
                "<line class=\"limit\" x1=\"{:.0f}\" x2=\"{:.0f}\" y1=\"{:.2f}\" y2=\"{:.2f}\"/>\n",
                kLeft, kWidth - kRight, y(sign * limit_deg_), y(sign * limit_deg_));
        }
        return text;
    }

    [[nodiscard]] std::string step_labels() const {
        const std::size_t n = report_.steps.size();
        const std::size_t every = n <= 40 ? 1 : (n + 39) / 40;
        std::string text;
        for (std::size_t i = 0; i < n; i += every) {
            text += fmt::format(
                "<text class=\"tick\" x=\"{:.2f}\" y=\"{:.0f}\" text-anchor=\"middle\">{}</text>\n",
                x(static_cast<double>(i)), kHeight - 22.0, report_.steps[i].index);
        }
        return text + fmt::format(
                          "<text class=\"tick\" x=\"{:.0f}\" y=\"{:.0f}\" "
                          "text-anchor=\"middle\">step</text>\n",
                          0.5 * (kLeft + kWidth - kRight), kHeight - 5.0);
    }

    /// Verdicts differ by shape as well as by colour.
    [[nodiscard]] std::string mark(std::size_t i) const {
        const TurnStep& step = report_.steps[i];
        const double px = x(static_cast<double>(i));
        const auto title = [&](const std::string& value) {
            return fmt::format("<title>step {} ({} to {}): {}, {}</title>", step.index, step.from,
                               step.to, value, word(step.verdict));
        };
        if (!step.error_rad) {
            return fmt::format(
                "<text class=\"mark reject\" x=\"{:.2f}\" y=\"{:.2f}\" "
                "text-anchor=\"middle\">?{}</text>\n",
                px, y(0.0) - 6.0, title("no error known"));
        }
        return fmt::format(
            "<path class=\"mark {}\" transform=\"translate({:.2f} {:.2f})\" d=\"{}\">{}</path>\n",
            word(step.verdict), px, y(error_deg(step)), shape(step.verdict),
            title(fmt::format("{:.3f} deg", error_deg(step))));
    }

    /// The values of the marks beyond the scale, in rows where neighbours would overlap.
    [[nodiscard]] std::string values_beyond() const {
        std::array<double, 3> above{};  // where the text of each row ends
        std::array<double, 3> below{};
        std::string text;
        for (std::size_t i = 0; i < report_.steps.size(); ++i) {
            const TurnStep& step = report_.steps[i];
            if (!step.error_rad || std::abs(error_deg(step)) <= top_deg_) continue;
            const double px = x(static_cast<double>(i));
            const std::string value = fmt::format("{:.2f}", error_deg(step));
            const double half_width = 4.0 * static_cast<double>(value.size());
            const bool up = error_deg(step) > 0.0;
            auto& ends = up ? above : below;
            auto* row = std::find_if(ends.begin(), ends.end(),
                                     [&](double end) { return end <= px - half_width; });
            if (row == ends.end()) row = std::min_element(ends.begin(), ends.end());
            *row = px + half_width;
            const double shift = 13.0 * static_cast<double>(row - ends.begin());
            text += fmt::format(
                "<text class=\"value\" x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"middle\">{}"
                "</text>\n",
                px, y(error_deg(step)) + (up ? 20.0 + shift : -12.0 - shift), value);
        }
        return text;
    }

    [[nodiscard]] static std::string_view shape(Verdict verdict) {
        switch (verdict) {
            case Verdict::kCheck:
                return "M0 -6L6 5H-6Z";
            case Verdict::kReject:
                return "M-5 -5L5 5M5 -5L-5 5";
            case Verdict::kAcceptNoted:
                return "M-4.5 -4.5H4.5V4.5H-4.5Z";
            case Verdict::kAccept:
                break;
        }
        return "M-4.5 0A4.5 4.5 0 1 0 4.5 0A4.5 4.5 0 1 0 -4.5 0Z";
    }

    const TurnReport& report_;
    double limit_deg_ = 0.0;
    double top_deg_ = 0.0;
};

}  // namespace

std::string error_plot_svg(const TurnReport& report) {
    const bool any = std::any_of(report.steps.begin(), report.steps.end(),
                                 [](const TurnStep& step) { return step.error_rad.has_value(); });
    return any ? ErrorPlot(report).svg() : "";
}

}  // namespace gripscan
