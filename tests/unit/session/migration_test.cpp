// Sessions that earlier versions wrote still open and lead to a result.
#include <gmock/gmock.h>

#include <set>

#include "core/procedure/engine.h"
#include "core/procedure/journal_codec.h"
#include "core/session/resume.h"

namespace gripscan {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::vector<std::string> versions() {
    std::set<std::string> names;
    for (const auto& entry :
         fs::directory_iterator(fs::path(GRIPSCAN_SOURCE_DIR) / "tests/data/sessions")) {
        if (entry.is_directory()) names.insert(entry.path().filename().string());
    }
    return {names.begin(), names.end()};
}

class SessionOfVersion : public testing::TestWithParam<std::string> {
  protected:
    [[nodiscard]] static fs::path folder() {
        return fs::path(GRIPSCAN_SOURCE_DIR) / "tests/data/sessions" / GetParam();
    }
};

TEST_P(SessionOfVersion, OpensAndIsComputed) {
    const auto session = open_session(folder());
    ASSERT_TRUE(session) << session.error().message;
    const Status checked = check_session_files(*session, {}, for_each_in_order);
    ASSERT_TRUE(checked) << checked.error().message;
    const auto computed =
        compute_turn(recording_of(*session), compute_settings_of(*session), {}, for_each_in_order);
    ASSERT_TRUE(computed) << computed.error().message;
    const TurnReport& report = computed->report;
    EXPECT_GE(report.steps.size(), 2u);
    EXPECT_TRUE(all_trusted(report)) << "as it was when it was recorded";
    EXPECT_GT(report.merged.size(), 1000u);
}

/// As a run that is resumed does: the journal alone leads to the captures of the table.
TEST_P(SessionOfVersion, ItsJournalLeadsToWhatWasRecorded) {
    const auto memory = open_memory(folder());
    if (GetParam() == "0.1") {
        GTEST_SKIP() << "its journal cannot be resumed; ItsJournalIsResumedOrRefusedWithAReason "
                        "sees that it says so";
    }
    ASSERT_TRUE(memory) << memory.error().message;
    ProcedureState begin;
    std::vector<Input> inputs;
    for (const JournalEntry& entry : memory->entries) {
        if (entry.event == "plan") {
            const auto plan = decode_plan(entry.fields);
            ASSERT_TRUE(plan) << plan.error().message;
            begin.plan = *plan;
            begin.data.step_rad = plan->step_rad;
            continue;
        }
        const auto input = decode_input(entry.event, entry.fields);
        ASSERT_TRUE(input) << entry.number << ": " << input.error().message;
        if (*input) inputs.push_back(**input);
    }
    const auto state = replay_inputs(begin, inputs);
    ASSERT_TRUE(state) << state.error().message;
    const auto session = open_session(folder());
    ASSERT_TRUE(session) << session.error().message;
    EXPECT_EQ(state->data.captures.size(), session->table.rows.size());
    EXPECT_EQ(table_of(*state).size() + 1, session->table.rows.size());
    EXPECT_TRUE(state->warm_up && state->warm_up->axis);
}

TEST_P(SessionOfVersion, ItsJournalIsResumedOrRefusedWithAReason) {
    const auto journal = read_journal(folder() / "journal");
    ASSERT_TRUE(journal) << journal.error().message;
    EXPECT_FALSE(journal->entries.empty());
    const auto memory = open_memory(folder());
    EXPECT_EQ(memory.has_value(), GetParam() != "0.1");
    if (memory) {
        EXPECT_EQ(memory->entries.size(), journal->entries.size());
        return;
    }
    EXPECT_THAT(memory.error().message, HasSubstr("gripscan 0.1.0, whose journals cannot be"));
    EXPECT_THAT(memory.error().message, HasSubstr("gripscan replay"));
}

INSTANTIATE_TEST_SUITE_P(All, SessionOfVersion, testing::ValuesIn(versions()),
                         [](const auto& version) {
                             std::string name = "V" + version.param;
                             std::replace(name.begin(), name.end(), '.', '_');
                             return name;
                         });

TEST(Migration, EveryVersionIsThere) {
    EXPECT_THAT(versions(), testing::ElementsAre("0.1", "0.2"));
}

}  // namespace
}  // namespace gripscan
