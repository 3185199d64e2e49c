// The program's window as a user sees it from outside: mouse and keys by xdotool, and where the
// controls are by the list that the window keeps for those who drive it.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tests/support/virtual_screen.h"

namespace gripscan::test {

class OutsideDriver {
  public:
    /// Starts the program with these arguments; its user's files lie in `home`.
    OutsideDriver(const std::filesystem::path& home, const std::vector<std::string>& arguments);
    /// Kills it if it is still there.
    ~OutsideDriver();
    OutsideDriver(const OutsideDriver&) = delete;
    OutsideDriver& operator=(const OutsideDriver&) = delete;

    struct Control {
        std::string label;
        int x = 0, y = 0;  ///< its middle
        bool enabled = false;
        std::string reason;
        bool has_keyboard = false;
    };
    [[nodiscard]] std::optional<Control> find(const std::string& id) const;
    /// Waits until it is there and enabled; false: it did not come.
    [[nodiscard]] bool wait_for(const std::string& id, double patience_s = 120.0) const;
    /// Waits until one of them is there and enabled: its name.
    [[nodiscard]] std::optional<std::string> first_of(const std::vector<std::string>& ids,
                                                      double patience_s = 120.0) const;
    /// Waits for it, then presses it.
    [[nodiscard]] bool click(const std::string& id, double patience_s = 120.0) const;
    /// The same for one that begins something: returns once it cannot be pressed any more.
    [[nodiscard]] bool begin(const std::string& id, double patience_s = 120.0) const;
    /// Waits until it cannot be pressed any more: what was asked for is going on.
    [[nodiscard]] bool taken(const std::string& id) const;
    /// Presses an input and puts this text in the place of what stands there.
    [[nodiscard]] bool enter(const std::string& id, const std::string& text) const;
    [[nodiscard]] bool wait_for_file(const std::filesystem::path& file) const;
    [[nodiscard]] bool right_click(const std::string& id, double patience_s = 120.0) const;
    /// As xdotool names it: "space", "Escape", "ctrl+z".
    void key(const std::string& name) const;
    void type(const std::string& text) const;

    void kill_now();
    /// Waits for the end; the exit status, 128 + signal if it was killed.
    [[nodiscard]] int wait_for_end(double patience_s = 60.0);
    [[nodiscard]] bool running() const;
    /// What it wrote to standard error, and what the step card shows.
    [[nodiscard]] std::string error_text() const;

  private:
    [[nodiscard]] bool press(const std::string& id, int button, double patience_s) const;
    [[nodiscard]] nlohmann::json controls() const;

    std::unique_ptr<VirtualScreen> screen_;
    std::filesystem::path home_;
    mutable pid_t program_ = -1;
    mutable std::optional<int> status_;
};

}  // namespace gripscan::test
