// An OpenGL 3.3 core context without a window, on Mesa's software rasteriser, so that pictures are
// the same everywhere.
#pragma once

#include <memory>

namespace gripscan::test {

class EglContext {
  public:
    /// Nothing where the machine has no EGL; the reason goes to the test's output.
    [[nodiscard]] static std::unique_ptr<EglContext> make();
    ~EglContext();
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

  private:
    EglContext(void* display, void* context) : display_(display), context_(context) {}
    void* display_;
    void* context_;
};

}  // namespace gripscan::test
