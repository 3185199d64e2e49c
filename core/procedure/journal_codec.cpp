#include "core/procedure/journal_codec.h"

#include <algorithm>

#include "core/procedure/field_reader.h"
#include "core/procedure/field_writer.h"
#include "core/procedure/input_fields.h"
#include "core/procedure/input_words.h"

namespace gripscan {
namespace {

constexpr std::string_view kCommand = "command";
constexpr std::string_view kEvent = "event";
constexpr std::string_view kPlan = "plan";
/// The field that says which command or event it is.
constexpr std::string_view kName = "name";

/// The alternative number `index`, with its defaults.
template <typename Variant>
Variant alternative(std::size_t index) {
    Variant value;
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        ((I == index ? static_cast<void>(value.template emplace<I>()) : void()), ...);
    }
    (std::make_index_sequence<std::variant_size_v<Variant>>{});
    return value;
}

template <typename Variant>
JournalRecord encode_variant(std::string_view kind, const Variant& variant) {
    FieldWriter io;
    io(kName, std::string(word(variant)));
    std::visit([&](const auto& value) { fields(io, value); }, variant);
    return {std::string(kind), io.take()};
}

template <typename Variant>
Result<std::optional<Input>> decode_variant(std::string_view kind, const JournalFields& entry) {
    FieldReader io(entry);
    std::string name;
    io(kName, name);
    const auto& words = input_words<Variant>();
    const auto known = std::find(words.begin(), words.end(), name);
    if (known == words.end()) io.fail(kName, "a word of this version", name);
    if (io.error()) return input_error("the journal holds a bad {}: {}", kind, *io.error());
    auto variant = alternative<Variant>(static_cast<std::size_t>(known - words.begin()));
    std::visit([&](auto& value) { fields(io, value); }, variant);
    if (io.error()) {
        return input_error("the journal holds a bad {} '{}': {}", kind, name, *io.error());
    }
    return Input(std::move(variant));
}

}  // namespace

JournalRecord encode(const Input& input) {
    if (const auto* command = std::get_if<Command>(&input)) {
        return encode_variant(kCommand, *command);
    }
    return encode_variant(kEvent, std::get<Event>(input));
}

Result<std::optional<Input>> decode_input(std::string_view event, const JournalFields& entry) {
    if (event == kCommand) return decode_variant<Command>(kCommand, entry);
    if (event == kEvent) return decode_variant<Event>(kEvent, entry);
    return std::optional<Input>();
}

JournalRecord encode(const TurnPlan& plan) {
    FieldWriter io;
    fields(io, plan);
    return {std::string(kPlan), io.take()};
}

Result<TurnPlan> decode_plan(const JournalFields& entry) {
    FieldReader io(entry);
    TurnPlan plan;
    fields(io, plan);
    if (io.error()) return input_error("the journal holds a bad plan: {}", *io.error());
    return plan;
}

}  // namespace gripscan
