#include "core/session/journal_line.h"

#include <nlohmann/json.hpp>

#include "core/base/checksum.h"

namespace gripscan {
namespace {
using Json = nlohmann::ordered_json;

constexpr auto kReplaceBadUtf8 = Json::error_handler_t::replace;

std::string text_of(const Json& json) {
    return json.dump(-1, ' ', false, kReplaceBadUtf8);
}

bool has_text(const Json& json, const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_string();
}

}  // namespace

std::string journal_line(const JournalEntry& entry) {
    Json json{{"n", entry.number}, {"t", entry.time}, {"event", entry.event}};
    for (const auto& [name, value] : entry.fields) json["data"][name] = value;
    json["check"] = checksum_text(text_of(json));
    return text_of(json) + "\n";
}

std::optional<JournalEntry> parse_journal_line(const std::string& line) {
    Json json = Json::parse(line, nullptr, false);
    if (!json.is_object() || !has_text(json, "check")) return std::nullopt;
    const std::string check = json["check"];
    json.erase("check");
    if (check != checksum_text(text_of(json))) return std::nullopt;
    if (!has_text(json, "t") || !has_text(json, "event") || !json.contains("n") ||
        !json["n"].is_number_integer()) {
        return std::nullopt;
    }
    JournalEntry entry{json["n"], json["t"], json["event"], {}};
    const auto data = json.find("data");
    if (data == json.end()) return entry;
    if (!data->is_object()) return std::nullopt;
    for (const auto& [name, value] : data->items()) {
        if (!value.is_string()) return std::nullopt;
        entry.fields.emplace_back(name, value.get<std::string>());
    }
    return entry;
}

}  // namespace gripscan
