// The entries of a PLY body one after the other, whether they are lines of text or bytes. Both
// readers have the same three functions; a problem is returned as a message, never skipped.
#pragma once

#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/cloud/ply_header.h"
#include "core/cloud/text_scan.h"

namespace gripscan {

/// One entry a line.
class PlyTextRows {
  public:
    PlyTextRows(std::string_view body, std::size_t first_line)
        : lines_(body), first_line_(first_line) {}

    Status begin_row();
    Result<double> number(NumberType type);
    Status end_row();
    /// Nothing but blanks may follow.
    Status end_of_body();

  private:
    [[nodiscard]] std::size_t line() const { return first_line_ + lines_.line_number() - 1; }

    LineScanner lines_;
    std::size_t first_line_;
    std::vector<std::string_view> words_;
    std::size_t next_word_ = 0;
};

class PlyBinaryRows {
  public:
    PlyBinaryRows(std::string_view body, ByteOrder order)
        : body_(body), whole_size_(body.size()), order_(order) {}

    Status begin_row() { return {}; }
    Result<double> number(NumberType type);
    Status end_row() { return {}; }
    Status end_of_body();

  private:
    std::string_view body_;
    std::size_t whole_size_;
    ByteOrder order_;
};

}  // namespace gripscan
