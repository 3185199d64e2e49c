#include "tests/window/outside_driver.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

namespace gripscan::test {
namespace {
namespace fs = std::filesystem;
using namespace std::chrono_literals;

void run_xdotool(const std::vector<std::string>& arguments) {
    const pid_t child = ::fork();
    if (child == 0) {
        std::vector<char*> argv{const_cast<char*>("xdotool")};
        for (const auto& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
        argv.push_back(nullptr);
        ::execvp("xdotool", argv.data());
        ::_exit(127);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
}

std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// GRIPSCAN_WINDOW_PATIENCE=10 waits ten times as long: under a sanitizer.
double patience() {
    const char* factor = std::getenv("GRIPSCAN_WINDOW_PATIENCE");
    return factor != nullptr ? std::atof(factor) : 1.0;
}

template <typename Condition>
bool wait_until(double patience_s, const Condition& condition) {
    const auto end =
        std::chrono::steady_clock::now() + std::chrono::duration<double>(patience_s * patience());
    while (!condition()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(20ms);
    }
    return true;
}

}  // namespace

OutsideDriver::OutsideDriver(const fs::path& home, const std::vector<std::string>& arguments)
    : screen_(VirtualScreen::make()), home_(home) {
    if (!screen_) return;
    fs::create_directories(home);
    std::error_code ignored;
    fs::remove(home / "widgets.json", ignored);
    program_ = ::fork();
    if (program_ != 0) return;
    ::setenv("HOME", home.c_str(), 1);
    ::setenv("XDG_STATE_HOME", (home / "state").c_str(), 1);
    ::setenv("XDG_CONFIG_HOME", (home / "config").c_str(), 1);
    ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    const int err = ::open((home / "stderr.txt").c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
    ::dup2(err, STDERR_FILENO);
    const std::string widgets = (home / "widgets.json").string();
    std::vector<char*> argv{const_cast<char*>(GRIPSCAN_PROGRAM)};
    for (const auto& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
    argv.push_back(const_cast<char*>("--widgets"));
    argv.push_back(const_cast<char*>(widgets.c_str()));
    argv.push_back(nullptr);
    ::execv(GRIPSCAN_PROGRAM, argv.data());
    ::_exit(127);
}

OutsideDriver::~OutsideDriver() {
    if (running()) kill_now();
}

nlohmann::json OutsideDriver::controls() const {
    return nlohmann::json::parse(text_of(home_ / "widgets.json"), nullptr, false);
}

std::optional<OutsideDriver::Control> OutsideDriver::find(const std::string& id) const {
    const auto list = controls();
    if (list.is_discarded() || !list.contains("widgets")) return std::nullopt;
    for (const auto& widget : list["widgets"]) {
        if (widget["id"] != id) continue;
        const auto& rect = widget["rect"];
        return Control{widget["label"],
                       rect[0].get<int>() + rect[2].get<int>() / 2,
                       rect[1].get<int>() + rect[3].get<int>() / 2,
                       widget["enabled"],
                       widget["reason"],
                       widget["keyboard"]};
    }
    return std::nullopt;
}

bool OutsideDriver::wait_for(const std::string& id, double patience_s) const {
    return wait_until(patience_s,
                      [&] {
                          const auto control = find(id);
                          return (control && control->enabled) || !running();
                      }) &&
           running();
}

std::optional<std::string> OutsideDriver::first_of(const std::vector<std::string>& ids,
                                                   double patience_s) const {
    std::optional<std::string> found;
    (void)wait_until(patience_s, [&] {
        for (const auto& id : ids) {
            const auto control = find(id);
            if (control && control->enabled) found = id;
        }
        return found || !running();
    });
    return found;
}

bool OutsideDriver::press(const std::string& id, int button, double patience_s) const {
    if (!wait_for(id, patience_s)) return false;
    const auto control = find(id);
    if (!control) return false;
    run_xdotool({"mousemove", std::to_string(control->x), std::to_string(control->y)});
    std::this_thread::sleep_for(60ms);
    run_xdotool({"mousedown", std::to_string(button)});
    std::this_thread::sleep_for(60ms);
    run_xdotool({"mouseup", std::to_string(button)});
    std::this_thread::sleep_for(60ms);
    return true;
}

bool OutsideDriver::click(const std::string& id, double patience_s) const {
    return press(id, 1, patience_s);
}

bool OutsideDriver::begin(const std::string& id, double patience_s) const {
    return click(id, patience_s) && taken(id);
}

bool OutsideDriver::taken(const std::string& id) const {
    constexpr double kReaction_s = 10.0;
    return wait_until(kReaction_s, [&] {
        const auto control = find(id);
        return !control || !control->enabled;
    });
}

bool OutsideDriver::enter(const std::string& id, const std::string& text) const {
    if (!click(id)) return false;
    constexpr double kReaction_s = 10.0;
    const auto has_keyboard = [&] {
        const auto control = find(id);
        return control && control->has_keyboard;
    };
    if (!wait_until(kReaction_s, has_keyboard)) return false;
    key("ctrl+a");
    type(text);
    return true;
}

bool OutsideDriver::wait_for_file(const fs::path& file) const {
    constexpr double kWork_s = 120.0;
    return wait_until(kWork_s, [&] { return fs::exists(file); });
}

bool OutsideDriver::right_click(const std::string& id, double patience_s) const {
    return press(id, 3, patience_s);
}

void OutsideDriver::key(const std::string& name) const {
    run_xdotool({"key", "--delay", "60", name});
    std::this_thread::sleep_for(100ms);
}

void OutsideDriver::type(const std::string& text) const {
    run_xdotool({"type", "--delay", "40", text});
    std::this_thread::sleep_for(100ms);
}

bool OutsideDriver::running() const {
    if (program_ <= 0 || status_) return false;
    int status = 0;
    if (::waitpid(program_, &status, WNOHANG) == 0) return true;
    status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return false;
}

void OutsideDriver::kill_now() {
    ::kill(program_, SIGKILL);
    (void)wait_for_end();
}

int OutsideDriver::wait_for_end(double patience_s) {
    (void)wait_until(patience_s, [&] { return !running(); });
    return status_.value_or(-1);
}

std::string OutsideDriver::error_text() const {
    std::string text = text_of(home_ / "stderr.txt");
    const auto list = controls();
    if (list.is_discarded() || !list.contains("widgets")) return text + "no list of controls\n";
    for (const auto& widget : list["widgets"]) {
        const auto id = widget["id"].get<std::string>();
        if (!id.starts_with("step.") && !id.starts_with("status.")) continue;
        text += id + " '" + widget["label"].get<std::string>() + "'" +
                (widget["enabled"].get<bool>() ? "" : " is grey: ") +
                widget["reason"].get<std::string>() + "\n";
    }
    return text;
}

}  // namespace gripscan::test
