#include "core/cloud/ply_rows.h"

namespace gripscan {

Status PlyTextRows::begin_row() {
    const auto line_text = lines_.next_with_content();
    if (!line_text) return input_error("the file is cut off after line {}", line());
    split_words(*line_text, kBlanks, words_);
    next_word_ = 0;
    return {};
}

Result<double> PlyTextRows::number(NumberType /*type*/) {
    if (next_word_ == words_.size()) {
        return input_error("line {}: {} numbers are too few", line(), words_.size());
    }
    const std::string_view word = words_[next_word_++];
    const auto value = value_from_word(word);
    if (!value) return input_error("line {}: '{}' is no number", line(), word.substr(0, 40));
    return *value;
}

Status PlyTextRows::end_row() {
    if (next_word_ == words_.size()) return {};
    return input_error("line {}: {} numbers instead of {}", line(), words_.size(), next_word_);
}

Status PlyTextRows::end_of_body() {
    if (!lines_.next_with_content()) return {};
    return input_error("line {}: more entries than the head says", line());
}

Result<double> PlyBinaryRows::number(NumberType type) {
    const std::size_t size = size_of(type);
    if (body_.size() < size) {
        return input_error("the file is cut off: its {} bytes of entries are too few", whole_size_);
    }
    const double value = number_at(body_.data(), type, order_);
    body_.remove_prefix(size);
    return value;
}

Status PlyBinaryRows::end_of_body() {
    if (body_.find_first_not_of("\r\n") == std::string_view::npos) return {};
    return input_error("{} bytes follow the last entry of the head", body_.size());
}

}  // namespace gripscan
