// The workstation without a window: a cloud is opened, its filters and its export are cancelled.
#include "app/workstation/workstation.h"

#include <gmock/gmock.h>

#include <chrono>
#include <numbers>
#include <thread>

#include "core/cloud/cloud_file.h"
#include "tests/support/temporary_folder.h"

namespace gripscan::app {
namespace {
namespace fs = std::filesystem;
using namespace std::chrono_literals;

/// A tube of many points, so that its filters take a while.
Cloud tube() {
    Cloud cloud;
    for (int i = 0; i < 300000; ++i) {
        const float turn = 2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / 700.0F;
        cloud.points.emplace_back(0.05F * std::cos(turn), 0.05F * std::sin(turn),
                                  0.5F + 1e-6F * static_cast<float>(i));
    }
    return cloud;
}

class OpenCloud : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_TRUE(save_cloud(folder_ / "tube.pcd", tube()));
        WorkstationSettings settings;
        settings.files = {folder_ / "sessions", folder_ / "state", folder_ / "preferences.json"};
        settings.wake = [] {};
        station_.emplace(std::move(settings));
        station_->take(ui::request::Open{folder_ / "tube.pcd"});
        ASSERT_TRUE(until([&] { return station_->snapshot().shown_template.has_value(); }));
    }
    template <typename Done>
    bool until(const Done& done) {
        for (int i = 0; i < 6000; ++i) {
            station_->pump(0.01 * i);
            if (done()) return true;
            std::this_thread::sleep_for(10ms);
        }
        return false;
    }
    [[nodiscard]] bool idle() const { return !station_->snapshot().job; }
    [[nodiscard]] std::vector<std::string> toasts() const {
        std::vector<std::string> titles;
        for (const auto& toast : station_->snapshot().toasts) titles.push_back(toast.title);
        return titles;
    }

    test::TemporaryFolder folder_;
    std::optional<Workstation> station_;
};

TEST_F(OpenCloud, ACancelledFilterLeavesTheOneBefore) {
    const TemplateFilter before = station_->snapshot().filter;
    TemplateFilter wanted = before;
    wanted.denoise_sigmas = 1.0;
    wanted.denoise_neighbours = 60;
    station_->take(ui::request::SetFilter{wanted});
    ASSERT_EQ(station_->snapshot().filter, wanted);
    ASSERT_TRUE(station_->snapshot().job);
    station_->take(ui::request::CancelJob{});
    const auto stopping = station_->snapshot().job;
    ASSERT_TRUE(stopping);
    EXPECT_EQ(stopping->name, "Filtering the template, stopping");
    EXPECT_FALSE(stopping->can_cancel);
    ASSERT_TRUE(until([&] { return idle(); }));
    const ui::Snapshot after = station_->snapshot();
    EXPECT_EQ(after.filter, before);
    EXPECT_EQ(after.shown_template->filter, before);
    EXPECT_EQ(after.shown_template->counts.kept, 300000U);
    EXPECT_THAT(toasts(), testing::Contains("Filtering cancelled"));
}

TEST_F(OpenCloud, ACancelledExportWritesNothing) {
    ui::ExportWish wish;
    wish.file = folder_ / "exports" / "tube.xyz";
    wish.encoding = PcdEncoding::kAscii;
    wish.filter.denoise_sigmas = 2.0;
    station_->take(ui::request::Export{wish});
    ASSERT_TRUE(station_->snapshot().job);
    station_->take(ui::request::CancelJob{});
    ASSERT_TRUE(until([&] { return idle(); }));
    EXPECT_FALSE(fs::exists(wish.file));
    EXPECT_FALSE(fs::exists(wish.file.string() + ".json"));
    EXPECT_EQ(station_->snapshot().dialog, ui::Dialog::kNone) << "cancelling is no error";
    EXPECT_THAT(toasts(), testing::Contains("Export cancelled"));
}

}  // namespace
}  // namespace gripscan::app
