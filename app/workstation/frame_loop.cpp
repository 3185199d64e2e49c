#include "app/workstation/frame_loop.h"

#include <algorithm>

#include "app/workstation/picture_file.h"
#include "ui/render/picture_crop.h"
#include "ui/resources/resource_file.h"

namespace gripscan::app {

FrameLoop::FrameLoop(ui::AppWindow& window, Workstation& station, const WindowOptions& options,
                     std::optional<ui::ScriptPlayer> player)
    : window_(window), station_(station), options_(options), player_(std::move(player)) {
    if (!options.widgets.empty()) widgets_.emplace(options.widgets);
    screen_.splits = station.preferences().splits;
    applied_ = station.preferences().preferences;
    window.set_large_buttons(applied_.large_buttons);
    window.before_frames([this](const ui::WidgetLog& shown, double now_s) {
        if (widgets_) widgets_->tell(shown);
        if (player_) player_->before_frame(shown, now_s);
    });
}

Status FrameLoop::make_views() {
    auto parts = ui::make_screen_parts();
    if (!parts) return forward_error(parts.error());
    parts_ = std::move(*parts);
    if (options_.frame_times.empty()) return {};
    auto times = FrameTimesFile::make(options_.frame_times);
    if (!times) return forward_error(times.error());
    times_ = std::move(*times);
    return {};
}

ui::FrameWish FrameLoop::frame(const ui::FrameInput& input) {
    ++frames_;
    station_.pump(input.ui.time_s);
    for (const auto& path : input.dropped) pass_on(ui::request::Open{path});
    if (input.close_requested) pass_on(ui::request::Quit{});
    ui::Snapshot snapshot = station_.snapshot();
    ui::Requests requests;
    // A photograph of the 3D view takes one frame without what stands over it.
    const bool photograph = view_picture_ && !parts_.wants_another_frame();
    screen_.view3d.photograph = photograph;
    if (photograph) snapshot.toasts.clear();
    const std::string caption = player_ && !photograph ? player_->caption() : "";
    ui::draw_screen(input.ui, input.width_px, input.height_px, snapshot, caption,
                    input.last.total_ms(), screen_, parts_, requests);
    if (photograph) {
        take_picture(picture_file("-view"), screen_.view3d.picture_rect);
        screen_.view3d.photograph = view_picture_ = false;
    }
    for (const ui::Request& request : requests) pass_on(request);
    if (times_) times_->note(input, requests.size());
    station_.set_splits(screen_.splits);
    take_window_wish(station_.window_wish());
    apply_preferences();

    ui::FrameWish wish;
    wish.redraw_after_s = requests.empty() ? station_.next_change_s(input.ui.time_s) : 0.0;
    if (parts_.wants_another_frame() || photograph) wish.redraw_after_s = 0.0;
    if (player_ && player_->ended() && options_.script.empty()) player_.reset();
    if (player_) {
        if (const auto file = player_->picture_wanted()) take_picture(*file);
        wish.redraw_after_s = std::min(wish.redraw_after_s, 0.02);
        wish.close = !options_.script.empty() && (player_->ended() || player_->trouble());
    }
    if (!options_.screenshot.empty() && options_.frames > 0 && frames_ == options_.frames) {
        take_picture(options_.screenshot);
    }
    wish.close = wish.close || screen_.quit;
    return wish;
}

void FrameLoop::pass_on(const ui::Request& request) {
    prepare_for(request);
    station_.take(request);
}

void FrameLoop::prepare_for(const ui::Request& request) {
    if (const auto* show = std::get_if<ui::request::Show>(&request)) {
        if (show->dialog == ui::Dialog::kNewSession) {
            ui::TypedSession& typed = screen_.new_session.typed;
            typed.simulated = !show->cell_file;
            typed.wish.object = show->object;
            if (show->object) typed.gripper = station_.gripper_to_hold_with().string();
        }
    } else if (std::holds_alternative<ui::request::KeepRegion>(request)) {
        ui::TypedSession& typed = screen_.new_session.typed;  // a session with it comes next
        typed.simulated = false;
        typed.cell_file = station_.snapshot().cell.file.string();
    } else if (std::holds_alternative<ui::request::Quit>(request)) {
        screen_.close.quits = true;
    } else if (std::holds_alternative<ui::request::CloseSession>(request) ||
               std::holds_alternative<ui::request::Open>(request) ||
               std::holds_alternative<ui::request::Resume>(request) ||
               std::holds_alternative<ui::request::Begin>(request)) {
        screen_.close.quits = false;  // another session shall take its place
    } else if (std::holds_alternative<ui::request::Tour>(request)) {
        auto tour = guided_tour();
        if (tour) {
            player_ = std::move(*tour);
        } else {
            station_.toast(ui::LogLevel::kError, "toast.tour", "No tour", tour.error().message);
        }
    }
}

void FrameLoop::take_window_wish(const WindowWish& wish) {
    if (wish.clipboard) window_.copy_to_clipboard(*wish.clipboard);
    if (wish.reset_layout) screen_.splits = {};
    if (wish.quit) screen_.quit = true;
    if (wish.view_picture) view_picture_ = true;
    if (wish.screenshot) take_picture(picture_file(""));
}

std::filesystem::path FrameLoop::picture_file(const std::string& ending) const {
    const auto shown = station_.snapshot();
    const auto folder =
        shown.session ? shown.session->folder.parent_path() : std::filesystem::current_path();
    const std::string name = (shown.session ? shown.session->name : "gripscan") + ending;
    std::filesystem::path file = folder / (name + ".png");
    std::error_code code;
    for (int n = 2; std::filesystem::exists(file, code); ++n) {
        file = folder / fmt::format("{}-{}.png", name, n);
    }
    return file;
}

void FrameLoop::apply_preferences() {
    const ui::WindowPreferences& wanted = station_.preferences().preferences;
    if (wanted.theme != applied_.theme) window_.set_theme(wanted.theme);
    if (wanted.user_scale != applied_.user_scale) {
        window_.set_user_scale(static_cast<float>(wanted.user_scale));
    }
    window_.set_large_buttons(wanted.large_buttons);
    applied_ = wanted;
}

void FrameLoop::take_picture(const std::filesystem::path& file,
                             const std::optional<ui::Rect>& part) {
    // Taken in this frame, after it was drawn.
    window_.capture_next([this, file, part](int width_px, int height_px,
                                            std::vector<std::uint8_t> rgba) {
        ui::Rect kept = part.value_or(ui::Rect{0, 0, width_px, height_px});
        rgba = ui::cropped_rgba(rgba, width_px, height_px, kept);
        if (Status s = save_png(file, kept.width, kept.height, rgba); !s) {
            picture_trouble_ = s.error().message;
            station_.toast(ui::LogLevel::kError, "toast.picture", "No picture", s.error().message);
            return;
        }
        if (options_.script.empty() || part) {
            station_.toast(ui::LogLevel::kInformation, "toast.picture", "Picture written",
                           file.string());
        }
    });
}

std::optional<std::string> FrameLoop::trouble() const {
    if (player_ && player_->trouble()) return player_->trouble();
    return picture_trouble_;
}

Result<ui::ScriptPlayer> guided_tour() {
    constexpr std::string_view kTour = "assets/tours/simulated-cell.txt";
    const auto text = ui::read_resource(kTour);
    if (!text) return forward_error(text.error());
    auto steps = ui::parse_script(*text, std::string(kTour));
    if (!steps) return forward_error(steps.error());
    return ui::ScriptPlayer(std::move(*steps));
}

}  // namespace gripscan::app
