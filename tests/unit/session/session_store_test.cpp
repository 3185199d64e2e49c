#include "core/session/session_store.h"

#include <gmock/gmock.h>

#include "core/camera/image_file.h"
#include "tests/support/small_recording.h"
#include "tests/support/temporary_folder.h"

namespace gripscan {
namespace {

namespace fs = std::filesystem;
using test::small_capture;
using test::small_frame;
using test::small_rig;
using testing::HasSubstr;

Result<SessionStore> create(const fs::path& folder) {
    SessionSpec spec;
    spec.step_deg = 10.0;
    spec.region = Box{{-0.1, -0.1, 0.5}, {0.1, 0.1, 0.8}};
    return SessionStore::create(folder, spec, small_rig(), "0.2.0");
}

void record(SessionStore& store, int captures) {
    std::vector<CaptureRecord> table;
    for (int k = 0; k < captures; ++k) {
        const Status stored = store.store_images(k, 1, small_frame(k));
        ASSERT_TRUE(stored) << stored.error().message;
        table.push_back(small_capture(k));
        const Status saved = store.save_table(table);
        ASSERT_TRUE(saved) << saved.error().message;
    }
}

TEST(SessionStore, LeavesAValidSessionAfterEveryCapture) {
    const test::TemporaryFolder folder;
    auto store = create(folder / "s");
    ASSERT_TRUE(store) << store.error().message;
    for (int captures = 2; captures < 5; ++captures) {
        record(*store, captures);
        const auto session = open_session(folder / "s");
        ASSERT_TRUE(session) << session.error().message;
        ASSERT_TRUE(check_session_files(*session, {}, for_each_in_order));
        ASSERT_EQ(session->table.rows.size(), static_cast<std::size_t>(captures));
        const int last = captures - 1;
        const CaptureRow& row = session->table.rows.back();
        const CaptureRecord capture = small_capture(last);
        EXPECT_EQ(row.commanded_deg, 10.0 * last) << "tidy numbers";
        EXPECT_NEAR(*row.joints_deg[5], deg_from_rad(capture.before->joints_rad[5]), 1e-9);
        EXPECT_NEAR(*row.j6_after_deg, deg_from_rad(*capture.joint6_after_rad), 1e-9);
        EXPECT_EQ(row.tool[0], 500.0);
        const auto left = load_grey_image(session->file(row.left));
        ASSERT_TRUE(left);
        EXPECT_EQ(cv::norm(*left, small_frame(last).left, cv::NORM_INF), 0.0)
            << "images are lossless";
    }
}

TEST(SessionStore, WhatIsNotKnownOfACaptureStaysEmpty) {
    const test::TemporaryFolder folder;
    auto store = create(folder / "s");
    ASSERT_TRUE(store);
    CaptureRecord first = small_capture(0);
    first.before.reset();
    first.joint6_after_rad.reset();
    CaptureRecord second = small_capture(1);
    second.attempt = 3;
    second.status = CaptureStatus::kExcluded;
    second.mode = TurnMode::kAxisLocked;
    second.note = "  a \"quoted\", worn jaw ";
    ASSERT_TRUE(store->save_table(std::vector{first, second}));
    const auto table =
        parse_capture_table("captures.csv", test::read_text(folder / "s/captures.csv"));
    ASSERT_TRUE(table) << table.error().message;
    EXPECT_EQ(table->rows[0].joints_deg[5], std::nullopt);
    EXPECT_EQ(table->rows[0].j6_after_deg, std::nullopt);
    EXPECT_EQ(table->rows[0].tool[3], std::nullopt);
    EXPECT_EQ(table->rows[0].mode, TurnMode::kFree);
    EXPECT_EQ(table->rows[0].note, "");
    EXPECT_EQ(table->rows[1].attempt, 3);
    EXPECT_EQ(table->rows[1].status, CaptureStatus::kExcluded);
    EXPECT_EQ(table->rows[1].mode, TurnMode::kAxisLocked);
    EXPECT_EQ(table->rows[1].note, "a \"quoted\", worn jaw");
}

TEST(SessionStore, NeverOverwrites) {
    const test::TemporaryFolder folder;
    test::write_text(folder / "s/captures.csv", "precious");
    const auto store = create(folder / "s");
    ASSERT_FALSE(store);
    EXPECT_THAT(store.error().message, HasSubstr("never overwritten"));
    EXPECT_EQ(test::read_text(folder / "s/captures.csv"), "precious");
    test::write_text(folder / "f", "precious");
    EXPECT_FALSE(create(folder / "f"));
    { ASSERT_TRUE(create(folder / "begun")); }
    EXPECT_FALSE(create(folder / "begun")) << "a session without captures is one already";
}

TEST(SessionStore, NothingOfTheLockIsLeftBehind) {
    const test::TemporaryFolder folder;
    { ASSERT_TRUE(create(folder / "s")); }
    EXPECT_FALSE(fs::exists(folder / "s" / std::string(FolderLock::kFileName)));
}

/// A crash at any moment of the creation: what was written so far, with the lock file.
TEST(SessionStore, ACreationThatWasCutShortBeginsAnew) {
    const test::TemporaryFolder folder;
    const std::vector<std::pair<std::string, std::string>> parts{
        {std::string(FolderLock::kFileName), "999999999\n"},
        {".rig.999999999.part.yaml", "%YAML"},
        {"rig.yaml", "%YAML"},
        {"session.yaml", "format"},
        {"journal", "{\"n\":1,\"t\""}};
    for (std::size_t written = 1; written <= parts.size(); ++written) {
        const fs::path session = folder / fmt::format("s{}", written);
        for (std::size_t i = 0; i < written; ++i) {
            test::write_text(session / parts[i].first, parts[i].second);
        }
        EXPECT_TRUE(is_fresh_session(session)) << written;
        auto store = create(session);
        ASSERT_TRUE(store) << written << ": " << store.error().message;
        EXPECT_FALSE(fs::exists(session / parts[1].first));
        record(*store, 2);
        EXPECT_TRUE(open_session(session));
        EXPECT_FALSE(is_fresh_session(session));
    }
}

TEST(SessionStore, AFolderMadeByHandIsNoCreationThatWasCutShort) {
    const test::TemporaryFolder folder;
    EXPECT_TRUE(is_fresh_session(folder / "absent"));
    EXPECT_TRUE(is_fresh_session(folder.path()));
    test::write_text(folder / "s/session.yaml", "precious");
    EXPECT_FALSE(is_fresh_session(folder / "s"));
    EXPECT_FALSE(create(folder / "s"));
    EXPECT_EQ(test::read_text(folder / "s/session.yaml"), "precious");
    test::write_text(folder / "s/.gripscan-lock", "1\n");
    test::write_text(folder / "s/frames/000_left.png", "precious");
    EXPECT_FALSE(is_fresh_session(folder / "s"));
}

TEST(SessionStore, OpeningClearsAwayWhatACrashLeftHalfAndKeepsUnknownColumns) {
    const test::TemporaryFolder folder;
    {
        auto store = create(folder / "s");
        ASSERT_TRUE(store);
        record(*store, 2);
    }
    test::write_text(folder / "s/.captures.999999999.part.csv", "index,comm");
    test::write_text(folder / "s/frames/.002_left.999999999.part.png", "half");
    test::write_text(folder / "s/.results.999999999.part/turns.csv", "old");
    std::string table = test::read_text(folder / "s/captures.csv");
    for (const auto& [row, cell] : {std::pair{0, "operator"}, {1, "Ann"}, {2, "Bob"}}) {
        std::size_t end = 0;
        for (int line = 0; line <= row; ++line) end = table.find('\n', end + 1);
        table.insert(end, fmt::format(",{}", cell));
    }
    test::write_text(folder / "s/captures.csv", table);
    auto store = SessionStore::open(folder / "s");
    ASSERT_TRUE(store) << store.error().message;
    EXPECT_FALSE(fs::exists(folder / "s/.captures.999999999.part.csv"));
    EXPECT_FALSE(fs::exists(folder / "s/frames/.002_left.999999999.part.png"));
    EXPECT_FALSE(fs::exists(folder / "s/.results.999999999.part"));
    ASSERT_TRUE(store->save_table(std::vector{small_capture(0), small_capture(1)}));
    EXPECT_EQ(test::read_text(folder / "s/captures.csv"), table);
    record(*store, 3);
    EXPECT_THAT(test::read_text(folder / "s/captures.csv"), HasSubstr(",Bob\n"));
}

}  // namespace
}  // namespace gripscan
