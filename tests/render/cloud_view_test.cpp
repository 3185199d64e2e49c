#include "ui/render/cloud_view.h"

#include <gtest/gtest.h>

#include "tests/render/synthetic_cell.h"
#include "tests/support/egl_context.h"
#include "tests/support/golden_image.h"
#include "ui/gl/gl_object.h"

namespace gripscan::ui {
namespace {

constexpr int kWidth = 900;
constexpr int kHeight = 578;

class CloudPictures : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_NE(context_, nullptr);
        auto made = CloudView::make();
        ASSERT_TRUE(made.has_value()) << made.error().message;
        view_ = *std::move(made);
        camera_.yaw_rad = 0.45;
        camera_.pitch_rad = 0.35;
        camera_ = fitted(camera_, {{-0.13, -0.1, 0.6}, {0.2, 0.1, 0.8}},
                         {static_cast<double>(kWidth), static_cast<double>(kHeight)});
    }

    /// Frames until every point is drawn.
    test::Picture picture(const ViewSettings& settings, ThemeChoice choice,
                          const std::vector<PointChunk>& chunks, float scale = 1.0F) {
        const Theme theme = load_theme(choice).value();
        const LineBatch lines = test::synthetic_lines(theme, camera_.eye_m());
        const int width = static_cast<int>(kWidth * scale);
        const int height = static_cast<int>(kHeight * scale);
        do {
            const auto drawn = view_->draw({chunks, &lines, camera_, settings}, width, height,
                                           theme, Scale(scale), 0.0);
            EXPECT_TRUE(drawn.has_value()) << drawn.error().message;
        } while (!view_->complete());
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
        return {width, height, view_->read_rgba()};
    }

    std::unique_ptr<test::EglContext> context_ = test::EglContext::make();
    std::unique_ptr<CloudView> view_;
    OrbitCamera camera_;
};

TEST_F(CloudPictures, OfAPartColouredByStepLookAsApproved) {
    const auto chunks = test::synthetic_part(400000, 36);
    const ViewSettings by_step{.colour_by = ColourBy::kStep, .range_from = 1, .range_to = 36};
    test::expect_golden(picture(by_step, ThemeChoice::kDark, chunks), "cloud-step-dark");
}

TEST_F(CloudPictures, InTheLightThemeAt200PercentLookAsApproved) {
    const auto chunks = test::synthetic_part(400000, 36);
    const ViewSettings by_step{.colour_by = ColourBy::kStep, .range_from = 1, .range_to = 36};
    test::expect_golden(picture(by_step, ThemeChoice::kLight, chunks, 2.0F),
                        "cloud-step-light-200");
}

TEST_F(CloudPictures, OfTwoCloudsLookAsApproved) {
    const Theme theme = load_theme(ThemeChoice::kDark).value();
    auto chunks = test::synthetic_part(150000, 1);
    chunks.push_back(chunks[0]);
    chunks[1].id = 2;
    chunks[0].colour = theme.target;
    chunks[1].colour = theme.source;
    chunks[1].T_world_cloud = turn_about({{0, 0, 0.7}, Eigen::Vector3d::UnitX()}, 0.25);
    test::expect_golden(picture({.colour_by = ColourBy::kChunk}, ThemeChoice::kDark, chunks),
                        "cloud-two-dark");
}

std::size_t different(const test::Picture& a, const test::Picture& b) {
    return test::different_pixels(a, b);
}

TEST_F(CloudPictures, EveryColouringShowsSomethingElse) {
    const auto chunks = test::synthetic_part(60000, 4);
    std::vector<test::Picture> pictures;
    for (const ViewSettings& settings : std::vector<ViewSettings>{
             {.colour_by = ColourBy::kImage},
             {.colour_by = ColourBy::kStep, .range_from = 1, .range_to = 4},
             {.colour_by = ColourBy::kResidual, .range_from = 0, .range_to = 0.0006},
             {.colour_by = ColourBy::kSeen, .range_from = 4, .range_to = 24},
             {.colour_by = ColourBy::kDepth, .range_from = 0.76, .range_to = 0.64},
             {.colour_by = ColourBy::kNormal},
             {.colour_by = ColourBy::kSigma, .range_from = 0, .range_to = 0.0004},
             {.colour_by = ColourBy::kChunk}}) {
        pictures.push_back(picture(settings, ThemeChoice::kDark, chunks));
        for (std::size_t i = 0; i + 1 < pictures.size(); ++i) {
            EXPECT_GT(different(pictures[i], pictures.back()), 5000U)
                << i << " and " << pictures.size() - 1;
        }
    }
}

TEST_F(CloudPictures, SlicesAddUpToThePictureDrawnAtOnce) {
    // 350 000 points exceed the first budget: the first picture comes in slices, the second, after
    // quick frames have raised the budget, at once.
    const auto chunks = test::synthetic_part(350000, 3);
    const ViewSettings settings{.colour_by = ColourBy::kNormal};
    const test::Picture in_slices = picture(settings, ThemeChoice::kDark, chunks);
    const Theme theme = load_theme(ThemeChoice::kDark).value();
    OrbitCamera elsewhere = camera_;
    for (int i = 0; i < 6; ++i) {
        elsewhere.yaw_rad += 0.01;
        ASSERT_TRUE(view_->draw({chunks, nullptr, elsewhere, settings}, kWidth, kHeight, theme,
                                Scale(), 1.0));
    }
    ASSERT_GT(view_->level_of_detail().budget(), 350000U);
    EXPECT_EQ(different(in_slices, picture(settings, ThemeChoice::kDark, chunks)), 0U);
}

TEST_F(CloudPictures, AnEmptySceneIsTheBackground) {
    const test::Picture empty = [&] {
        const Theme theme = load_theme(ThemeChoice::kDark).value();
        EXPECT_TRUE(view_->draw({{}, nullptr, camera_, {}}, 64, 48, theme, Scale(), 0.0));
        return test::Picture{64, 48, view_->read_rgba()};
    }();
    EXPECT_TRUE(view_->complete());
    EXPECT_FALSE(view_->bounds().valid());
    const Theme theme = load_theme(ThemeChoice::kDark).value();
    EXPECT_NEAR(empty.rgba[0], theme.view_top.r, 1);
    EXPECT_NEAR(empty.rgba[4 * 64 * 47], theme.view_bottom.r, 1);
}

TEST_F(CloudPictures, AHiddenChunkIsNotSeenAndANewGenerationIs) {
    auto chunks = test::synthetic_part(60000, 2);
    const ViewSettings settings{.colour_by = ColourBy::kImage};
    const test::Picture both = picture(settings, ThemeChoice::kDark, chunks);
    chunks[1].visible = false;
    const test::Picture one = picture(settings, ThemeChoice::kDark, chunks);
    EXPECT_GT(different(both, one), 5000U);
    chunks[1].visible = true;
    EXPECT_EQ(different(both, picture(settings, ThemeChoice::kDark, chunks)), 0U);

    auto dark = std::make_shared<Cloud>(*chunks[1].cloud);
    std::fill(dark->intensity.begin(), dark->intensity.end(), 5.0F);
    chunks[1].cloud = dark;
    EXPECT_EQ(different(both, picture(settings, ThemeChoice::kDark, chunks)), 0U)
        << "chunks never change within a generation";
    chunks[1].generation = 1;
    EXPECT_GT(different(both, picture(settings, ThemeChoice::kDark, chunks)), 5000U);
}

TEST_F(CloudPictures, StartingAgainInTheSameContextDrawsTheSame) {
    const auto chunks = test::synthetic_part(30000, 1);
    const test::Picture first = picture({}, ThemeChoice::kDark, chunks);
    view_.reset();
    view_ = CloudView::make().value();
    EXPECT_EQ(different(first, picture({}, ThemeChoice::kDark, chunks)), 0U);
}

}  // namespace
}  // namespace gripscan::ui
