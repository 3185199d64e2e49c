#include "ui/shell/script_player.h"

#include <fmt/format.h>
#include <imgui.h>

namespace gripscan::ui {
namespace {

/// As the backend numbers it.
int number_of(const KeyStroke& stroke) {
    return stroke.named ? ImGui::GetIO().KeyMap[*stroke.named] : stroke.number;
}

/// The control that a step needs; empty: none.
std::string control_of(const ScriptStep& step) {
    if (const auto* click = std::get_if<script::Click>(&step)) return click->id;
    if (const auto* menu = std::get_if<script::RightClick>(&step)) return menu->id;
    if (const auto* wait = std::get_if<script::WaitFor>(&step)) return wait->id;
    if (const auto* drag = std::get_if<script::Drag>(&step)) return drag->id;
    return {};
}

}  // namespace

ScriptPlayer::ScriptPlayer(std::vector<ScriptStep> steps, double patience_s)
    : steps_(std::make_move_iterator(steps.begin()), std::make_move_iterator(steps.end())),
      patience_s_(patience_s) {}

void ScriptPlayer::set_mouse() const {
    if (x_ >= 0.0F) ImGui::GetIO().MousePos = ImVec2(x_, y_);
}

/// Turns a step into input; false: not yet.
struct ScriptPlayer::Play {
    ScriptPlayer& self;
    const WidgetLog& shown;
    double now_s;

    [[nodiscard]] std::optional<Rect> ready(const std::string& id) const {
        const auto record = shown.find(id);
        if (!record || !record->enabled) return std::nullopt;
        return record->rect;
    }
    [[nodiscard]] bool press(const std::string& id, int button) const {
        const auto rect = ready(id);
        if (!rect) return false;
        const auto x = static_cast<float>(rect->x + rect->width / 2);
        const auto y = static_cast<float>(rect->y + rect->height / 2);
        auto& pending = self.pending_;
        ScriptPlayer* player = &self;
        pending.emplace_back([player, x, y] { player->x_ = x, player->y_ = y; });
        pending.emplace_back([] {});
        pending.emplace_back([button] { ImGui::GetIO().MouseDown[button] = true; });
        pending.emplace_back([button] { ImGui::GetIO().MouseDown[button] = false; });
        // What it asked for shows in the frame after.
        pending.emplace_back([] {});
        pending.emplace_back([] {});
        return true;
    }

    bool operator()(const script::Click& s) const { return press(s.id, ImGuiMouseButton_Left); }
    bool operator()(const script::RightClick& s) const {
        return press(s.id, ImGuiMouseButton_Right);
    }
    bool operator()(const script::WaitFor& s) const { return ready(s.id).has_value(); }
    bool operator()(const script::Key& s) const {
        const auto set = [stroke = s.stroke](bool down) {
            ImGuiIO& io = ImGui::GetIO();
            io.KeyCtrl = stroke.control && down;
            io.KeysDown[number_of(stroke)] = down;
            if (down && !stroke.control && stroke.typed != 0) io.AddInputCharacter(stroke.typed);
        };
        self.pending_.emplace_back([set] { set(true); });
        self.pending_.emplace_back([set] { set(false); });
        self.pending_.emplace_back([] {});
        self.pending_.emplace_back([] {});
        return true;
    }
    bool operator()(const script::Type& s) const {
        self.pending_.emplace_back(
            [text = s.text] { ImGui::GetIO().AddInputCharactersUTF8(text.c_str()); });
        return true;
    }
    bool operator()(const script::Drag& s) const {
        const auto rect = ready(s.id);
        if (!rect) return false;
        if (!press(s.id, ImGuiMouseButton_Left)) return false;
        for (int i = 0; i < 3; ++i) self.pending_.pop_back();
        constexpr int kFrames = 12;
        ScriptPlayer* player = &self;
        for (int i = 1; i <= kFrames; ++i) {
            self.pending_.emplace_back([player, s] {
                player->x_ += s.dx_px / kFrames;
                player->y_ += s.dy_px / kFrames;
                ImGui::GetIO().MouseDown[ImGuiMouseButton_Left] = true;
            });
        }
        self.pending_.emplace_back([] { ImGui::GetIO().MouseDown[ImGuiMouseButton_Left] = false; });
        return true;
    }
    bool operator()(const script::Pause& s) const {
        if (!self.pause_until_s_) self.pause_until_s_ = now_s + s.seconds;
        if (now_s < *self.pause_until_s_) return false;
        self.pause_until_s_.reset();
        return true;
    }
    bool operator()(const script::Picture& s) const {
        self.picture_ = s.file;
        return true;
    }
    bool operator()(const script::Say& s) const {
        self.caption_ = s.text;
        return true;
    }
};

void ScriptPlayer::before_frame(const WidgetLog& shown, double now_s) {
    set_mouse();
    if (!pending_.empty()) {
        pending_.front()();
        pending_.pop_front();
        set_mouse();
        return;
    }
    if (steps_.empty() || trouble_) return;
    if (std::visit(Play{*this, shown, now_s}, steps_.front())) {
        steps_.pop_front();
        waiting_since_s_.reset();
        return;
    }
    if (!waiting_since_s_) waiting_since_s_ = now_s;
    const bool pausing = std::holds_alternative<script::Pause>(steps_.front());
    const auto* wait = std::get_if<script::WaitFor>(&steps_.front());
    const double patience_s =
        wait != nullptr ? wait->patience_s.value_or(patience_s_) : patience_s_;
    if (pausing || trouble_ || now_s - *waiting_since_s_ < patience_s) return;
    const std::string id = control_of(steps_.front());
    const auto record = shown.find(id);
    trouble_ = record ? fmt::format("'{}' stayed disabled: {}", id, record->reason)
                      : fmt::format("'{}' was not shown within {:.0f} s", id, patience_s);
}

std::optional<std::filesystem::path> ScriptPlayer::picture_wanted() {
    return std::exchange(picture_, std::nullopt);
}

}  // namespace gripscan::ui
