#include "core/report/table1.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "core/base/number_text.h"
#include "core/report/table1_text.h"
#include "core/session/csv_text.h"
#include "tests/unit/report/sample_report.h"

namespace gripscan {
namespace {

using testing::HasSubstr;

/// The table read back from its CSV, cells by row and column name.
class ReadBack {
  public:
    explicit ReadBack(const TurnReport& report, const CaptureTable& captures = {}) {
        const auto lines = parse_csv("t.csv", table1_csv(table1_of(report, captures)));
        EXPECT_TRUE(lines);
        for (const auto& line : *lines) lines_.push_back(line.cells);
    }
    [[nodiscard]] std::size_t rows() const { return lines_.size() - 1; }
    [[nodiscard]] std::string at(std::size_t row, const std::string& column) const {
        const auto& header = lines_[0];
        const auto found = std::find(header.begin(), header.end(), column);
        EXPECT_NE(found, header.end()) << column;
        return lines_.at(row + 1).at(static_cast<std::size_t>(found - header.begin()));
    }
    [[nodiscard]] double number(std::size_t row, const std::string& column) const {
        return number_from_text(at(row, column)).value_or(-1e99);
    }

  private:
    std::vector<std::vector<std::string>> lines_;
};

TEST(Table1, TellsEveryStepInFullPrecision) {
    const TurnReport report = test::sample_report();
    const ReadBack csv(report);
    ASSERT_EQ(csv.rows(), 3u + 1u + 2u) << "steps, sum, closure before and after";
    EXPECT_EQ(csv.at(0, "row"), "step");
    EXPECT_EQ(csv.number(0, "icp_deg"), 9.98);
    EXPECT_NEAR(csv.number(0, "error_deg"), -0.018, 1e-12);
    EXPECT_NEAR(csv.number(0, "error_sigmas"), -0.6, 1e-9);
    EXPECT_NEAR(csv.number(0, "roll_deg"), 9.98, 1e-12);
    EXPECT_NEAR(csv.number(0, "pitch_deg"), -0.5, 1e-12);
    EXPECT_EQ(csv.number(0, "x_m"), -0.0156);
    EXPECT_NEAR(csv.number(1, "cumulative_deg"), 9.98 + 10.7, 1e-9);
    EXPECT_EQ(csv.at(1, "verdict"), "check");
    EXPECT_EQ(csv.at(1, "cause"), "mislabelled");
    EXPECT_EQ(csv.at(2, "icp_deg"), "") << "unknown is empty, not zero";
    EXPECT_EQ(csv.at(2, "to"), "4");
    EXPECT_EQ(csv.at(2, "sentence"), report.steps[2].sentence);
}

TEST(Table1, AnUnknownPartMakesTheSumUnknown) {
    TurnReport report = test::sample_report();
    EXPECT_EQ(ReadBack(report).at(3, "icp_deg"), "");
    EXPECT_EQ(ReadBack(report).number(3, "commanded_deg"), 40.0);
    report.steps.pop_back();
    const ReadBack csv(report);
    EXPECT_EQ(csv.at(2, "row"), "sum");
    EXPECT_NEAR(csv.number(2, "icp_deg"), 20.68, 1e-9);
    EXPECT_NEAR(csv.number(2, "error_deg"), 0.682, 1e-9);
    EXPECT_NEAR(csv.number(2, "sigma_deg"), 0.03 * std::sqrt(2.0), 1e-9);
    EXPECT_EQ(csv.at(3, "row"), "closure_before");
    EXPECT_NEAR(csv.number(3, "axis_offset_mm"), 1.2, 1e-12);
    EXPECT_EQ(csv.at(4, "row"), "closure_after");
}

TEST(Table1, TakesTimesAndReadingsFromTheSession) {
    CaptureTable captures;
    captures.rows.resize(2);
    captures.rows[1].index = 1;
    captures.rows[1].t_s = 12.5;
    captures.rows[1].joints_deg[5] = -170.0;
    captures.rows[1].j6_after_deg = -169.99;
    const ReadBack csv(test::sample_report(), captures);
    EXPECT_EQ(csv.number(0, "t_s"), 12.5);
    EXPECT_EQ(csv.number(0, "j6_deg"), -170.0);
    EXPECT_EQ(csv.number(0, "j6_after_deg"), -169.99);
    EXPECT_EQ(csv.at(1, "t_s"), "");
}

TEST(Table1, ShownNumbersAreRoundedOnScreenOnly) {
    const Table1Column column{"x", "x", "mm", 2};
    EXPECT_EQ(shown(column, 1.23456), "1.23");
    EXPECT_EQ(shown(column, -0.0001), "0.00") << "no minus zero";
    EXPECT_EQ(shown(column, -0.01), "-0.01");
    EXPECT_EQ(shown(column, std::monostate{}), "");
    EXPECT_EQ(shown({"o", "o", "%", 0, 100.0}, 0.834), "83");
}

TEST(Table1, TheTerminalSaysWhatIsWrongInWords) {
    const TurnReport report = test::sample_report();
    const std::string text = table1_text(report, table1_of(report, {}));
    EXPECT_THAT(text, HasSubstr("step   3     reject (not_converged): captures 2 -> 4: no align"));
    EXPECT_THAT(text, HasSubstr("1 of 3 steps accepted, 1 to check, 1 rejected"));
    EXPECT_THAT(text, HasSubstr("mean |error| 0.359 deg, worst 0.700 deg"));
    EXPECT_THAT(text, HasSubstr("1.200 mm from step to step"));
}

TEST(Table1, EveryLineOfTheTerminalTableIsAsLong) {
    const TurnReport report = test::sample_report();
    const std::string text = table1_text(report, table1_of(report, {}));
    const std::size_t width = text.find('\n');
    std::size_t at = 0;
    for (int line = 0; line < 8; ++line) {
        const std::size_t end = text.find('\n', at);
        EXPECT_EQ(end - at, width) << "line " << line;
        at = end + 1;
    }
}

}  // namespace
}  // namespace gripscan
