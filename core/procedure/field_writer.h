// Values to named fields. What a type consists of is said once, in `fields(io, value)`, for this
// and for FieldReader.
#pragma once

#include "core/procedure/field_path.h"
#include "core/procedure/field_text.h"
#include "core/procedure/journal.h"

namespace gripscan {

/// An absent optional is no field; a list is its length and its items, counted from 1.
class FieldWriter {
  public:
    template <typename T>
    void operator()(std::string_view name, const T& value) {
        if constexpr (kIsOptional<T>) {
            if (value) (*this)(name, *value);
        } else if constexpr (kIsList<T>) {
            (*this)(name, value.size());
            path_.within(name, [&] {
                for (std::size_t i = 0; i < value.size(); ++i) {
                    (*this)(std::to_string(i + 1), value[i]);
                }
            });
        } else if constexpr (requires { field_text(value); }) {
            fields_.emplace_back(path_.full_name(name), field_text(value));
        } else {
            path_.within(name, [&] { fields(*this, value); });
        }
    }

    [[nodiscard]] JournalFields take() { return std::move(fields_); }

  private:
    FieldPath path_;
    JournalFields fields_;
};

}  // namespace gripscan
