// Plays a script in the window: before each frame it sets mouse and keys as a user would.
#pragma once

#include <deque>
#include <functional>
#include <optional>

#include "ui/shell/script.h"
#include "ui/widgets/widget_log.h"

namespace gripscan::ui {

class ScriptPlayer {
  public:
    explicit ScriptPlayer(std::vector<ScriptStep> steps, double patience_s = 120.0);

    /// Called before each frame with the controls of the one before. Sets Dear ImGui's input.
    void before_frame(const WidgetLog& shown, double now_s);
    /// The picture that is to be taken of the coming frame.
    [[nodiscard]] std::optional<std::filesystem::path> picture_wanted();

    [[nodiscard]] const std::string& caption() const { return caption_; }
    [[nodiscard]] bool ended() const { return steps_.empty() && pending_.empty(); }
    /// Why it could not go on: a control that did not come within the patience.
    [[nodiscard]] const std::optional<std::string>& trouble() const { return trouble_; }

  private:
    struct Play;
    /// One frame's worth of input.
    using Input = std::function<void()>;
    void set_mouse() const;

    std::deque<ScriptStep> steps_;
    std::deque<Input> pending_;  ///< one a frame
    double patience_s_;
    std::optional<double> waiting_since_s_;
    std::optional<double> pause_until_s_;
    std::optional<std::filesystem::path> picture_;
    std::optional<std::string> trouble_;
    std::string caption_;
    float x_ = -1.0F;
    float y_ = -1.0F;
};

}  // namespace gripscan::ui
