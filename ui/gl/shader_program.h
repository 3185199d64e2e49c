// A shader program from two files of shaders/.
#pragma once

#include <Eigen/Core>
#include <string_view>

#include "core/base/result.h"
#include "ui/gl/gl_object.h"

namespace gripscan::ui {

class ShaderProgram {
  public:
    /// From shaders/`vertex_file` and shaders/`fragment_file`. The error is the compiler's, with
    /// the file it is about.
    [[nodiscard]] static Result<ShaderProgram> load(std::string_view vertex_file,
                                                    std::string_view fragment_file);

    void use() const { glUseProgram(program_.name()); }
    [[nodiscard]] GLuint name() const { return program_.name(); }

    /// Uniforms of the program in use. A name the compiler removed is ignored.
    void set(const char* uniform, int value) const;
    void set(const char* uniform, float value) const;
    void set(const char* uniform, const Eigen::Vector2f& value) const;
    void set(const char* uniform, const Eigen::Vector3f& value) const;
    void set(const char* uniform, const Eigen::Vector4f& value) const;
    void set(const char* uniform, const Eigen::Matrix4f& value) const;

  private:
    ShaderProgram() = default;
    [[nodiscard]] GLint location(const char* uniform) const {
        return glGetUniformLocation(program_.name(), uniform);
    }
    GlObject<ProgramKind> program_;
};

}  // namespace gripscan::ui
