// Numbers and words between a shell's command line and the program.
#include <gmock/gmock.h>

#include "app/number_checks.h"
#include "app/shell_text.h"

namespace gripscan::app {
namespace {

using testing::HasSubstr;

/// What becomes of it, or the complaint.
std::string seed(const std::string& text) {
    CLI::App app;
    std::uint64_t number = 1;
    app.add_option("--seed", number)->transform(unsigned_number());
    try {
        app.parse("--seed " + text);
    } catch (const CLI::ParseError& error) {
        return error.what();
    }
    return std::to_string(number);
}

TEST(UnsignedNumber, IsDecimalAndNotCutOff) {
    EXPECT_EQ(seed("0"), "0");
    EXPECT_EQ(seed("7"), "7");
    EXPECT_EQ(seed("010"), "10");
    EXPECT_EQ(seed("18446744073709551615"), "18446744073709551615");
    EXPECT_THAT(seed("18446744073709551616"), HasSubstr("too large"));
    EXPECT_THAT(seed("99999999999999999999999"), HasSubstr("too large"));
    for (const std::string text : {"-1", "+1", "1.5", "0x10", "ten"}) {
        EXPECT_THAT(seed(text), HasSubstr("not a whole number")) << text;
    }
}

TEST(ShellWord, IsQuotedWhereAShellWouldTakeItApart) {
    EXPECT_EQ(shell_word("/tmp/monday_2.d"), "/tmp/monday_2.d");
    EXPECT_EQ(shell_word("my session"), "'my session'");
    EXPECT_EQ(shell_word("it's; $HOME"), "'it'\\''s; $HOME'");
    EXPECT_EQ(shell_word("~"), "'~'");
    EXPECT_EQ(shell_word(""), "''");
}

}  // namespace
}  // namespace gripscan::app
