#include "ui/shell/glfw_window.h"

#include <epoxy/gl.h>
// After epoxy, which brings OpenGL's names itself.
#include <GLFW/glfw3.h>

#include <atomic>
#include <utility>

namespace gripscan::ui {
namespace {

std::atomic<bool> woken{false};

std::string glfw_reason() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text != nullptr ? text : "no reason given";
}

GlfwWindow::News& news_of(GLFWwindow* window) {
    return *static_cast<GlfwWindow::News*>(glfwGetWindowUserPointer(window));
}

/// A callback that only notes that something came in.
template <typename... Args>
void note(GLFWwindow* window, Args...) {
    news_of(window).anything = true;
}

template <typename... Args>
void note_exposed(GLFWwindow* window, Args...) {
    news_of(window).anything = true;
    news_of(window).exposed = true;
}

void note_drop(GLFWwindow* window, int count, const char** paths) {
    GlfwWindow::News& news = news_of(window);
    news.anything = true;
    for (int i = 0; i < count; ++i) news.dropped.emplace_back(paths[i]);
}

}  // namespace

Result<std::unique_ptr<GlfwWindow>> GlfwWindow::make(const std::string& title, int width_px,
                                                     int height_px) {
    if (glfwInit() != GLFW_TRUE) {
        return device_error(
            "no window can be opened here ({}); is DISPLAY set? The command line "
            "needs no screen: see gripscan --help",
            glfw_reason());
    }
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    GLFWwindow* handle = glfwCreateWindow(width_px, height_px, title.c_str(), nullptr, nullptr);
    if (handle == nullptr) {
        const std::string reason = glfw_reason();
        glfwTerminate();
        return device_error(
            "no window with OpenGL 3.3 can be opened ({}); update the graphics "
            "driver, or install libgl1-mesa-dri and set LIBGL_ALWAYS_SOFTWARE=1",
            reason);
    }
    std::unique_ptr<GlfwWindow> window(new GlfwWindow());
    window->window_ = handle;
    glfwMakeContextCurrent(handle);
    glfwSwapInterval(1);
    window->listen();
    return window;
}

void GlfwWindow::listen() {
    glfwSetWindowUserPointer(window_, &news_);
    // Set before Dear ImGui's own, which call these on.
    glfwSetCursorPosCallback(window_, note<double, double>);
    glfwSetCursorEnterCallback(window_, note<int>);
    glfwSetMouseButtonCallback(window_, note<int, int, int>);
    glfwSetScrollCallback(window_, note<double, double>);
    glfwSetKeyCallback(window_, note<int, int, int, int>);
    glfwSetCharCallback(window_, note<unsigned int>);
    glfwSetWindowFocusCallback(window_, note<int>);
    glfwSetWindowRefreshCallback(window_, note_exposed<>);
    glfwSetWindowCloseCallback(window_, note<>);
    glfwSetFramebufferSizeCallback(window_, note_exposed<int, int>);
    glfwSetWindowContentScaleCallback(window_, note<float, float>);
    glfwSetDropCallback(window_, note_drop);
}

GlfwWindow::~GlfwWindow() {
    if (window_ == nullptr) return;
    glfwDestroyWindow(window_);
    glfwTerminate();
}

GlfwWindow::News GlfwWindow::wait(double seconds) {
    if (seconds > 0.0 && !woken) {
        glfwWaitEventsTimeout(seconds);
    } else {
        glfwPollEvents();
    }
    news_.woken = woken.exchange(false);
    return std::exchange(news_, {});
}

void GlfwWindow::wake() {
    woken = true;
    glfwPostEmptyEvent();
}

GlfwWindow::Size GlfwWindow::framebuffer() const {
    Size size{};
    glfwGetFramebufferSize(window_, &size.width_px, &size.height_px);
    return size;
}

float GlfwWindow::content_scale() const {
    float x = 1.0F;
    float y = 1.0F;
    glfwGetWindowContentScale(window_, &x, &y);
    return x;
}

bool GlfwWindow::take_close_request() {
    const bool wanted = glfwWindowShouldClose(window_) == GLFW_TRUE;
    glfwSetWindowShouldClose(window_, GLFW_FALSE);
    return wanted;
}

LetterKeys GlfwWindow::letters() {
    return letter_keys([](char place) {
        const char* name = glfwGetKeyName(GLFW_KEY_A + (place - 'A'), 0);
        return std::string(name != nullptr ? name : "");
    });
}

void GlfwWindow::swap() {
    glfwSwapBuffers(window_);
}

}  // namespace gripscan::ui
