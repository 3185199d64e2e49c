#include "ui/shell/script.h"

#include <map>
#include <sstream>

namespace gripscan::ui {
namespace {

/// What stands after the first word.
struct Rest {
    std::string text;
    std::istringstream words{text};
};

using Maker = bool (*)(Rest&, ScriptStep&);

template <typename T, std::string T::*member>
bool of_text(Rest& rest, ScriptStep& step) {
    T made;
    made.*member = rest.text;
    step = made;
    return !rest.text.empty();
}

bool a_key(Rest& rest, ScriptStep& step) {
    const auto stroke = key_stroke(rest.text);
    if (stroke) step = script::Key{*stroke};
    return stroke.has_value();
}

bool a_wait(Rest& rest, ScriptStep& step) {
    script::WaitFor wait;
    if (!(rest.words >> wait.id)) return false;
    if (double patience_s = 0.0; rest.words >> patience_s) wait.patience_s = patience_s;
    step = wait;
    return rest.words.eof() && wait.patience_s.value_or(0.0) >= 0.0;
}

bool a_say(Rest& rest, ScriptStep& step) {
    step = script::Say{rest.text};
    return true;
}

bool a_pause(Rest& rest, ScriptStep& step) {
    script::Pause pause;
    const bool read = static_cast<bool>(rest.words >> pause.seconds) && pause.seconds >= 0.0;
    step = pause;
    return read;
}

bool a_drag(Rest& rest, ScriptStep& step) {
    script::Drag drag;
    const bool read = static_cast<bool>(rest.words >> drag.id >> drag.dx_px >> drag.dy_px);
    step = drag;
    return read;
}

bool a_picture(Rest& rest, ScriptStep& step) {
    step = script::Picture{rest.text};
    return !rest.text.empty();
}

const std::map<std::string, Maker>& makers() {
    static const std::map<std::string, Maker> kMakers{
        {"click", of_text<script::Click, &script::Click::id>},
        {"menu", of_text<script::RightClick, &script::RightClick::id>},
        {"key", a_key},
        {"type", of_text<script::Type, &script::Type::text>},
        {"wait", a_wait},
        {"say", a_say},
        {"pause", a_pause},
        {"drag", a_drag},
        {"picture", a_picture}};
    return kMakers;
}

}  // namespace

Result<std::vector<ScriptStep>> parse_script(const std::string& text, const std::string& file) {
    std::vector<ScriptStep> steps;
    std::istringstream lines(text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        const auto begin = line.find_first_not_of(" \t\r");
        if (begin == std::string::npos || line[begin] == '#') continue;
        const auto end = line.find_last_not_of(" \t\r") + 1;
        const std::string whole = line.substr(begin, end - begin);
        const auto blank = whole.find(' ');
        const std::string word = whole.substr(0, blank);
        const auto maker = makers().find(word);
        if (maker == makers().end()) {
            return input_error(
                "{}:{}: '{}' is no step of a script; steps are click, menu, key, "
                "type, drag, pause, wait, picture, say",
                file, number, word);
        }
        Rest rest{blank == std::string::npos ? "" : whole.substr(blank + 1)};
        ScriptStep step;
        if (!maker->second(rest, step)) {
            return input_error("{}:{}: '{}' makes no sense: see the steps in the manual", file,
                               number, whole);
        }
        steps.push_back(std::move(step));
    }
    return steps;
}

}  // namespace gripscan::ui
