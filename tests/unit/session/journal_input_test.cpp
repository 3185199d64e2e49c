// Inputs of the procedure through the file: JSON, check sums and all.
#include <gmock/gmock.h>

#include "core/procedure/journal_codec.h"
#include "core/session/journal_file.h"
#include "tests/support/random_pose.h"
#include "tests/support/temporary_folder.h"

namespace gripscan {
namespace {

std::vector<JournalRecord> some_records() {
    SeededRandom random(3);
    event::Judged judged;
    judged.step.row.T = test::random_pose(random, 1.0);
    judged.step.row.sigma_rad = random.normal() * 1e-5;
    judged.step.row.sentence = "überlappt zu 38 % (≥ 40 %)";
    judged.step.evidence = {"overlap 0.38 < 0.40", "", "\"slip\"\t1.2 > 1.0 mm"};
    event::Exposed exposed;
    exposed.record.before = RobotReading{{0.1, 0.2, 0.3, -0.0, 1e-300, random.normal()},
                                         test::random_pose(random, 3.0)};
    return {encode(TurnPlan{}), encode(Input(Command(command::Accept{"seen,\nlooks \\ well"}))),
            encode(Input(Event(exposed))), encode(Input(Event(judged))),
            encode(Input(Event(event::ProgramEnded{})))};
}

TEST(JournalInput, ComesBackFromTheFileToTheLastBit) {
    const test::TemporaryFolder folder;
    const auto records = some_records();
    {
        auto journal =
            JournalFile::create(folder / "journal", "0.2.0", std::span(records).first(2));
        ASSERT_TRUE(journal) << journal.error().message;
        for (const auto& record : std::span(records).subspan(2)) {
            ASSERT_TRUE(journal->write(record.event, record.fields));
        }
    }
    const auto content = read_journal(folder / "journal");
    ASSERT_TRUE(content) << content.error().message;
    ASSERT_EQ(content->entries.size(), records.size());
    const auto plan = decode_plan(content->entries[0].fields);
    ASSERT_TRUE(plan) << plan.error().message;
    EXPECT_EQ(encode(*plan).fields, records[0].fields);
    for (std::size_t i = 1; i < records.size(); ++i) {
        const auto& entry = content->entries[i];
        const auto input = decode_input(entry.event, entry.fields);
        ASSERT_TRUE(input) << input.error().message;
        EXPECT_EQ(encode(input->value()).fields, records[i].fields);
    }
}

}  // namespace
}  // namespace gripscan
