// Named fields back to values. The first error sticks: `fields(io, value)` goes through all of
// them, and `error()` is asked for once at the end.
#pragma once

#include "core/procedure/field_path.h"
#include "core/procedure/field_text.h"
#include "core/procedure/journal.h"

namespace gripscan {

/// Fields that nobody asks for are ignored: a later version may have added them.
class FieldReader {
  public:
    /// `fields` must outlive the reader.
    explicit FieldReader(const JournalFields& fields) : fields_(fields) {}

    template <typename T>
    void operator()(std::string_view name, T& value) {
        if constexpr (kIsOptional<T>) {
            value.reset();
            if (has(name)) (*this)(name, value.emplace());
        } else if constexpr (kIsList<T>) {
            read_list(name, value);
        } else if constexpr (requires(const std::string& text) { read_field(text, value); }) {
            const std::string* text = find(name);
            if (text == nullptr) return fail_missing(name);
            if (const Wanted wanted = read_field(*text, value)) fail(name, *wanted, *text);
        } else {
            path_.within(name, [&] { fields(*this, value); });
        }
    }

    /// "'items.2.limit' must be a finite number, not \"x\""; nothing: all was there.
    [[nodiscard]] const std::optional<std::string>& error() const { return error_; }

    /// Keeps an error unless there is one.
    void fail(std::string_view name, std::string_view wanted, std::string_view found);

  private:
    template <typename T>
    void read_list(std::string_view name, std::vector<T>& list) {
        std::size_t count = 0;
        (*this)(name, count);
        list.clear();
        path_.within(name, [&] {
            for (std::size_t i = 0; i < count && !error_; ++i) {
                (*this)(std::to_string(i + 1), list.emplace_back());
            }
        });
    }

    /// The field, or a part of it, is there.
    [[nodiscard]] bool has(std::string_view name) const;
    [[nodiscard]] const std::string* find(std::string_view name) const;
    void fail_missing(std::string_view name);

    const JournalFields& fields_;
    FieldPath path_;
    std::optional<std::string> error_;
};

}  // namespace gripscan
