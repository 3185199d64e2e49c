#include "core/session/capture_table.h"

#include <gmock/gmock.h>

namespace gripscan {
namespace {

using testing::HasSubstr;

std::string problem(const std::string& text) {
    const auto table = parse_capture_table("s/captures.csv", text);
    return table ? "no problem" : table.error().message;
}

TEST(CaptureTable, FindsColumnsByNameInAnyOrder) {
    const auto table = parse_capture_table("c.csv",
                                           "right,index,j6_deg,left,status,attempt\n"
                                           "r.png,0,-90.5,l.png,,\n"
                                           "r.png,4,-80.5,l.png,superseded,2\n");
    ASSERT_TRUE(table) << table.error().message;
    const CaptureRow& first = table->rows[0];
    EXPECT_EQ(first.index, 0);
    EXPECT_EQ(first.left, "l.png");
    EXPECT_EQ(first.joints_deg[5], -90.5);
    EXPECT_EQ(first.status, CaptureStatus::kUsed) << "an empty status means used";
    EXPECT_FALSE(first.attempt);
    EXPECT_FALSE(first.commanded_deg) << "a missing column is an unknown value";
    const CaptureRow& second = table->rows[1];
    EXPECT_EQ(second.index, 4) << "gaps are allowed";
    EXPECT_EQ(second.status, CaptureStatus::kSuperseded);
    EXPECT_EQ(second.attempt, 2);
    EXPECT_EQ(second.line, 3);
}

TEST(CaptureTable, KeepsUnknownColumnsWhenWrittenAgain) {
    const std::string text =
        "index,operator,commanded_deg,cloud,room °C\n"
        "0,\"Kovač, Ana\",0,a.pcd,21.5\n"
        "1,,10.25,b.pcd,\n";
    const auto table = parse_capture_table("c.csv", text);
    ASSERT_TRUE(table) << table.error().message;
    EXPECT_EQ(capture_table_text(*table), text);
}

TEST(CaptureTable, AddsAColumnThatHasGotAValue) {
    auto table = parse_capture_table("c.csv", "index,cloud\n0,a.pcd\n1,b.pcd\n");
    ASSERT_TRUE(table);
    table->rows[1].status = CaptureStatus::kExcluded;
    EXPECT_EQ(capture_table_text(*table), "index,cloud,status\n0,a.pcd,used\n1,b.pcd,excluded\n");
}

TEST(CaptureTable, ModeAndNoteComeBack) {
    const std::string text =
        "index,cloud,mode,note\n0,a.pcd,,\n1,b.pcd,axis-locked,\"worn, but \"\"fine\"\"\"\n";
    const auto table = parse_capture_table("c.csv", text);
    ASSERT_TRUE(table) << table.error().message;
    EXPECT_EQ(table->rows[0].mode, TurnMode::kFree);
    EXPECT_EQ(table->rows[1].mode, TurnMode::kAxisLocked);
    EXPECT_EQ(table->rows[1].note, "worn, but \"fine\"");
    EXPECT_EQ(capture_table_text(*table), text);
    EXPECT_EQ(problem("index,mode\n0,free\n1,axis-locked\n"), "no problem");
    EXPECT_THAT(problem("index,mode\n0,prior\n"),
                HasSubstr("captures.csv:2: column 'mode': 'prior' is none of free, axis-locked"));
}

TEST(CaptureTable, SaysWhereANumberIsNone) {
    for (const std::string bad : {"nan", "inf", "-inf", "1,5", "ten", "10deg", "0x10", "1e999"}) {
        const std::string cell = bad == "1,5" ? "\"1,5\"" : bad;
        const std::string message =
            problem("index,commanded_deg,cloud\n0,0,a.pcd\n1," + cell + ",b.pcd\n");
        EXPECT_THAT(message, HasSubstr("s/captures.csv:3: column 'commanded_deg'")) << bad;
        EXPECT_THAT(message, HasSubstr(bad));
    }
}

TEST(CaptureTable, IndicesRise) {
    EXPECT_THAT(problem("index\n0\n0\n"), HasSubstr("captures.csv:3"));
    EXPECT_THAT(problem("index\n5\n4\n"), HasSubstr("does not rise"));
    EXPECT_THAT(problem("index\n-1\n"), HasSubstr("'-1'"));
    EXPECT_THAT(problem("index\n1.5\n"), HasSubstr("'1.5'"));
    EXPECT_THAT(problem("index,left\n,x.png\n"), HasSubstr("'index' is empty"));
}

TEST(CaptureTable, PathsStayInTheFolder) {
    for (const std::string path : {"/etc/passwd", "../x.png", "frames/../../x.png", ".."}) {
        EXPECT_THAT(problem("index,left\n0," + path + "\n"), HasSubstr("leaves the session folder"))
            << path;
    }
    EXPECT_EQ(problem("index,left\n0,frames/../x.png\n"), "no problem");
    EXPECT_EQ(problem("index,left\n0,frames/..hidden.png\n"), "no problem");
}

TEST(CaptureTable, RefusesOtherShapes) {
    EXPECT_THAT(problem(""), HasSubstr("empty"));
    EXPECT_THAT(problem("a,b\n1,2\n"), HasSubstr("no column 'index'"));
    EXPECT_THAT(problem("index,left,left\n"), HasSubstr("'left' is given twice"));
    EXPECT_THAT(problem("index,left\n0\n"), HasSubstr("1 cells, but the header names 2"));
    EXPECT_THAT(problem("index,status\n0,maybe\n"), HasSubstr("none of used, superseded"));
    EXPECT_THAT(problem("index,attempt\n0,0\n"), HasSubstr("whole number from 1"));
}

}  // namespace
}  // namespace gripscan
