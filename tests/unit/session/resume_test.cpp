#include "core/session/resume.h"

#include <gmock/gmock.h>
#include <signal.h>

#include <chrono>
#include <thread>

#include "core/base/seeded_random.h"
#include "core/session/journal_line.h"
#include "tests/support/child_process.h"
#include "tests/support/small_recording.h"
#include "tests/support/temporary_folder.h"

namespace gripscan {
namespace {

namespace fs = std::filesystem;
using test::small_capture;
using test::small_frame;
using test::small_rig;
using testing::HasSubstr;

std::string problem_of(const fs::path& folder) {
    const auto resumed = resume_session(folder);
    return resumed ? "no problem" : resumed.error().message;
}

/// What entry `number` of the loop below holds.
JournalFields fields_of(int number) {
    return {{"number", fmt::format("{}", number)},
            {"text", std::string(static_cast<std::size_t>(number * 37 % 300), 'x')}};
}

/// Records on and on: images, an entry that tells of them, then the table.
void record_on(SessionStore& store, int begin, int end = 1000) {
    std::vector<CaptureRecord> table;
    for (int k = 0; k < begin; ++k) table.push_back(small_capture(k));
    if (!store.save_table(table)) return;
    for (int k = begin; k < end; ++k) {
        if (!store.store_images(k, 1, small_frame(k))) return;
        if (!store.journal().write("event", fields_of(k))) return;
        table.push_back(small_capture(k));
        if (!store.save_table(table)) return;
    }
}

TEST(Resume, FindsWhatWasWrittenAndGoesOn) {
    const test::TemporaryFolder folder;
    {
        SessionSpec spec;
        spec.step_deg = 12.5;
        auto store = SessionStore::create(folder / "s", spec, small_rig(), "0.2.7",
                                          std::array{JournalRecord{"plan", {{"step", "a"}}}});
        ASSERT_TRUE(store) << store.error().message;
        ASSERT_TRUE(store->journal().write("command", {{"verb", "connect"}}));
    }
    {
        auto resumed = resume_session(folder / "s");
        ASSERT_TRUE(resumed) << resumed.error().message;
        EXPECT_EQ(resumed->memory.header.format, "gripscan-journal/2");
        EXPECT_EQ(resumed->memory.header.program, "0.2.7");
        EXPECT_EQ(resumed->memory.spec.step_deg, 12.5);
        EXPECT_EQ(resumed->memory.rig.image, small_rig().image);
        ASSERT_EQ(resumed->memory.entries.size(), 2u);
        EXPECT_EQ(resumed->memory.entries[0].event, "plan");
        EXPECT_EQ(resumed->memory.entries[1].fields, (JournalFields{{"verb", "connect"}}));
        ASSERT_TRUE(resumed->store.journal().write("event", {}));
        EXPECT_THAT(problem_of(folder / "s"), HasSubstr("open in another program"));
    }
    const auto memory = open_memory(folder / "s");
    ASSERT_TRUE(memory);
    EXPECT_EQ(memory->entries.size(), 3u);
}

TEST(Resume, DoesNotAskTheTable) {
    const test::TemporaryFolder folder;
    { ASSERT_TRUE(SessionStore::create(folder / "s", {}, small_rig(), "0.2.0")); }
    for (const std::string table : {"", "index,mode\n0,tilted\n", "index\n9\n"}) {
        test::write_text(folder / "s/captures.csv", table);
        auto resumed = resume_session(folder / "s");
        ASSERT_TRUE(resumed) << resumed.error().message;
        ASSERT_TRUE(resumed->store.save_table(std::vector{small_capture(0)}));
        const auto written =
            parse_capture_table("captures.csv", test::read_text(folder / "s/captures.csv"));
        ASSERT_TRUE(written) << written.error().message;
        ASSERT_EQ(written->rows.size(), 1u);
        EXPECT_EQ(written->rows[0].commanded_deg, 0.0);
    }
}

TEST(Resume, SaysWhyItCannotAndWhatCanBeDone) {
    const test::TemporaryFolder folder;
    EXPECT_THAT(problem_of(folder / "absent"), HasSubstr("does not exist"));
    test::write_text(folder / "file", "x");
    EXPECT_THAT(problem_of(folder / "file"), HasSubstr("not a folder"));
    { ASSERT_TRUE(SessionStore::create(folder / "s", {}, small_rig(), "0.2.0")); }
    const std::string header = test::read_text(folder / "s/journal");

    fs::remove(folder / "s/journal");
    EXPECT_THAT(problem_of(folder / "s"), HasSubstr("there is no journal"));
    EXPECT_THAT(problem_of(folder / "s"), HasSubstr("gripscan replay"));

    test::write_text(folder / "s/journal", header + "{\"n\":2}\n" + header);
    EXPECT_THAT(problem_of(folder / "s"), HasSubstr("journal:2: the line is damaged"));

    // Of a program to come, and of one gone by.
    test::write_text(
        folder / "s/journal",
        journal_line({1, "", "journal", {{"format", "gripscan-journal/3"}, {"program", "0.9.0"}}}));
    EXPECT_THAT(problem_of(folder / "s"), HasSubstr("gripscan-journal/3 by gripscan 0.9.0"));
    const std::string old =
        journal_line({1, "", "command", {{"verb", "run gripper"}, {"version", "0.1.0"}}});
    test::write_text(folder / "s/journal", old);
    EXPECT_THAT(problem_of(folder / "s"), HasSubstr("gripscan 0.1.0, whose journals cannot be"));
    EXPECT_EQ(test::read_text(folder / "s/journal"), old);
    EXPECT_FALSE(fs::exists(folder / "s/.gripscan-lock"));
}

/// How long a creation and some captures take on this disk.
double time_of_recording_s(const fs::path& folder) {
    const auto begin = std::chrono::steady_clock::now();
    auto store = SessionStore::create(folder, {}, small_rig(), "0.2.0");
    if (store) record_on(*store, 0, 4);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

TEST(Resume, KilledAtAnyMomentItOpensWithAllThatWasConfirmed) {
    const test::TemporaryFolder folder;
    SeededRandom random(20);
    const double usual_s = time_of_recording_s(folder / "timed");
    int recorded = 0;
    for (int kill = 0; kill < 30; ++kill) {
        const pid_t child = ::fork();
        if (child == 0) {
            if (is_fresh_session(folder / "s")) {
                auto store = SessionStore::create(folder / "s", {}, small_rig(), "0.2.0");
                if (store) record_on(*store, 0);
            } else {
                auto resumed = resume_session(folder / "s");
                if (resumed) {
                    record_on(resumed->store, static_cast<int>(resumed->memory.entries.size()));
                }
            }
            ::_exit(1);
        }
        std::this_thread::sleep_for(std::chrono::duration<double>(random.uniform(0.0, usual_s)));
        ::kill(child, SIGKILL);
        int status = 0;
        ASSERT_EQ(::waitpid(child, &status, 0), child);
        ASSERT_TRUE(WIFSIGNALED(status)) << "it went on until it was killed";
        if (is_fresh_session(folder / "s")) continue;
        const auto memory = open_memory(folder / "s");
        ASSERT_TRUE(memory) << memory.error().message;
        const int entries = static_cast<int>(memory->entries.size());
        ASSERT_GE(entries, recorded) << "nothing that was there is lost";
        for (int k = 0; k < entries; ++k) {
            ASSERT_EQ(memory->entries[static_cast<std::size_t>(k)].fields, fields_of(k));
        }
        recorded = entries;
        if (!fs::exists(folder / "s/captures.csv") || entries < 3) continue;
        const auto session = open_session(folder / "s");
        ASSERT_TRUE(session) << session.error().message;
        EXPECT_TRUE(check_session_files(*session, {}, for_each_in_order));
        EXPECT_LE(static_cast<int>(session->table.rows.size()), entries)
            << "no row of a capture that the journal does not know";
    }
    EXPECT_GT(recorded, 3) << "the kills came too early to mean anything";
}

}  // namespace
}  // namespace gripscan
