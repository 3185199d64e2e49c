#include "app/workstation/run_window.h"

#include <optional>

#include "app/threads.h"
#include "app/workstation/frame_loop.h"
#include "core/base/atomic_file.h"
#include "ui/memory/session_line.h"

namespace gripscan::app {
namespace {
namespace fs = std::filesystem;

struct Size {
    int width_px = 1600;
    int height_px = 1000;
};

Result<Size> size_of(const std::string& text) {
    Size size;
    if (text.empty()) return size;
    char x = 0;
    char end = 0;
    if (std::sscanf(text.c_str(), "%d%c%d%c", &size.width_px, &x, &size.height_px, &end) != 3 ||
        x != 'x' || size.width_px < 320 || size.height_px < 240 || size.width_px > 16384 ||
        size.height_px > 16384) {
        return input_error("--size {}: expected WIDTHxHEIGHT in px, such as 1600x1000", text);
    }
    return size;
}

Result<std::optional<ui::ScriptPlayer>> player_of(const WindowOptions& options) {
    if (options.script.empty()) return std::optional<ui::ScriptPlayer>();
    const auto text = read_whole_file(options.script);
    if (!text) return forward_error(text.error());
    auto steps = ui::parse_script(*text, options.script);
    if (!steps) return forward_error(steps.error());
    return std::optional<ui::ScriptPlayer>(ui::ScriptPlayer(std::move(*steps)));
}

/// What is to be open when the window appears.
void begin(Workstation& station, const WindowOptions& options) {
    ui::SessionWish wish;
    wish.folder = options.session;
    if (!options.cell.empty()) wish.cell = options.cell;
    std::error_code code;
    if (options.session.empty()) {
        if (options.demo || !options.cell.empty()) station.take(ui::request::Begin{wish});
        return;
    }
    const fs::path session = options.session;
    if (fs::is_regular_file(session, code) || fs::exists(session / "captures.csv", code)) {
        const auto line = ui::session_line(session);
        const bool goes_on = line.end == ui::RecentSession::End::kInterrupted;
        if (goes_on) {
            station.take(ui::request::Resume{session});
        } else {
            station.take(ui::request::Open{session});
        }
        return;
    }
    // Without a capture there is at most a journal: resuming begins anew where there is none.
    if (fs::exists(session / "journal", code)) {
        station.take(ui::request::Resume{session});
    } else {
        station.take(ui::request::Begin{wish});
    }
}

}  // namespace

Result<ExitStatus> run_window(const WindowOptions& options, const Context& context) {
    const auto size = size_of(options.size);
    if (!size) return forward_error(size.error());
    auto player = player_of(options);
    if (!player) return forward_error(player.error());
    if (options.demo) {
        auto tour = guided_tour();
        if (!tour) return forward_error(tour.error());
        *player = std::move(*tour);
    }
    WorkstationSettings settings;
    settings.threads = thread_count(context);
    settings.files = session_files_of_user();
    settings.wake = ui::AppWindow::request_redraw;
    settings.preferences = ui::load_preferences(settings.files.preferences);
    const ui::WindowPreferences& stored = settings.preferences.stored.preferences;
    ui::WindowSettings window_settings;
    window_settings.width_px = size->width_px;
    window_settings.height_px = size->height_px;
    window_settings.theme = stored.theme;
    window_settings.user_scale =
        static_cast<float>(options.scale > 0.0 ? options.scale : stored.user_scale);
    auto window = ui::AppWindow::make(window_settings);
    if (!window) return forward_error(window.error());
    Workstation station(std::move(settings));
    FrameLoop loop(**window, station, options, std::move(*player));
    if (Status made = loop.make_views(); !made) return forward_error(made.error());
    begin(station, options);
    // A signal closes the window as its user would, without asking.
    const std::stop_callback wake(context.stop, [] { ui::AppWindow::request_redraw(); });
    const Status ran = (*window)->run(
        [&](const ui::FrameInput& input) {
            ui::FrameWish wish = loop.frame(input);
            if (context.stop.stop_requested()) wish.close = true;
            return wish;
        },
        options.frames);
    if (!ran) return forward_error(ran.error());
    if (const auto trouble = loop.trouble()) return input_error("{}", *trouble);
    return kDone;
}

}  // namespace gripscan::app
