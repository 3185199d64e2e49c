// Draws lines into the bound target, over a cloud whose depth is known.
#pragma once

#include "ui/gl/shader_program.h"
#include "ui/layout/scale.h"
#include "ui/render/line_batch.h"

namespace gripscan::ui {

class LinePass {
  public:
    [[nodiscard]] static Result<LinePass> make();
    void draw(const LineBatch& lines, const OrbitCamera& camera, const Viewport& viewport,
              const ClipRange& range, Scale scale, GLuint cloud_depth) const;

  private:
    explicit LinePass(ShaderProgram program);
    ShaderProgram program_;
    GlBuffer vertices_;
    GlVertexArray attributes_;
};

}  // namespace gripscan::ui
