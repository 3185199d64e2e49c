#include "app/workstation/export_template.h"

#include <gmock/gmock.h>

#include "tests/support/temporary_folder.h"

namespace gripscan::app {
namespace {
namespace fs = std::filesystem;
using testing::HasSubstr;

TurnReport small_turn() {
    TurnReport report;
    for (int i = 0; i < 400; ++i) {
        report.merged.points.emplace_back(0.001F * static_cast<float>(i % 20),
                                          0.001F * static_cast<float>(i / 20), 0.6F);
    }
    return report;
}

ui::ExportWish wish_for(const fs::path& file) {
    ui::ExportWish wish;
    wish.file = file;
    wish.filter.denoise_sigmas = 3.0;
    return wish;
}

/// What a user may find: temporary files would count.
std::size_t entries(const fs::path& folder) {
    const fs::directory_iterator all(folder);
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

TEST(ExportTemplate, WritesTheFileAndItsSidecar) {
    const test::TemporaryFolder folder;
    const auto done =
        export_template(small_turn(), wish_for(folder / "part.pcd"), {}, for_each_in_order);
    ASSERT_TRUE(done) << done.error().message;
    EXPECT_GT(done->points, 300U);
    EXPECT_TRUE(fs::exists(folder / "part.pcd.json"));
    EXPECT_EQ(entries(folder.path()), 2U);
}

/// Cancels when the export comes to a stage.
Progress cancelling_at(std::string_view stage, std::stop_source& stop) {
    return {stop.get_token(), [&stop, stage](std::string_view now, std::size_t, std::size_t) {
                if (now == stage) stop.request_stop();
            }};
}

class CancelledExport : public testing::TestWithParam<const char*> {};

TEST_P(CancelledExport, LeavesNothingBehind) {
    const test::TemporaryFolder folder;
    std::stop_source stop;
    const auto done = export_template(small_turn(), wish_for(folder / "part.pcd"),
                                      cancelling_at(GetParam(), stop), for_each_in_order);
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().kind, ErrorKind::kCancelled);
    EXPECT_EQ(entries(folder.path()), 0U);
}
INSTANTIATE_TEST_SUITE_P(Stages, CancelledExport, testing::Values("filter", "write", "sidecar"));

TEST(ExportTemplate, WithoutItsSidecarThereIsNoFile) {
    const test::TemporaryFolder folder;
    fs::create_directories(folder / "part.pcd.json" / "in the way");
    const auto done =
        export_template(small_turn(), wish_for(folder / "part.pcd"), {}, for_each_in_order);
    ASSERT_FALSE(done);
    EXPECT_THAT(done.error().message, HasSubstr("part.pcd.json"));
    EXPECT_FALSE(fs::exists(folder / "part.pcd"));
}

}  // namespace
}  // namespace gripscan::app
