// How long a frame of the 3D view takes while it orbits: points, frames and times of every part,
// as a histogram. Usage: cloud_view_benchmark [million points] [frames]
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "tests/render/synthetic_cell.h"
#include "tests/support/egl_context.h"
#include "ui/gl/gl_object.h"
#include "ui/render/cloud_view.h"
#include "ui/render/picking.h"

namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Of all threads: what the frame costs whatever else the machine does.
double cpu_ms() {
    return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double quantile(std::vector<double> times, double q) {
    std::sort(times.begin(), times.end());
    return times[static_cast<std::size_t>(q * static_cast<double>(times.size() - 1))];
}

void print_histogram(const std::vector<double>& times_ms) {
    for (int from = 0; from < 400; from += 4) {
        const auto count = std::count_if(times_ms.begin(), times_ms.end(),
                                         [&](double t) { return t >= from && t < from + 4; });
        if (count > 0) fmt::print("{:3} to {:3} ms {:5}\n", from, from + 4, count);
    }
}

}  // namespace

int main(int argc, char** argv) {
    using namespace gripscan;
    const double millions = argc > 1 ? std::atof(argv[1]) : 5.0;
    const int frames = argc > 2 ? std::atoi(argv[2]) : 300;
    const auto context = test::EglContext::make();
    auto view = ui::CloudView::make();
    const auto theme = ui::load_theme(ui::ThemeChoice::kDark);
    if (!context || !view || !theme) return 1;
    fmt::print("{}\n", reinterpret_cast<const char*>(glGetString(GL_RENDERER)));

    const auto chunks = test::synthetic_part(static_cast<std::size_t>(millions * 1e6),
                                             argc > 3 ? std::atoi(argv[3]) : 36);
    ui::OrbitCamera camera;
    camera = ui::fitted(camera, {{-0.07, -0.07, 0.63}, {0.07, 0.07, 0.77}}, {900, 578});
    const ui::ViewSettings settings{
        .colour_by = ui::ColourBy::kStep, .range_from = 1, .range_to = 36};
    std::vector<double> times;
    std::vector<double> cpu_times;
    double last_ms = 0.0;
    for (int i = 0; i < frames; ++i) {
        camera = ui::orbited(camera, 4.0, i % 100 < 50 ? 1.0 : -1.0, {900, 578});
        const auto lines = test::synthetic_lines(*theme, camera.eye_m());
        const auto start = Clock::now();
        const double cpu_start = cpu_ms();
        if (!(*view)->draw({chunks, &lines, camera, settings}, 900, 578, *theme, ui::Scale(),
                           last_ms)) {
            return 1;
        }
        glFinish();
        last_ms = ms_since(start);
        if (i == 0) {
            fmt::print("first frame with the upload {:.0f} ms\n", last_ms);
            last_ms = 0.0;
        } else {
            times.push_back(last_ms);
            cpu_times.push_back(cpu_ms() - cpu_start);
        }
    }
    fmt::print(
        "{} frames: median {:.1f}, 95 % {:.1f}, 99 % {:.1f}, most {:.1f} ms; {} points each\n",
        times.size(), quantile(times, 0.5), quantile(times, 0.95), quantile(times, 0.99),
        quantile(times, 1.0), (*view)->level_of_detail().budget());
    fmt::print("processor time of all threads: median {:.1f}, 95 % {:.1f} ms\n",
               quantile(cpu_times, 0.5), quantile(cpu_times, 0.95));
    print_histogram(times);

    const auto start = Clock::now();
    int slices = 0;
    for (; !(*view)->complete(); ++slices) {
        if (!(*view)->draw({chunks, nullptr, camera, settings}, 900, 578, *theme, ui::Scale(), 0)) {
            return 1;
        }
        glFinish();
    }
    fmt::print("all points after standing still: {:.0f} ms in {} frames\n", ms_since(start),
               slices);
    const auto pick = Clock::now();
    const auto picked = ui::pick_point(chunks, camera, {900, 578}, {450, 289});
    fmt::print("picking among all points: {:.1f} ms, {}\n", ms_since(pick),
               picked ? "found" : "nothing there");
    return 0;
}
