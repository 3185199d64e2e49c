#include "ui/shell/glfw_window.h"

#include <epoxy/gl.h>
// After epoxy, which brings OpenGL's names itself.
#include <GLFW/glfw3.h>

#include <algorithm>
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

/// What fits on the monitor beside its bars.
GlfwWindow::Size fitting(GlfwWindow::Size wanted) {
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    if (monitor == nullptr) return wanted;
    int x = 0;
    int y = 0;
    GlfwWindow::Size room{};
    glfwGetMonitorWorkarea(monitor, &x, &y, &room.width_px, &room.height_px);
    if (room.width_px <= 0 || room.height_px <= 0) return wanted;
    return {std::min(wanted.width_px, room.width_px), std::min(wanted.height_px, room.height_px)};
}

}  // namespace

struct GlfwWindow::Callbacks {
    static GlfwWindow& of(GLFWwindow* handle) {
        return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(handle));
    }
    /// Notes that something came in.
    static News& news(GLFWwindow* handle) {
        News& news = of(handle).news_;
        news.anything = true;
        return news;
    }
    static void tell(GLFWwindow* handle, const InputEvent& event) {
        (void)news(handle);
        of(handle).input_.push(event);
    }

    static void cursor(GLFWwindow* w, double x, double y) { tell(w, input::Cursor{x, y}); }
    static void enter(GLFWwindow* w, int inside) { tell(w, input::Entered{inside == GLFW_TRUE}); }
    static void focus(GLFWwindow* w, int focused) { tell(w, input::Focus{focused == GLFW_TRUE}); }
    static void button(GLFWwindow* w, int which, int action, int) {
        tell(w, input::Button{which, action == GLFW_PRESS});
    }
    static void wheel(GLFWwindow* w, double dx, double dy) { tell(w, input::Wheel{dx, dy}); }
    static void key(GLFWwindow* w, int key, int scancode, int action, int mods) {
        // A held key repeats what it types; the window repeats the rest itself.
        if (action == GLFW_REPEAT) return;
        tell(w, input::Key{key, scancode, mods, action == GLFW_PRESS});
    }
    static void typed(GLFWwindow* w, unsigned character) { tell(w, input::Typed{character}); }

    static void refresh(GLFWwindow* w) { news(w).exposed = true; }
    static void size(GLFWwindow* w, int, int) { news(w).exposed = true; }
    static void scale(GLFWwindow* w, float, float) { (void)news(w); }
    static void close(GLFWwindow* w) { (void)news(w); }
    static void drop(GLFWwindow* w, int count, const char** paths) {
        for (int i = 0; i < count; ++i) news(w).dropped.emplace_back(paths[i]);
    }

    static void set(GLFWwindow* w) {
        glfwSetCursorPosCallback(w, cursor);
        glfwSetCursorEnterCallback(w, enter);
        glfwSetWindowFocusCallback(w, focus);
        glfwSetMouseButtonCallback(w, button);
        glfwSetScrollCallback(w, wheel);
        glfwSetKeyCallback(w, key);
        glfwSetCharCallback(w, typed);
        glfwSetWindowRefreshCallback(w, refresh);
        glfwSetFramebufferSizeCallback(w, size);
        glfwSetWindowContentScaleCallback(w, scale);
        glfwSetWindowCloseCallback(w, close);
        glfwSetDropCallback(w, drop);
    }
};

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
    glfwSetWindowUserPointer(handle, window.get());
    Callbacks::set(handle);
    return window;
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

void GlfwWindow::resize(Size wanted) {
    const Size size = fitting(wanted);
    glfwSetWindowSize(window_, size.width_px, size.height_px);
}

void GlfwWindow::keep_at_least(Size smallest) {
    const Size size = fitting(smallest);
    glfwSetWindowSizeLimits(window_, size.width_px, size.height_px, GLFW_DONT_CARE, GLFW_DONT_CARE);
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
