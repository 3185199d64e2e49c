#include "tests/support/egl_context.h"

#include <epoxy/egl.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace gripscan::test {

std::unique_ptr<EglContext> EglContext::make() {
    ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    // The EXT form: libepoxy aborts in eglGetPlatformDisplay before a display exists.
    EGLDisplay display =
        eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE) {
        ADD_FAILURE() << "no EGL display without a surface; is libgl1-mesa-dri installed?";
        return nullptr;
    }
    eglBindAPI(EGL_OPENGL_API);
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                             EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    eglChooseConfig(display, wanted, &config, 1, &count);
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                              3,
                              EGL_CONTEXT_MINOR_VERSION,
                              3,
                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                              EGL_NONE};
    EGLContext context =
        eglCreateContext(display, count > 0 ? config : nullptr, EGL_NO_CONTEXT, version);
    if (context == EGL_NO_CONTEXT ||
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE) {
        ADD_FAILURE() << "no OpenGL 3.3 core context (EGL error " << eglGetError() << ")";
        eglTerminate(display);
        return nullptr;
    }
    return std::unique_ptr<EglContext>(new EglContext(display, context));
}

EglContext::~EglContext() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    // The display stays: it is shared by the process, and a second test initialises it again.
}

}  // namespace gripscan::test
