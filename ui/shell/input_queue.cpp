#include "ui/shell/input_queue.h"

#include <algorithm>
#include <array>

namespace gripscan::ui {
namespace {

// Of GLFW: printable keys lie below the others, modifiers in one row.
constexpr int kFirstNamedKey = 256;
constexpr int kFirstModifier = 340;
constexpr int kLastModifier = 347;
constexpr std::array kShifts{340, 344};

bool is_modifier(int key) {
    return key >= kFirstModifier && key <= kLastModifier;
}
bool commands(int key) {
    return is_modifier(key) && !std::ranges::count(kShifts, key);
}

/// What the frame holds so far.
class FrameSoFar {
  public:
    explicit FrameSoFar(int& commanding) : commanding_(commanding) {}

    [[nodiscard]] bool takes(const InputEvent& event) const {
        return std::visit(Takes{*this}, event);
    }

    void add(const InputEvent& event) {
        if (const auto* button = std::get_if<input::Button>(&event)) {
            buttons_.push_back(button->button);
        } else if (std::holds_alternative<input::Typed>(event)) {
            typed_ = true;
        } else if (const auto* key = std::get_if<input::Key>(&event)) {
            keys_.push_back(key->key);
            if (commands(key->key)) commanding_ = std::max(0, commanding_ + (key->down ? 1 : -1));
            if (!key->down || is_modifier(key->key)) return;
            (is_command(key->key) ? command_pressed_ : letter_pressed_) = true;
        }
    }

  private:
    /// Does something by itself, instead of typing.
    [[nodiscard]] bool is_command(int key) const {
        return key >= kFirstNamedKey || commanding_ > 0;
    }

    struct Takes {
        const FrameSoFar& f;
        bool operator()(const input::Cursor&) const { return f.buttons_.empty(); }
        bool operator()(const input::Entered&) const { return f.buttons_.empty(); }
        bool operator()(const input::Wheel&) const { return f.buttons_.empty(); }
        bool operator()(const input::Focus&) const { return true; }
        bool operator()(const input::Button& e) const {
            const bool keys = f.command_pressed_ || f.letter_pressed_ || f.typed_;
            return !keys && std::ranges::count(f.buttons_, e.button) == 0;
        }
        bool operator()(const input::Typed&) const {
            return f.buttons_.empty() && !f.command_pressed_;
        }
        bool operator()(const input::Key& e) const {
            if (!f.buttons_.empty() || std::ranges::count(f.keys_, e.key) > 0) return false;
            const bool pressed = f.command_pressed_ || f.letter_pressed_ || f.typed_;
            if (is_modifier(e.key)) return !pressed;
            if (!e.down) return true;
            return f.is_command(e.key) ? !pressed : !f.command_pressed_;
        }
    };

    int& commanding_;
    std::vector<int> buttons_;  ///< that have changed
    std::vector<int> keys_;     ///< that have changed
    bool command_pressed_ = false;
    bool letter_pressed_ = false;
    bool typed_ = false;
};

}  // namespace

std::vector<InputEvent> InputQueue::take_frame() {
    std::vector<InputEvent> taken;
    FrameSoFar frame(commanding_);
    while (!waiting_.empty() && frame.takes(waiting_.front())) {
        frame.add(waiting_.front());
        taken.push_back(waiting_.front());
        waiting_.pop_front();
    }
    return taken;
}

}  // namespace gripscan::ui
