#include "core/procedure/journal_codec.h"

#include <gmock/gmock.h>

#include <set>

#include "core/procedure/input_fields.h"
#include "tests/unit/procedure/random_fields.h"

namespace gripscan {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

/// Inputs of every alternative of Command or Event, with values from `seed`.
template <typename Variant>
std::vector<Input> every_alternative(std::uint64_t seed) {
    SeededRandom random(seed);
    test::RandomFields filler(random);
    std::vector<Input> inputs;
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        const auto add = [&](auto value) {
            fields(filler, value);
            inputs.emplace_back(Variant(std::move(value)));
        };
        (add(std::variant_alternative_t<I, Variant>{}), ...);
    }
    (std::make_index_sequence<std::variant_size_v<Variant>>{});
    return inputs;
}

std::vector<Input> every_input(std::uint64_t seed) {
    auto inputs = every_alternative<Command>(seed);
    for (auto& input : every_alternative<Event>(seed + 1)) inputs.push_back(std::move(input));
    return inputs;
}

std::string word_of(const Input& input) {
    return std::visit([](const auto& one) { return std::string(word(one)); }, input);
}

std::vector<std::string> names_in_order(const JournalRecord& record) {
    std::vector<std::string> names;
    for (const auto& [name, value] : record.fields) names.push_back(name);
    return names;
}

std::set<std::string> names_of(const JournalRecord& record) {
    const auto names = names_in_order(record);
    return {names.begin(), names.end()};
}

/// Reads back what encode() wrote; the input must be one.
Input decoded(const JournalRecord& record) {
    auto input = decode_input(record.event, record.fields);
    if (!input) throw std::runtime_error(input.error().message);
    return input->value();
}

template <typename E>
E through_journal(const E& event) {
    return std::get<E>(std::get<Event>(decoded(encode(Input(Event(event))))));
}

std::string error_of(const JournalRecord& record) {
    const auto input = decode_input(record.event, record.fields);
    return input ? "read without an error" : input.error().message;
}

/// The entry with another text in one of its fields.
JournalRecord with(JournalRecord record, std::string_view name, std::string_view text) {
    for (auto& field : record.fields) {
        if (field.first == name) field.second = text;
    }
    return record;
}

RobotReading some_reading(std::uint64_t seed) {
    SeededRandom random(seed);
    test::RandomFields filler(random);
    RobotReading reading;
    fields(filler, reading);
    return reading;
}

TEST(JournalCodec, EveryInputSurvivesWhateverIsInIt) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        for (const Input& input : every_input(seed)) {
            const JournalRecord written = encode(input);
            const auto read = decode_input(written.event, written.fields);
            ASSERT_TRUE(read) << seed << ": " << read.error().message;
            ASSERT_TRUE(read->has_value()) << word_of(input);
            EXPECT_EQ((*read)->index(), input.index());
            EXPECT_EQ(word_of(**read), word_of(input));
            EXPECT_EQ(encode(**read).fields, written.fields) << seed << " " << word_of(input);
        }
    }
}

TEST(JournalCodec, NoEntryHasTwoFieldsOfOneName) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        for (const Input& input : every_input(seed)) {
            const JournalRecord record = encode(input);
            EXPECT_EQ(names_of(record).size(), record.fields.size()) << word_of(input);
        }
    }
}

TEST(JournalCodec, CapturesReadingsAndChecksComeBackEqual) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        for (const Input& input : every_alternative<Event>(seed)) {
            const auto& event = std::get<Event>(input);
            if (const auto* exposed = std::get_if<event::Exposed>(&event)) {
                EXPECT_EQ(through_journal(*exposed).record, exposed->record);
            } else if (const auto* checked = std::get_if<event::CellChecked>(&event)) {
                EXPECT_EQ(through_journal(*checked).report, checked->report);
            } else if (const auto* arrived = std::get_if<event::Arrived>(&event)) {
                EXPECT_EQ(through_journal(*arrived).reading, arrived->reading);
            }
        }
    }
}

/// Chained and inverted, a rotation is orthonormal only to rounding: exactly that has to come back.
TEST(JournalCodec, PosesKeepTheirLastBit) {
    SeededRandom random(7);
    Pose chain = Pose::Identity();
    for (int k = 0; k < 300; ++k) {
        chain = chain * test::random_pose(random, 0.3);
        event::Judged judged;
        judged.step.row.T = chain;
        const auto read = through_journal(judged).step.row.T;
        ASSERT_TRUE(read);
        EXPECT_EQ(read->matrix(), chain.matrix()) << k;
    }
}

TEST(JournalCodec, AnExposureIsWrittenLikeThis) {
    event::Exposed exposed;
    exposed.record = {
        3, 2, 0.5, CaptureStatus::kSuperseded, TurnMode::kAxisLocked, "", std::nullopt, 0.25, 12.5};
    exposed.record.before = RobotReading{{0, -0.1, 0.2, 0, 1, 0.5}, Pose::Identity()};
    const JournalRecord record = encode(Input(Event(exposed)));
    EXPECT_EQ(record.event, "event");
    EXPECT_THAT(record.fields,
                ElementsAre(Pair("name", "exposed"), Pair("index", "3"), Pair("attempt", "2"),
                            Pair("commanded_rad", "0.5"), Pair("status", "superseded"),
                            Pair("mode", "axis-locked"), Pair("note", ""),
                            Pair("before.joints_rad", "0 -0.1 0.2 0 1 0.5"),
                            Pair("before.T_world_tool", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"),
                            Pair("joint6_after_rad", "0.25"), Pair("t_s", "12.5")));
}

TEST(JournalCodec, AJudgedStepIsWrittenLikeThis) {
    event::Judged judged;
    TurnStep& row = judged.step.row;
    row.index = 2;
    row.from = 1;
    row.to = 4;
    row.attempts = 3;
    row.icp_rad = 0.125;
    row.independent = false;
    row.verdict = Verdict::kAcceptNoted;
    row.cause = Cause::kWrongJoint;
    row.sentence = "a sentence";
    judged.step.foreign = ForeignObject{{0.5, 0, -1}, 80.0};
    judged.step.evidence = {"first", "second"};
    EXPECT_THAT(encode(Input(Event(judged))).fields,
                ElementsAre(Pair("name", "judged"), Pair("index", "2"), Pair("from", "1"),
                            Pair("to", "4"), Pair("attempts", "3"), Pair("icp_rad", "0.125"),
                            Pair("mode", "free"), Pair("independent", "false"),
                            Pair("verdict", "accept_noted"), Pair("cause", "wrong_joint"),
                            Pair("sentence", "a sentence"), Pair("foreign.centre_m", "0.5 0 -1"),
                            Pair("foreign.area_mm2", "80"), Pair("evidence", "2"),
                            Pair("evidence.1", "first"), Pair("evidence.2", "second")));
}

TEST(JournalCodec, ALinkAnAxisAndACheckHaveTheseFields) {
    EXPECT_THAT(
        names_in_order(encode(Input(Event(event::LinkUp{{}, {}, RobotReading{}})))),
        ElementsAre("name", "identity.model", "identity.axes", "identity.protocol",
                    "controller.automatic", "controller.servo_on", "controller.emergency_stop",
                    "controller.fault", "controller.moving", "controller.override_percent",
                    "controller.alarm", "reading.joints_rad", "reading.T_world_tool"));
    EXPECT_THAT(names_in_order(encode(
                    Input(Event(event::AxisFound{AxisEstimate{}, "", {}, Cause::kSymmetry})))),
                ElementsAre("name", "axis.point_m", "axis.direction", "axis.sd_rad", "axis.sd_m",
                            "sentence", "why_none"));
    EXPECT_THAT(names_in_order(encode(Input(Event(event::CellChecked{{{CellCheckItem{}}}})))),
                ElementsAre("name", "items", "items.1.name", "items.1.outcome", "items.1.value",
                            "items.1.limit", "items.1.unit", "items.1.sentence"));
}

TEST(JournalCodec, APlanHasTheseFields) {
    TurnPlan plan;
    plan.start_joint6_rad = 0.0;
    EXPECT_THAT(names_in_order(encode(plan)),
                ElementsAre("mode", "step_rad", "total_rad", "start_joint6_rad", "speed_percent",
                            "approach_rad", "largest_move_rad", "warm_up_step_rad", "warm_up_shots",
                            "warm_up_in_place", "limits.angle_rad", "limits.sigmas",
                            "limits.overlap", "limits.slip_m", "limits.tilt_rad", "least_step_rad",
                            "retakes_an_angle", "halvings_a_turn", "rejected_in_a_row"));
}

/// Journals written before there was a choice go on as they began.
TEST(JournalCodec, APlanWithoutLaterFieldsMeansWhatItMeantThen) {
    JournalFields entry = encode(TurnPlan{}).fields;
    std::erase_if(entry, [](const auto& field) {
        return field.first == "warm_up_in_place" || field.first == "halvings_a_turn";
    });
    const auto plan = decode_plan(entry);
    ASSERT_TRUE(plan) << plan.error().message;
    EXPECT_FALSE(plan->warm_up_in_place);
    EXPECT_FALSE(plan->halvings_a_turn);
}

TEST(JournalCodec, EveryOptionalNumberOfAStepHasAFieldOfItsOwn) {
    TurnStep step;
    double next = 1.0;
    for (auto* number : {&step.commanded_rad, &step.robot_rad, &step.icp_rad, &step.error_rad,
                         &step.sigma_rad, &step.observability, &step.tilt_rad, &step.axis_offset_m,
                         &step.slip_m, &step.overlap, &step.rms_m, &step.median_m, &step.p90_m}) {
        *number = next++;
    }
    event::Judged judged;
    judged.step.row = step;
    const TurnStep read = through_journal(judged).step.row;
    EXPECT_THAT((std::vector{read.commanded_rad, read.robot_rad, read.icp_rad, read.error_rad,
                             read.sigma_rad, read.observability, read.tilt_rad, read.axis_offset_m,
                             read.slip_m, read.overlap, read.rms_m, read.median_m, read.p90_m}),
                ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13));
}

TEST(JournalCodec, ANoteKeepsItsLinesAndLetters) {
    for (const std::string note : {"", "two\nlines", "für 漢字 🤖", "  \"quoted\"\\ "}) {
        const auto read = decoded(encode(Input(Command(command::Accept{note}))));
        EXPECT_EQ(std::get<command::Accept>(std::get<Command>(read)).note, note);
    }
}

TEST(JournalCodec, EveryFieldIsNeededOrOptionalAndTheErrorNamesIt) {
    for (const Input& input : every_input(11)) {
        const JournalRecord whole = encode(input);
        for (std::size_t i = 0; i < whole.fields.size(); ++i) {
            JournalRecord part = whole;
            part.fields.erase(part.fields.begin() + static_cast<std::ptrdiff_t>(i));
            const auto read = decode_input(part.event, part.fields);
            if (read) {
                // The value is absent now, and nothing else has changed.
                EXPECT_EQ(encode(read->value()).fields, part.fields) << whole.fields[i].first;
            } else {
                EXPECT_THAT(read.error().message,
                            HasSubstr("'" + whole.fields[i].first + "' is missing"));
            }
        }
    }
}

TEST(JournalCodec, WhatCannotBeReadIsNamedWithItsField) {
    CellReport cell;
    cell.items = {{"link", CheckOutcome::kPassed, 1, 2, "s", ""},
                  {"range", CheckOutcome::kFailed, 3, 4, "deg", ""}};
    const auto checked = encode(Input(Event(event::CellChecked{cell})));
    const auto arrived = encode(Input(Event(event::Arrived{some_reading(1)})));
    const auto failed = encode(Input(Event(event::TurnFailed{})));
    const auto judged = encode(Input(Event(event::Judged{})));
    const auto solved = encode(Input(Event(event::Solved{})));
    struct Case {
        const JournalRecord& record;
        std::string_view field;
        std::string_view text;
    };
    for (const auto& [record, field, text] : std::initializer_list<Case>{
             {checked, "items", "-1"},
             {checked, "items", "two"},
             {checked, "items.2.limit", "nan"},
             {checked, "items.2.limit", "inf"},
             {checked, "items.2.limit", "4 deg"},
             {checked, "items.1.value", ""},
             {checked, "items.1.outcome", "perhaps"},
             {arrived, "joints_rad", "1 2 3 4 5"},
             {arrived, "joints_rad", "1 2 3 4 5 6 7"},
             {arrived, "joints_rad", "1 2 3 4 5 nan"},
             {arrived, "T_world_tool", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0"},
             {arrived, "T_world_tool", "1 0 0 0 0 1 0 0 0 0 1.001 0 0 0 0 1"},
             {arrived, "T_world_tool", "1 0 0 0 0 1 0 0 0 0 -1 0 0 0 0 1"},
             {failed, "fault", "Lost"},
             {failed, "last_id", "2147483648"},
             {failed, "last_id", "1.0"},
             {failed, "last_id", " 1"},
             {judged, "independent", "yes"},
             {judged, "mode", "axis_locked"},
             {judged, "verdict", ""},
             {solved, "template_points", "-1"},
             {solved, "name", "dissolved"},
             {solved, "name", "accept"}}) {
        const std::string message = error_of(with(record, field, text));
        EXPECT_THAT(message, HasSubstr("'" + std::string(field) + "' must be ")) << text;
        EXPECT_THAT(message, HasSubstr("not '" + std::string(text) + "'"));
    }
}

TEST(JournalCodec, AListThatClaimsTooMuchEndsAtItsFirstMissingItem) {
    const auto record =
        with(encode(Input(Event(event::CellChecked{}))), "items", "18446744073709551615");
    EXPECT_THAT(error_of(record), HasSubstr("'items.1.name' is missing"));
}

TEST(JournalCodec, AMessageStaysOnOneLine) {
    const auto record = with(encode(Input(Event(event::Solved{}))), "steps",
                             "not\na number " + std::string(500, 'x'));
    EXPECT_THAT(error_of(record),
                testing::AllOf(HasSubstr("'steps'"), testing::Not(HasSubstr("\n")),
                               testing::SizeIs(testing::Lt(200))));
}

TEST(JournalCodec, AMessageCutsNoLetterInTwo) {
    std::string text;  // 59 bytes, then letters of two: the limit of 60 falls into the first
    for (int i = 0; i < 59; ++i) text += 'x';
    for (int i = 0; i < 9; ++i) text += "ü";
    const auto record = with(encode(Input(Event(event::Solved{}))), "steps", text);
    EXPECT_THAT(error_of(record), HasSubstr("'" + text.substr(0, 59) + "…'"));
}

TEST(JournalCodec, FieldsOfALaterVersionAreIgnored) {
    for (const Input& input : every_input(5)) {
        const JournalRecord written = encode(input);
        JournalRecord later = written;
        later.fields.emplace_back("added_later", "x");
        later.fields.insert(later.fields.begin(), {"before_all", "1 2"});
        EXPECT_EQ(encode(decoded(later)).fields, written.fields);
    }
}

TEST(JournalCodec, OtherEntriesAreNoInputs) {
    for (const std::string_view event : {"plan", "capture", "result", "", "Command"}) {
        const auto read = decode_input(event, {{"name", "step"}});
        ASSERT_TRUE(read) << event;
        EXPECT_FALSE(read->has_value()) << event;
    }
}

TEST(JournalCodec, AnyPlanSurvives) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        SeededRandom random(seed);
        test::RandomFields filler(random);
        TurnPlan plan;
        fields(filler, plan);
        const JournalRecord written = encode(plan);
        EXPECT_EQ(written.event, "plan");
        const auto read = decode_plan(written.fields);
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(read->mode, plan.mode);
        EXPECT_EQ(read->start_joint6_rad, plan.start_joint6_rad);
        EXPECT_EQ(encode(*read).fields, written.fields);
    }
}

TEST(JournalCodec, APlanThatCannotBeReadNamesItsField) {
    const auto error = [](std::string_view name, std::string_view text) {
        const auto plan = decode_plan(with(encode(TurnPlan{}), name, text).fields);
        return plan ? "read without an error" : plan.error().message;
    };
    EXPECT_THAT(error("mode", "sim"), HasSubstr("'mode'"));
    EXPECT_THAT(error("limits.slip_m", "1 mm"), HasSubstr("'limits.slip_m'"));
    const auto empty = decode_plan({});
    ASSERT_FALSE(empty);
    EXPECT_THAT(empty.error().message, HasSubstr("'mode' is missing"));
}

}  // namespace
}  // namespace gripscan
