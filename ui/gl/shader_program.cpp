#include "ui/gl/shader_program.h"

#include <string>

#include "ui/resources/resource_file.h"

namespace gripscan::ui {
namespace {

template <typename Kind>
Status compile(const GlObject<Kind>& shader, std::string_view file) {
    const auto text = read_resource("shaders/" + std::string(file));
    if (!text) return forward_error(text.error());
    const char* source = text->c_str();
    glShaderSource(shader.name(), 1, &source, nullptr);
    glCompileShader(shader.name());
    GLint ok = GL_FALSE;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &ok);
    if (ok == GL_TRUE) return {};
    std::string log(4096, '\0');
    GLsizei length = 0;
    glGetShaderInfoLog(shader.name(), static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return input_error("shaders/{} does not compile: {}", file, log);
}

}  // namespace

Result<ShaderProgram> ShaderProgram::load(std::string_view vertex_file,
                                          std::string_view fragment_file) {
    const GlObject<VertexShaderKind> vertex;
    const GlObject<FragmentShaderKind> fragment;
    if (auto compiled = compile(vertex, vertex_file); !compiled) {
        return forward_error(compiled.error());
    }
    if (auto compiled = compile(fragment, fragment_file); !compiled) {
        return forward_error(compiled.error());
    }
    ShaderProgram program;
    glAttachShader(program.name(), vertex.name());
    glAttachShader(program.name(), fragment.name());
    glLinkProgram(program.name());
    glDetachShader(program.name(), vertex.name());
    glDetachShader(program.name(), fragment.name());
    GLint ok = GL_FALSE;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &ok);
    if (ok == GL_TRUE) return program;
    std::string log(4096, '\0');
    GLsizei length = 0;
    glGetProgramInfoLog(program.name(), static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return input_error("shaders/{} and shaders/{} do not link: {}", vertex_file, fragment_file,
                       log);
}

void ShaderProgram::set(const char* uniform, int value) const {
    glUniform1i(location(uniform), value);
}
void ShaderProgram::set(const char* uniform, float value) const {
    glUniform1f(location(uniform), value);
}
void ShaderProgram::set(const char* uniform, const Eigen::Vector2f& value) const {
    glUniform2fv(location(uniform), 1, value.data());
}
void ShaderProgram::set(const char* uniform, const Eigen::Vector3f& value) const {
    glUniform3fv(location(uniform), 1, value.data());
}
void ShaderProgram::set(const char* uniform, const Eigen::Vector4f& value) const {
    glUniform4fv(location(uniform), 1, value.data());
}
void ShaderProgram::set(const char* uniform, const Eigen::Matrix4f& value) const {
    glUniformMatrix4fv(location(uniform), 1, GL_FALSE, value.data());
}

}  // namespace gripscan::ui
