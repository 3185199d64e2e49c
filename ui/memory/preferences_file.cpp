#include "ui/memory/preferences_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "ui/memory/user_folder.h"

namespace gripscan::ui {
namespace {
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view kFormat = "gripscan-preferences/1";
constexpr std::array<std::string_view, 3> kNavigations{"gripscan", "CAD", "RViz"};
constexpr std::size_t kMostKeys = 200;
constexpr std::size_t kLongestName = 60;

/// Takes values out of the object; what is left over in the end is unknown.
class Reader {
  public:
    Reader(fs::path file, Json json, std::vector<std::string>& refused)
        : file_(std::move(file)), json_(std::move(json)), refused_(refused) {}

    /// `take` returns whether the value makes sense and was taken.
    template <typename Take>
    void value(const std::string& name, std::string_view wanted, const Take& take) {
        if (!json_.contains(name)) return;
        if (!take(json_[name])) refuse(name, fmt::format("{}", wanted));
        json_.erase(name);
    }
    void number(const std::string& name, double least, double most, const auto& set) {
        value(name, fmt::format("a number from {} to {}", least, most), [&](const Json& json) {
            if (!json.is_number()) return false;
            const auto number = json.get<double>();
            if (!std::isfinite(number) || number < least || number > most) return false;
            set(number);
            return true;
        });
    }
    void refuse_rest() {
        for (const auto& [name, value] : json_.items()) {
            refused_.push_back(fmt::format("{}: {} is not known and was left aside", file_.string(),
                                           name.substr(0, kLongestName)));
        }
    }

  private:
    void refuse(const std::string& name, const std::string& wanted) {
        refused_.push_back(fmt::format("{}: {} is {}, wanted is {}; the default is used",
                                       file_.string(), name,
                                       json_[name]
                                           .dump(-1, ' ', false, Json::error_handler_t::replace)
                                           .substr(0, kLongestName),
                                       wanted));
    }
    fs::path file_;
    Json json_;
    std::vector<std::string>& refused_;
};

bool take_theme(const Json& json, ThemeChoice& theme) {
    if (json != "dark" && json != "light") return false;
    theme = json == "dark" ? ThemeChoice::kDark : ThemeChoice::kLight;
    return true;
}

bool take_keys(const Json& json, std::vector<std::pair<std::string, std::string>>& keys) {
    if (!json.is_object() || json.size() > kMostKeys) return false;
    std::vector<std::pair<std::string, std::string>> read;
    for (const auto& [action, key] : json.items()) {
        if (!key.is_string() || action.empty() || action.size() > kLongestName) return false;
        const auto text = key.get<std::string>();
        if (text.empty() || text.size() > kLongestName) return false;
        read.emplace_back(action, text);
    }
    keys = std::move(read);
    return true;
}

void take_all(Reader& reader, StoredPreferences& stored) {
    WindowPreferences& wanted = stored.preferences;
    Splits& splits = stored.splits;
    reader.value("theme", "\"dark\" or \"light\"",
                 [&](const Json& json) { return take_theme(json, wanted.theme); });
    reader.number("user_scale", 0.5, 4.0, [&](double v) { wanted.user_scale = v; });
    reader.value("large_buttons", "true or false", [&](const Json& json) {
        if (!json.is_boolean()) return false;
        wanted.large_buttons = json.get<bool>();
        return true;
    });
    reader.value("navigation", "\"gripscan\", \"CAD\" or \"RViz\"", [&](const Json& json) {
        const auto* found = std::find(kNavigations.begin(), kNavigations.end(),
                                      json.is_string() ? json.get<std::string>() : std::string());
        if (found == kNavigations.end()) return false;
        wanted.navigation = *found;
        return true;
    });
    reader.value("keys", "an object of actions with their keys",
                 [&](const Json& json) { return take_keys(json, wanted.keys); });
    constexpr double kWidest = 10000.0;
    const auto length = [&](const char* name, float Splits::*field) {
        reader.number(name, 1.0, kWidest, [&](double v) { splits.*field = static_cast<float>(v); });
    };
    length("stereo_width_px", &Splits::stereo_width);
    length("right_width_px", &Splits::right_width);
    length("bottom_height_px", &Splits::bottom_height);
}

}  // namespace

std::optional<fs::path> config_folder() {
    return user_folder("XDG_CONFIG_HOME", ".config");
}

LoadedPreferences load_preferences(const fs::path& file) {
    LoadedPreferences loaded;
    std::error_code code;
    if (!fs::exists(file, code)) return loaded;
    const auto text = read_whole_file(file);
    if (!text) {
        loaded.refused.push_back(text.error().message);
        return loaded;
    }
    Json json = Json::parse(*text, nullptr, false);
    if (!json.is_object() || !json.contains("format") || json["format"] != kFormat) {
        loaded.refused.push_back(
            fmt::format("{}: no preferences of this version ({}); the defaults are used",
                        file.string(), kFormat));
        return loaded;
    }
    json.erase("format");
    Reader reader(file, std::move(json), loaded.refused);
    take_all(reader, loaded.stored);
    reader.refuse_rest();
    return loaded;
}

Status save_preferences(const fs::path& file, const StoredPreferences& stored) {
    const WindowPreferences& wanted = stored.preferences;
    Json keys = Json::object();
    for (const auto& [action, key] : wanted.keys) keys[action] = key;
    const Json json{{"format", kFormat},
                    {"theme", wanted.theme == ThemeChoice::kDark ? "dark" : "light"},
                    {"user_scale", wanted.user_scale},
                    {"large_buttons", wanted.large_buttons},
                    {"navigation", wanted.navigation},
                    {"keys", keys},
                    {"stereo_width_px", stored.splits.stereo_width},
                    {"right_width_px", stored.splits.right_width},
                    {"bottom_height_px", stored.splits.bottom_height}};
    std::error_code code;
    std::filesystem::create_directories(file.parent_path(), code);
    if (code) return input_error("{}: {}", file.parent_path().string(), code.message());
    return write_file_atomically(file,
                                 json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace gripscan::ui
