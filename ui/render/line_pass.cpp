#include "ui/render/line_pass.h"

#include <cstddef>

namespace gripscan::ui {
namespace {

constexpr float kOnSurface_m = 0.0008F;

void attribute(GLuint index, GLint count, GLenum type, GLboolean normalised, std::size_t offset) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, count, type, normalised, sizeof(LineVertex),
                          reinterpret_cast<const void*>(offset));
}

}  // namespace

LinePass::LinePass(ShaderProgram program) : program_(std::move(program)) {
    glBindVertexArray(attributes_.name());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    attribute(0, 3, GL_FLOAT, GL_FALSE, offsetof(LineVertex, x_px));
    attribute(1, 3, GL_FLOAT, GL_FALSE, offsetof(LineVertex, along_px));
    attribute(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(LineVertex, colour));
    attribute(3, 1, GL_FLOAT, GL_FALSE, offsetof(LineVertex, hidden));
    attribute(4, 4, GL_FLOAT, GL_FALSE, offsetof(LineVertex, dash_px));
    glBindVertexArray(0);
}

Result<LinePass> LinePass::make() {
    auto program = ShaderProgram::load("lines.vert", "lines.frag");
    if (!program) return forward_error(program.error());
    return LinePass(*std::move(program));
}

void LinePass::draw(const LineBatch& lines, const OrbitCamera& camera, const Viewport& viewport,
                    const ClipRange& range, Scale scale, GLuint cloud_depth) const {
    const auto vertices = line_vertices(lines, camera, viewport, range, scale.factor());
    if (vertices.empty()) return;
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    program_.use();
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, cloud_depth);
    program_.set("cloud_depth", 0);
    program_.set("size_px", Eigen::Vector2f(static_cast<float>(viewport.width_px),
                                            static_cast<float>(viewport.height_px)));
    program_.set("near_m", static_cast<float>(range.near_m));
    program_.set("far_m", static_cast<float>(range.far_m));
    program_.set("tolerance_m", kOnSurface_m);
    glBindVertexArray(attributes_.name());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(LineVertex)),
                 vertices.data(), GL_STREAM_DRAW);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size()));
    glBindVertexArray(0);
    glDisable(GL_BLEND);
}

}  // namespace gripscan::ui
