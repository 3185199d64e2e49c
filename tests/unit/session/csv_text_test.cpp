#include "core/session/csv_text.h"

#include <gmock/gmock.h>

namespace gripscan {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(CsvText, ReadsQuotesBothLineEndsAndTheUtf8Mark) {
    const auto lines = parse_csv("f.csv",
                                 "\xef\xbb\xbf"
                                 "a,b\r\n\"x, \"\"y\"\"\",2\n\n\"two\nlines\",\n");
    ASSERT_TRUE(lines);
    ASSERT_EQ(lines->size(), 3u);
    EXPECT_THAT((*lines)[0].cells, ElementsAre("a", "b"));
    EXPECT_THAT((*lines)[1].cells, ElementsAre("x, \"y\"", "2"));
    EXPECT_EQ((*lines)[1].line, 2);
    EXPECT_THAT((*lines)[2].cells, ElementsAre("two\nlines", ""));
    EXPECT_EQ((*lines)[2].line, 4) << "empty lines count";
}

TEST(CsvText, ReadsTheLastLineWithoutItsEnd) {
    const auto lines = parse_csv("f.csv", "a,b\n1,2");
    ASSERT_TRUE(lines);
    ASSERT_EQ(lines->size(), 2u);
    EXPECT_THAT((*lines)[1].cells, ElementsAre("1", "2"));
}

TEST(CsvText, WritesWhatItReads) {
    const std::vector<std::string> cells{"plain", "with, comma", "with \"quotes\"", "", "a\nb"};
    const auto lines = parse_csv("f.csv", csv_line(cells));
    ASSERT_TRUE(lines);
    EXPECT_EQ((*lines)[0].cells, cells);
}

TEST(CsvText, NamesTheLineOfAnOpenQuote) {
    const auto lines = parse_csv("f.csv", "a,b\n1,\"open\n2,3\n");
    ASSERT_FALSE(lines);
    EXPECT_THAT(lines.error().message, HasSubstr("f.csv:2"));
}

TEST(CsvText, NamesTheLineOfTextAfterAQuote) {
    const auto lines = parse_csv("f.csv", "a\n\"b\"c\n");
    ASSERT_FALSE(lines);
    EXPECT_THAT(lines.error().message, HasSubstr("f.csv:2"));
}

}  // namespace
}  // namespace gripscan
