// A user whose numbers have a decimal comma and grouped digits, without the need for an installed
// locale: streams follow the global one.
#pragma once

#include <locale>
#include <string>

namespace gripscan::test {

class CommaLocale {
  public:
    CommaLocale() : before_(std::locale::global(std::locale(std::locale(), new Punctuation))) {}
    ~CommaLocale() { std::locale::global(before_); }
    CommaLocale(const CommaLocale&) = delete;
    CommaLocale& operator=(const CommaLocale&) = delete;

  private:
    struct Punctuation : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };
    std::locale before_;
};

}  // namespace gripscan::test
