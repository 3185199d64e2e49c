// Controls under a mouse and a keyboard, without a window.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/support/ui_driver.h"
#include "ui/widgets/button.h"
#include "ui/widgets/choice.h"
#include "ui/widgets/data_table.h"
#include "ui/widgets/error_plot.h"
#include "ui/widgets/evidence_row.h"
#include "ui/widgets/notices.h"
#include "ui/widgets/number_input.h"

namespace gripscan::ui {
namespace {

using test::UiDriver;

TEST(Button, FiresOncePerClick) {
    int fired = 0;
    UiDriver driver(400, 200, [&](const Ui& ui) {
        if (button(ui, {20, 20, 120, 36}, {.id = "step.capture", .label = "Capture"})) ++fired;
    });
    ASSERT_TRUE(driver.click("step.capture"));
    EXPECT_EQ(fired, 1);
    driver.frame();
    EXPECT_EQ(fired, 1);
    ASSERT_TRUE(driver.click("step.capture"));
    EXPECT_EQ(fired, 2);
}

TEST(Button, DoesNotFireWhenTheMouseIsLetGoElsewhere) {
    int fired = 0;
    UiDriver driver(400, 200, [&](const Ui& ui) {
        if (button(ui, {20, 20, 120, 36}, {.id = "a", .label = "A"})) ++fired;
    });
    ASSERT_TRUE(driver.hover("a"));
    driver.press(ImGuiMouseButton_Left, true);
    driver.mouse(300, 150);
    driver.press(ImGuiMouseButton_Left, false);
    EXPECT_EQ(fired, 0);
}

TEST(Button, DisabledDoesNothingAndNotesWhy) {
    int fired = 0;
    UiDriver driver(400, 200, [&](const Ui& ui) {
        if (button(ui, {20, 20, 120, 36},
                   {.id = "step.step",
                    .label = "Step",
                    .why_disabled = "6 must be accepted or taken back first."})) {
            ++fired;
        }
    });
    ASSERT_TRUE(driver.click("step.step"));
    EXPECT_EQ(fired, 0);
    const auto record = driver.log().find("step.step");
    ASSERT_TRUE(record.has_value());
    EXPECT_FALSE(record->enabled);
    EXPECT_EQ(record->label, "Step");
    EXPECT_EQ(record->reason, "6 must be accepted or taken back first.");
    EXPECT_EQ(record->rect, (Rect{20, 20, 120, 36}));
}

TEST(Button, IsHeldOnlyWhileTheMouseIsDownOnIt) {
    bool held = false;
    UiDriver driver(400, 200, [&](const Ui& ui) {
        held = button(ui, {20, 20, 190, 48},
                      {.id = "live.hold", .label = "Hold to move", .look = ButtonLook::kHold})
                   .held;
    });
    ASSERT_TRUE(driver.hover("live.hold"));
    EXPECT_FALSE(held);
    driver.press(ImGuiMouseButton_Left, true);
    EXPECT_TRUE(held);
    driver.frame();
    EXPECT_TRUE(held);
    driver.press(ImGuiMouseButton_Left, false);
    EXPECT_FALSE(held);
}

TEST(WidgetLog, ForgetsWhatIsNoLongerShown) {
    bool shown = true;
    UiDriver driver(400, 200, [&](const Ui& ui) {
        if (shown) (void)button(ui, {20, 20, 120, 36}, {.id = "a", .label = "A"});
    });
    driver.frame();
    EXPECT_TRUE(driver.log().find("a").has_value());
    shown = false;
    driver.frame();
    EXPECT_FALSE(driver.log().find("a").has_value());
    EXPECT_FALSE(driver.click("a"));
}

TEST(Segments, TellWhichOneWasClicked) {
    const std::array<Option, 3> options{
        {{"m.hand", "By hand"}, {"m.run", "Run"}, {"m.never", "Never", Icon::kNone, {}, "no"}}};
    std::optional<std::size_t> clicked;
    UiDriver driver(400, 200, [&](const Ui& ui) {
        if (const auto now = segments(ui, {20, 20, 300, 26}, options, 0)) clicked = now;
    });
    ASSERT_TRUE(driver.click("m.run"));
    EXPECT_EQ(clicked, 1U);
    clicked.reset();
    ASSERT_TRUE(driver.click("m.never"));
    EXPECT_EQ(clicked, std::nullopt);
}

TEST(Tabs, StandSideBySideAndTellWhichOneWasClicked) {
    const std::array<Option, 2> options{
        {{"t.table", "Table 1", Icon::kTable}, {"t.log", "Log", Icon::kNone, "15"}}};
    std::optional<std::size_t> clicked;
    UiDriver driver(400, 200, [&](const Ui& ui) {
        if (const auto now = tabs(ui, {20, 20, 300, 34}, options, 0)) clicked = now;
    });
    ASSERT_TRUE(driver.click("t.log"));
    EXPECT_EQ(clicked, 1U);
    EXPECT_FALSE(driver.log().find("t.table")->rect.overlaps(driver.log().find("t.log")->rect));
}

struct Typing {
    double value = 10.0;
    std::optional<double> committed;
    std::string problem;
    UiDriver driver{400, 200, [this](const Ui& ui) {
                        const auto event = number_input(ui, {20, 20, 96, 26},
                                                        {.id = "step.size",
                                                         .label = "Step",
                                                         .value = value,
                                                         .unit = "deg",
                                                         .min = 0.5,
                                                         .max = 90.0});
                        if (event.committed) committed = event.committed;
                        problem = event.problem;
                    }};
};

TEST(NumberInput, GivesTheNumberOnEnter) {
    Typing t;
    ASSERT_TRUE(t.driver.click("step.size"));
    t.driver.type("7.5");
    EXPECT_EQ(t.committed, std::nullopt);
    t.driver.key(ImGuiKey_Enter);
    EXPECT_EQ(t.committed, 7.5);
    EXPECT_TRUE(t.problem.empty());
}

TEST(NumberInput, SaysTheRangeWhileWhatIsTypedIsOutsideAndGivesNothing) {
    Typing t;
    ASSERT_TRUE(t.driver.click("step.size"));
    t.driver.type("400");
    EXPECT_EQ(t.problem, "0.5 to 90 deg");
    t.driver.key(ImGuiKey_Enter);
    EXPECT_EQ(t.committed, std::nullopt);
}

TEST(NumberInput, EscapeTakesNothing) {
    Typing t;
    ASSERT_TRUE(t.driver.click("step.size"));
    t.driver.type("7.5");
    t.driver.key(ImGuiKey_Escape);
    t.driver.frame();
    EXPECT_EQ(t.committed, std::nullopt);
}

TEST(TypedNumber, ReadsWhatPeopleType) {
    const NumberSpec spec{.unit = "deg", .min = -20.0, .max = 5000.0};
    const auto value = [&](std::string_view text) { return typed_number(text, spec).committed; };
    EXPECT_EQ(value("7.5"), 7.5);
    EXPECT_EQ(value(" 7,5 "), 7.5);
    EXPECT_EQ(value("−3"), -3.0);
    EXPECT_EQ(value("-3"), -3.0);
    EXPECT_EQ(value("1\u2009234"), 1234.0);
    EXPECT_EQ(value("12 deg"), 12.0);
    for (const char* bad : {"", "abc", "7.5.5", "nan", "inf", "-21", "5001", "7 mm"}) {
        EXPECT_EQ(value(bad), std::nullopt) << bad;
    }
}

TEST(Slider, FollowsTheMouseInItsOwnSteps) {
    double value = 4.0;
    UiDriver driver(400, 200, [&](const Ui& ui) {
        const NumberSpec spec{
            .id = "seen", .label = "Seen", .value = value, .decimals = 0, .min = 1, .max = 24};
        if (const auto moved = slider(ui, {20, 20, 240, 26}, spec)) value = *moved;
    });
    ASSERT_TRUE(driver.hover("seen"));
    driver.press(ImGuiMouseButton_Left, true);
    EXPECT_EQ(value, 13.0);  // the middle of 1 … 24, rounded
    driver.mouse(1000, 30);
    EXPECT_EQ(value, 24.0);
    driver.mouse(-50, 30);
    EXPECT_EQ(value, 1.0);
    driver.press(ImGuiMouseButton_Left, false);
    driver.mouse(200, 30);
    EXPECT_EQ(value, 1.0);
}

struct Table {
    std::vector<TableColumn> columns{{"step", "", 42}, {"error", "Angle", 80}};
    std::vector<TableRow> rows;
    TableEvent last;
    UiDriver driver{
        300, 200, [this](const Ui& ui) {
            const auto event = data_table(ui, {0, 0, 300, 200}, {"table", columns, rows});
            if (event.clicked) last.clicked = event.clicked;
            if (event.menu) last.menu = event.menu;
        }};
    explicit Table(int count) {
        for (int i = 0; i < count; ++i) rows.push_back({{{std::to_string(i + 1)}, {"0.01"}}, {}});
    }
};

TEST(DataTable, TellsClickAndRightClickOfARow) {
    Table table(3);
    ASSERT_TRUE(table.driver.click("table.row1"));
    EXPECT_EQ(table.last.clicked, 1U);
    EXPECT_EQ(table.last.menu, std::nullopt);
    ASSERT_TRUE(table.driver.click("table.row2", ImGuiMouseButton_Right));
    EXPECT_EQ(table.last.menu, 2U);
}

TEST(DataTable, DrawsOnlyTheRowsThatCanBeSeen) {
    Table table(10000);
    table.driver.frame();
    EXPECT_TRUE(table.driver.log().find("table.row0").has_value());
    EXPECT_FALSE(table.driver.log().find("table.row50").has_value());
}

TEST(DataTable, DropsColumnsInTheirOrderAndNeverThoseWithoutOne) {
    const std::array<TableColumn, 4> columns{{{.title = "a", .width_px = 50},
                                              {.title = "b", .width_px = 50, .drop = 2},
                                              {.title = "c", .width_px = 50, .drop = 1},
                                              {.title = "d", .width_px = 50}}};
    using testing::ElementsAre;
    EXPECT_THAT(columns_with_room(columns, 200), ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(columns_with_room(columns, 199), ElementsAre(0, 1, 3));
    EXPECT_THAT(columns_with_room(columns, 120), ElementsAre(0, 3));
    EXPECT_THAT(columns_with_room(columns, 10), ElementsAre(0, 3));
}

TEST(EvidenceRow, IsClickedToEditItsLimit) {
    bool clicked = false;
    UiDriver driver(400, 100, [&](const Ui& ui) {
        clicked |= evidence_row(ui, {10, 10, 352, 23},
                                {.id = "e.tilt", .label = "Axis tilt", .value = 0.1, .limit = 0.2});
    });
    ASSERT_TRUE(driver.click("e.tilt"));
    EXPECT_TRUE(clicked);
}

TEST(EvidenceBar, HasItsLimitAtTwoThirds) {
    EXPECT_DOUBLE_EQ(bar_part(0.2, 0.2), 2.0 / 3.0);
    EXPECT_DOUBLE_EQ(bar_part(-0.1, 0.2), 1.0 / 3.0);
    EXPECT_DOUBLE_EQ(bar_part(5.0, 0.2), 1.0);
    EXPECT_DOUBLE_EQ(bar_part(std::nan(""), 0.2), 0.0);
    EXPECT_DOUBLE_EQ(bar_part(1.0, 0.0), 0.0);
}

TEST(ErrorPlot, TellsTheStepThatWasClicked) {
    const std::vector<PlotPoint> points(18, {0.01, 0.02, State::kAccept});
    std::optional<std::size_t> clicked;
    UiDriver driver(400, 200, [&](const Ui& ui) {
        const auto index = error_plot(ui, {0, 0, 360, 150}, "plot", {points, 36, 0.1});
        if (index < points.size()) clicked = index;
    });
    driver.frame();
    const Rect area = driver.log().find("plot")->rect;
    driver.mouse(static_cast<float>(area.x + area.width * 10 / 36 + 2), 70);
    driver.press(ImGuiMouseButton_Left, true);
    driver.press(ImGuiMouseButton_Left, false);
    EXPECT_EQ(clicked, 10U);
    clicked.reset();
    driver.mouse(static_cast<float>(area.right() - 3), 70);  // a step to come
    driver.press(ImGuiMouseButton_Left, true);
    driver.press(ImGuiMouseButton_Left, false);
    EXPECT_EQ(clicked, std::nullopt);
}

TEST(JobBar, IsAsWideAsItSaysAndCanBeCancelled) {
    bool cancelled = false;
    int end = 0;
    int width = 0;
    UiDriver driver(600, 100, [&](const Ui& ui) {
        const Job job{"job.joint", "Joint refinement", 0.62, 4.4};
        width = job_bar_width(ui, job);
        cancelled |= job_bar(ui, 20, 50.0F, job, &end);
    });
    ASSERT_TRUE(driver.click("job.joint.cancel"));
    EXPECT_TRUE(cancelled);
    EXPECT_NEAR(end, 20 + width, 3);  // whole pixels of every part
}

}  // namespace
}  // namespace gripscan::ui
