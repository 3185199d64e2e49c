#include "ui/shell/app_window.h"

#include <epoxy/gl.h>
#include <imgui_impl_glfw.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <type_traits>
#include <utility>

#include "ui/gl/render_target.h"
#include "ui/shell/glfw_window.h"
#include "ui/shell/imgui_feed.h"
#include "ui/shell/imgui_session.h"
#include "ui/shell/partial_painter.h"

namespace gripscan::ui {
namespace {

using Clock = std::chrono::steady_clock;

/// Dear ImGui needs a frame to see an event and another to show what it did.
constexpr int kFramesPerEvent = 3;
/// News from elsewhere changes what is shown at once; lists that scroll with it do in the next
/// frame.
constexpr int kFramesPerNews = 2;
/// Longest sleep: a lost wake-up would show after this.
constexpr double kLongestWait_s = 2.0;
constexpr double kCursorBlink_s = 0.4;
/// Smallest window in which no page loses anything, px at 100 %.
constexpr float kSmallestWidth = 1024.0F;
constexpr float kSmallestHeight = 640.0F;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

double thread_cpu_ms() {
    timespec spent{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &spent);
    return 1e3 * static_cast<double>(spent.tv_sec) + 1e-6 * static_cast<double>(spent.tv_nsec);
}

}  // namespace

struct AppWindow::Parts {
    std::unique_ptr<GlfwWindow> window;
    std::unique_ptr<ImGuiSession> session;
    std::unique_ptr<PartialPainter> painter;
    bool glfw_backend = false;
    ImGuiFeed feed;
    WidgetLog log;
    Clock::time_point opened = Clock::now();
    float user_scale = 1.0F;
    float limited_at = 0.0F;  ///< scale at which the smallest size was set
    ThemeChoice theme = ThemeChoice::kDark;
    bool theme_changed = false;
    FrameTimes last;
    std::size_t frames = 0;
    Capture capture;
    bool large_buttons = false;
    std::function<void(const WidgetLog&, double)> set_input;

    ~Parts() {
        painter.reset();
        if (glfw_backend) ImGui_ImplGlfw_Shutdown();
        session.reset();
    }

    /// The pages have room in a window of that size, and not in a smaller one.
    void limit_size(const Scale& scale) {
        if (std::exchange(limited_at, scale.factor()) == scale.factor()) return;
        window->keep_at_least({static_cast<int>(scale.px(kSmallestWidth)),
                               static_cast<int>(scale.px(kSmallestHeight))});
    }

    /// Scale and theme, between frames.
    Status apply_changes() {
        const Scale wanted(window->content_scale() * user_scale);
        limit_size(wanted);
        if (auto set = session->set_scale(wanted); !set) return set;
        if (!std::exchange(theme_changed, false)) return {};
        return session->set_theme(theme);
    }

    /// Dear ImGui reads the keys that are down here: letters by what stands on the keys. GLFW's own
    /// account stays as it is, because it is told of changes only.
    void begin_imgui_frame() {
        auto& down = ImGui::GetIO().KeysDown;
        std::array<bool, std::extent_v<std::remove_reference_t<decltype(down)>>> by_place{};
        std::ranges::copy(down, by_place.begin());
        put_letters_right(GlfwWindow::letters(), down);
        if (set_input) set_input(log, seconds_since(opened));
        ImGui::NewFrame();
        std::ranges::copy(by_place, std::begin(down));
    }

    /// `exposed`: what the window shows may be lost. A picture that has not changed is not shown
    /// again.
    Result<FrameWish> draw(const Frame& frame, std::vector<std::filesystem::path> dropped,
                           bool exposed) {
        const auto start = Clock::now();
        const double cpu_start_ms = thread_cpu_ms();
        const auto size = window->framebuffer();
        painter->begin_frame(session->fonts_changed());
        ImGui_ImplGlfw_NewFrame();
        feed.give(window->input().take_frame());
        begin_imgui_frame();
        Ui ui = session->frame_ui(log, seconds_since(opened));
        ui.large_buttons = large_buttons;
        begin_screen(ui, ui.theme.bg0);
        const auto& released = ImGui::GetIO().MouseReleased;
        const bool clicked = std::ranges::any_of(released, [](bool button) { return button; });
        FrameWish wish = frame({ui, size.width_px, size.height_px, last, clicked,
                                window->take_close_request(), std::move(dropped)});
        end_screen();
        ImGui::Render();
        const auto changed = painter->paint(size.width_px, size.height_px);
        if (!changed) return forward_error(changed.error());
        const bool shows = *changed || exposed || capture;
        if (shows) painter->show();
        if (auto wanted = std::exchange(capture, nullptr)) {
            wanted(size.width_px, size.height_px,
                   read_framebuffer_rgba(size.width_px, size.height_px));
        }
        last.own_ms = 1e3 * seconds_since(start);
        last.cpu_ms = thread_cpu_ms() - cpu_start_ms;
        const auto swap_start = Clock::now();
        if (shows) window->swap();
        last.swap_ms = 1e3 * seconds_since(swap_start);
        ++frames;
        if (ImGui::GetIO().WantTextInput) {
            wish.redraw_after_s = std::min(wish.redraw_after_s, kCursorBlink_s);
        }
        return wish;
    }
};

AppWindow::AppWindow() : parts_(std::make_unique<Parts>()) {}
AppWindow::~AppWindow() = default;

Result<std::unique_ptr<AppWindow>> AppWindow::make(const WindowSettings& settings) {
    auto window = GlfwWindow::make(settings.title, settings.width_px, settings.height_px);
    if (!window) return forward_error(window.error());
    std::unique_ptr<AppWindow> app(new AppWindow());
    Parts& parts = *app->parts_;
    parts.window = *std::move(window);
    parts.user_scale = settings.user_scale;
    parts.theme = settings.theme;
    const Scale scale(parts.window->content_scale() * settings.user_scale);
    if (const float monitor = parts.window->content_scale(); monitor != 1.0F) {
        const auto size = [&](int px) {
            return static_cast<int>(monitor * static_cast<float>(px));
        };
        parts.window->resize({size(settings.width_px), size(settings.height_px)});
    }
    auto session = ImGuiSession::make(settings.theme, scale);
    if (!session) return forward_error(session.error());
    parts.session = *std::move(session);
    parts.feed = ImGuiFeed(parts.window->handle());
    parts.glfw_backend = ImGui_ImplGlfw_InitForOpenGL(parts.window->handle(), false);
    auto painter = ImGuiPainter::make();
    if (!painter) return forward_error(painter.error());
    parts.painter = std::make_unique<PartialPainter>(*std::move(painter));
    return app;
}

Status AppWindow::run(const Frame& frame, std::size_t most_frames) {
    Parts& parts = *parts_;
    const std::size_t first = parts.frames;
    int owed = kFramesPerEvent;  // frames that are drawn without waiting
    auto due = Clock::time_point::max();
    for (;;) {
        const bool at_once = owed > 0 || most_frames > 0;
        const double until_due =
            due == Clock::time_point::max() ? kLongestWait_s : -seconds_since(due);
        auto news = parts.window->wait(at_once ? 0.0 : std::clamp(until_due, 0.0, kLongestWait_s));
        if (news.woken) owed = std::max(owed, kFramesPerNews);
        if (news.anything) owed = kFramesPerEvent;
        const bool timer = Clock::now() >= due;
        if (owed == 0 && !timer && most_frames == 0) continue;

        if (auto applied = parts.apply_changes(); !applied) return applied;
        const auto drawn = parts.draw(frame, std::move(news.dropped), news.exposed);
        if (!drawn) return forward_error(drawn.error());
        const FrameWish& wish = *drawn;
        owed = std::max(0, owed - 1);
        if (!parts.window->input().empty()) owed = kFramesPerEvent;
        due = std::isinf(wish.redraw_after_s)
                  ? Clock::time_point::max()
                  : Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                       std::chrono::duration<double>(wish.redraw_after_s));
        if (wish.close) break;
        if (most_frames > 0 && parts.frames - first >= most_frames) break;
    }
    return {};
}

void AppWindow::request_redraw() {
    GlfwWindow::wake();
}

void AppWindow::capture_next(Capture capture) {
    parts_->capture = std::move(capture);
}

void AppWindow::set_user_scale(float factor) {
    parts_->user_scale = factor;
}

void AppWindow::set_theme(ThemeChoice theme) {
    parts_->theme_changed = parts_->theme_changed || theme != parts_->theme;
    parts_->theme = theme;
}

void AppWindow::set_large_buttons(bool on) {
    parts_->large_buttons = on;
}

void AppWindow::copy_to_clipboard(const std::string& text) {
    ImGui::SetClipboardText(text.c_str());
}

void AppWindow::before_frames(std::function<void(const WidgetLog&, double)> set_input) {
    parts_->set_input = std::move(set_input);
}

std::size_t AppWindow::frames_drawn() const {
    return parts_->frames;
}

const WidgetLog& AppWindow::widgets() const {
    return parts_->log;
}

}  // namespace gripscan::ui
