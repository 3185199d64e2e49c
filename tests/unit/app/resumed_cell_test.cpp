// A resumed session goes on in the cell and the mode it began in.
#include "app/resumed_cell.h"

#include <gmock/gmock.h>

namespace gripscan::app {
namespace {

using testing::HasSubstr;

CellOptions simulated() {
    CellOptions options;
    options.seed = 7;
    options.step_deg = 20.0;
    options.faults = {"slip@3"};
    return options;
}

CellOptions real(bool live, bool manual = false) {
    CellOptions options;
    options.cell = "cell.yaml";
    options.live = live;
    options.manual = manual;
    return options;
}

TEST(ResumedCell, WhatIsNotGivenIsAsItBegan) {
    const auto resumed = resumed_cell(simulated(), {}, {});
    ASSERT_TRUE(resumed) << resumed.error().message;
    EXPECT_EQ(resumed->seed, 7U);
    EXPECT_EQ(resumed->step_deg, 20.0);
    EXPECT_EQ(resumed->faults, std::vector<std::string>{"slip@3"});
    EXPECT_TRUE(resumed_cell(simulated(), simulated(), {})) << "the same again is no contradiction";
}

TEST(ResumedCell, TheSpeedAndWhereTheCellFileLiesMayBeOthers) {
    CellOptions asked = real(true);
    asked.cell = "/elsewhere/cell.yaml";
    asked.speed_percent = 5.0;
    const auto resumed = resumed_cell(real(true), asked, {"--cell"});
    ASSERT_TRUE(resumed) << resumed.error().message;
    EXPECT_EQ(resumed->cell, "/elsewhere/cell.yaml");
    EXPECT_EQ(resumed->speed_percent, 5.0);
    EXPECT_TRUE(resumed->live);
}

CellOptions with(CellOptions options, const std::function<void(CellOptions&)>& change) {
    change(options);
    return options;
}

TEST(ResumedCell, TheSameGivenAgainIsNoContradiction) {
    EXPECT_TRUE(resumed_cell(simulated(), simulated(), {"--cell", "--seed", "--step-deg"}));
    EXPECT_TRUE(resumed_cell(real(false), real(false), {"--cell"}));
    EXPECT_TRUE(resumed_cell(real(false), {}, {}));
}

TEST(ResumedCell, TheCommandLineTellsWhatWasGiven) {
    CellOptions options;
    CLI::App app;
    add_cell_options(app, options);
    app.parse("--seed 1 --step-deg 10 --speed 5");
    EXPECT_THAT(given_cell_options(app), testing::ElementsAre("--seed", "--step-deg"));
}

TEST(ResumedCell, TheCellFileIsRememberedWhereItLies) {
    const auto cell_of = [](const CellOptions& options) {
        return cell_options_from(journal_fields(options)).value().cell;
    };
    EXPECT_EQ(cell_of(real(false)), (std::filesystem::current_path() / "cell.yaml").string());
    EXPECT_EQ(cell_of(simulated()), "sim");
}

TEST(ResumedCell, ACellFileThatHasMovedIsAskedFor) {
    CellOptions moved = real(true);
    moved.cell = "/nowhere/cell.yaml";
    const Status there = check_cell_file("monday", moved);
    ASSERT_FALSE(there);
    for (const auto* part : {"/nowhere/cell.yaml", "monday", "--cell FILE"}) {
        EXPECT_THAT(there.error().message, HasSubstr(part));
    }
    EXPECT_TRUE(check_cell_file("monday", simulated()));
}

struct Refused {
    const char* name;
    CellOptions journalled;
    CellOptions asked;
    const char* says;
    GivenOptions given = {};
};

class RefusedResume : public testing::TestWithParam<Refused> {};

TEST_P(RefusedResume, SaysWhyAndMovesNothing) {
    const auto resumed = resumed_cell(GetParam().journalled, GetParam().asked, GetParam().given);
    ASSERT_FALSE(resumed);
    EXPECT_EQ(resumed.error().kind, ErrorKind::kInput);
    EXPECT_THAT(resumed.error().message, HasSubstr(GetParam().says));
}

INSTANTIATE_TEST_SUITE_P(
    Contradictions, RefusedResume,
    testing::Values(
        Refused{"RealCell", simulated(), real(true), "cannot go on in cell.yaml"},
        Refused{"RealCellDry", simulated(), real(false), "cannot go on in cell.yaml"},
        Refused{"DryAsLive", real(false), real(true), "began in DRY mode"},
        Refused{"ManualAsLive", real(false, true), real(true), "began in MANUAL mode"},
        Refused{"LiveAsManual", real(true), real(true, true), "began in LIVE mode"},
        Refused{"LiveWithoutSayingSo", real(true), real(false), "--live"},
        Refused{"SimulatedCell", real(false), {}, "cannot go on in the simulated", {"--cell"}},
        Refused{"Step",
                simulated(),
                with({}, [](auto& o) { o.step_deg = 15.0; }),
                "--step-deg",
                {"--step-deg"}},
        Refused{"StandardStep", simulated(), {}, "--step-deg", {"--step-deg"}},
        Refused{"Seed", simulated(), with({}, [](auto& o) { o.seed = 8; }), "--seed", {"--seed"}},
        Refused{"StandardSeed", simulated(), {}, "--seed", {"--seed"}},
        Refused{"Fault", simulated(), with({}, [](auto& o) { o.faults = {"bump"}; }), "--fault"},
        Refused{"Object", simulated(), with({}, [](auto& o) { o.object = "jug"; }), "--object"},
        Refused{"Gripper", simulated(), with({}, [](auto& o) { o.gripper_model = "cylinder"; }),
                "--gripper-model"}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace gripscan::app
