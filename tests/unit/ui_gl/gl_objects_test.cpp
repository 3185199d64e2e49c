#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/egl_context.h"
#include "ui/gl/gl_object.h"
#include "ui/gl/render_target.h"

namespace gripscan::ui {
namespace {

class GlObjects : public testing::Test {
  protected:
    void SetUp() override { ASSERT_NE(context_, nullptr); }
    std::unique_ptr<test::EglContext> context_ = test::EglContext::make();
};

/// Buffers exist for OpenGL once they were bound.
GlBuffer bound_buffer() {
    GlBuffer buffer;
    glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
    return buffer;
}

TEST_F(GlObjects, DeleteTheirNameAtTheEnd) {
    GLuint name = 0;
    {
        const GlBuffer buffer = bound_buffer();
        name = buffer.name();
        EXPECT_TRUE(glIsBuffer(name));
    }
    EXPECT_FALSE(glIsBuffer(name));
}

TEST_F(GlObjects, MovingHandsTheNameOver) {
    GlBuffer first = bound_buffer();
    const GLuint name = first.name();
    const GlBuffer second = std::move(first);
    EXPECT_EQ(second.name(), name);
    EXPECT_EQ(first.name(), 0U);  // NOLINT(bugprone-use-after-move): the state is documented
    EXPECT_TRUE(glIsBuffer(name));
}

TEST_F(GlObjects, MoveAssignmentDeletesWhatWasThere) {
    GlBuffer target = bound_buffer();
    GlBuffer source = bound_buffer();
    const GLuint old_name = target.name();
    const GLuint kept = source.name();
    target = std::move(source);
    EXPECT_FALSE(glIsBuffer(old_name));
    EXPECT_TRUE(glIsBuffer(kept));
    EXPECT_EQ(target.name(), kept);
}

TEST_F(GlObjects, AssigningToItselfKeepsTheName) {
    GlBuffer buffer = bound_buffer();
    GlBuffer& same = buffer;
    const GLuint name = buffer.name();
    buffer = std::move(same);
    EXPECT_EQ(buffer.name(), name);
    EXPECT_TRUE(glIsBuffer(name));
}

TEST_F(GlObjects, RenderTargetKeepsWhatWasDrawnTopRowFirst) {
    auto target = RenderTarget::make(4, 3, DepthTexture::kFloat32);
    ASSERT_TRUE(target.has_value()) << target.error().message;
    target->bind();
    glClearColor(0, 0, 1, 1);
    glClearDepth(0.25);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 2, 4, 1);  // the top row of OpenGL
    glClearColor(1, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
    const auto pixels = target->read_rgba();
    ASSERT_EQ(pixels.size(), 4U * 3U * 4U);
    EXPECT_EQ(pixels[0], 255);
    EXPECT_EQ(pixels[2], 0);
    EXPECT_EQ(pixels[16], 0);
    EXPECT_EQ(pixels[18], 255);
    EXPECT_THAT(target->read_depth(1, 1, 2, 1), testing::Each(testing::FloatEq(0.25F)));
}

TEST_F(GlObjects, RenderTargetRefusesImpossibleSizes) {
    for (const auto& [width, height] : {std::pair{0, 10}, {10, -1}, {20000, 10}}) {
        const auto target = RenderTarget::make(width, height, DepthTexture::kNone);
        ASSERT_FALSE(target.has_value());
        EXPECT_THAT(target.error().message, testing::HasSubstr("16384"));
    }
}

}  // namespace
}  // namespace gripscan::ui
