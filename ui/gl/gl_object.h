// Names of OpenGL that delete themselves. Create and destroy them while the context is current.
#pragma once

#include <epoxy/gl.h>

#include <utility>

namespace gripscan::ui {

/// Owns one name; movable, not copyable. Kind says how a name is made and deleted.
template <typename Kind>
class GlObject {
  public:
    GlObject() : name_(Kind::create()) {}
    ~GlObject() { reset(); }
    GlObject(const GlObject&) = delete;
    GlObject& operator=(const GlObject&) = delete;
    GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        if (this != &other) {
            reset();
            name_ = std::exchange(other.name_, 0);
        }
        return *this;
    }

    /// 0 after it was moved from.
    [[nodiscard]] GLuint name() const { return name_; }

  private:
    void reset() {
        if (name_ != 0) Kind::destroy(name_);
        name_ = 0;
    }
    GLuint name_;
};

struct BufferKind {
    static GLuint create() {
        GLuint name = 0;
        glGenBuffers(1, &name);
        return name;
    }
    static void destroy(GLuint name) { glDeleteBuffers(1, &name); }
};
struct VertexArrayKind {
    static GLuint create() {
        GLuint name = 0;
        glGenVertexArrays(1, &name);
        return name;
    }
    static void destroy(GLuint name) { glDeleteVertexArrays(1, &name); }
};
struct TextureKind {
    static GLuint create() {
        GLuint name = 0;
        glGenTextures(1, &name);
        return name;
    }
    static void destroy(GLuint name) { glDeleteTextures(1, &name); }
};
struct FramebufferKind {
    static GLuint create() {
        GLuint name = 0;
        glGenFramebuffers(1, &name);
        return name;
    }
    static void destroy(GLuint name) { glDeleteFramebuffers(1, &name); }
};
struct ProgramKind {
    static GLuint create() { return glCreateProgram(); }
    static void destroy(GLuint name) { glDeleteProgram(name); }
};
struct VertexShaderKind {
    static GLuint create() { return glCreateShader(GL_VERTEX_SHADER); }
    static void destroy(GLuint name) { glDeleteShader(name); }
};
struct FragmentShaderKind {
    static GLuint create() { return glCreateShader(GL_FRAGMENT_SHADER); }
    static void destroy(GLuint name) { glDeleteShader(name); }
};

using GlBuffer = GlObject<BufferKind>;
using GlVertexArray = GlObject<VertexArrayKind>;
using GlTexture = GlObject<TextureKind>;
using GlFramebuffer = GlObject<FramebufferKind>;

}  // namespace gripscan::ui
