// What came in from mouse and keyboard, in order, handed out so that each frame can see all of it.
// A key that goes down and up while a slow frame is drawn would else be seen as never pressed, and
// a click where the mouse has gone since.
#pragma once

#include <deque>
#include <variant>
#include <vector>

namespace gripscan::ui {

namespace input {
// As GLFW tells them.
struct Cursor {
    double x = 0.0, y = 0.0;
};
struct Entered {
    bool inside = false;
};
struct Focus {
    bool focused = false;
};
struct Button {
    int button = 0;
    bool down = false;
};
struct Wheel {
    double dx = 0.0, dy = 0.0;
};
struct Key {
    int key = 0, scancode = 0, mods = 0;
    bool down = false;
};
struct Typed {
    unsigned character = 0;
};
}  // namespace input

using InputEvent = std::variant<input::Cursor, input::Entered, input::Focus, input::Button,
                                input::Wheel, input::Key, input::Typed>;

class InputQueue {
  public:
    void push(const InputEvent& event) { waiting_.push_back(event); }
    [[nodiscard]] bool empty() const { return waiting_.empty(); }
    /// What belongs to the next frame: in it no key or button changes twice, nothing is pressed at
    /// two places, and what is typed comes after the keys and clicks that were before it.
    [[nodiscard]] std::vector<InputEvent> take_frame();

  private:
    std::deque<InputEvent> waiting_;
    int commanding_ = 0;  ///< Ctrl, Alt and Super keys that are down
};

}  // namespace gripscan::ui
