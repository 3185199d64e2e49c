#include "ui/theme/theme.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "ui/resources/resource_file.h"

namespace gripscan::ui {
namespace {

constexpr ThemeToken kTokens[] = {
    {"text", &Theme::text},
    {"text.second", &Theme::text_second},
    {"text.third", &Theme::text_third},
    {"accent", &Theme::accent},
    {"accent.on", &Theme::accent_on},
    {"accent.text", &Theme::accent_text},
    {"accent.bg", &Theme::accent_bg},
    {"ok", &Theme::ok},
    {"ok.bg", &Theme::ok_bg},
    {"check", &Theme::check},
    {"check.bg", &Theme::check_bg},
    {"reject", &Theme::reject},
    {"reject.bg", &Theme::reject_bg},
    {"live", &Theme::live},
    {"live.on", &Theme::live_on},
    {"sim", &Theme::sim},
    {"sim.bg", &Theme::sim_bg},
    {"axis", &Theme::axis},
    {"gripper", &Theme::gripper},
    {"object", &Theme::object},
    {"axis.x", &Theme::axis_x},
    {"axis.y", &Theme::axis_y},
    {"axis.z", &Theme::axis_z},
    {"target", &Theme::target},
    {"source", &Theme::source},
    {"target.safe", &Theme::target_safe},
    {"source.safe", &Theme::source_safe},
    {"bg0", &Theme::bg0},
    {"input", &Theme::input},
    {"panel", &Theme::panel},
    {"raised", &Theme::raised},
    {"hover", &Theme::hover},
    {"select", &Theme::select},
    {"line", &Theme::line},
    {"line2", &Theme::line2},
    {"edge", &Theme::edge},
    {"view.top", &Theme::view_top},
    {"view.bottom", &Theme::view_bottom},
    {"plate", &Theme::plate},
    {"plate.text", &Theme::plate_text},
    {"too_few", &Theme::too_few},
};

Status read_colours(const nlohmann::json& colours, std::string_view file, Theme& theme) {
    for (const ThemeToken& token : kTokens) {
        const auto found = colours.find(token.name);
        if (found == colours.end()) {
            return input_error("{}: the colour '{}' is missing", file, token.name);
        }
        const auto colour = found->is_string() ? colour_from_text(found->get<std::string>())
                                               : std::optional<Colour>();
        if (!colour) {
            return input_error("{}: the colour '{}' is {}; write it as \"#RRGGBB\"", file,
                               token.name, found->dump());
        }
        theme.*token.colour = *colour;
    }
    for (const auto& [name, value] : colours.items()) {
        const bool known = std::any_of(std::begin(kTokens), std::end(kTokens),
                                       [&n = name](const auto& t) { return t.name == n; });
        if (!known) return input_error("{}: nothing in the window has the colour '{}'", file, name);
    }
    return {};
}

}  // namespace

std::span<const ThemeToken> theme_tokens() {
    return kTokens;
}

Result<Theme> theme_from_json(std::string_view text, std::string_view file) {
    const auto json = nlohmann::json::parse(text, nullptr, false);
    if (json.is_discarded() || !json.is_object()) {
        return input_error("{} is no theme: it is not a JSON object", file);
    }
    if (json.value("format", nlohmann::json()) != "gripscan-theme/1") {
        return input_error(
            "{} is no theme this version reads; its format must be "
            "gripscan-theme/1",
            file);
    }
    const auto name = json.find("name");
    const auto dark = json.find("dark");
    const auto colours = json.find("colours");
    if (name == json.end() || !name->is_string() || dark == json.end() || !dark->is_boolean() ||
        colours == json.end() || !colours->is_object()) {
        return input_error("{}: a theme has a name (text), dark (true or false) and colours", file);
    }
    Theme theme;
    theme.name = name->get<std::string>();
    theme.dark = dark->get<bool>();
    if (auto read = read_colours(*colours, file, theme); !read) return forward_error(read.error());
    return theme;
}

Result<Theme> load_theme(ThemeChoice choice) {
    const std::string file =
        choice == ThemeChoice::kDark ? "assets/themes/dark.json" : "assets/themes/light.json";
    const auto text = read_resource(file);
    if (!text) return forward_error(text.error());
    return theme_from_json(*text, file);
}

}  // namespace gripscan::ui
