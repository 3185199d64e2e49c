#include "ui/shell/input_queue.h"

#include <gtest/gtest.h>

namespace gripscan::ui {
namespace {

// Of GLFW.
constexpr int kA = 65;
constexpr int kB = 66;
constexpr int kSpace = 32;
constexpr int kEnter = 257;
constexpr int kTab = 258;
constexpr int kShift = 340;
constexpr int kCtrl = 341;

InputEvent down(int key) {
    return input::Key{key, 0, 0, true};
}
InputEvent up(int key) {
    return input::Key{key, 0, 0, false};
}
InputEvent typed(char c) {
    return input::Typed{static_cast<unsigned>(c)};
}
InputEvent cursor(double x) {
    return input::Cursor{x, 0.0};
}
InputEvent button(bool pressed) {
    return input::Button{0, pressed};
}

/// How many events each frame takes until nothing waits.
std::vector<std::size_t> frames(const std::vector<InputEvent>& events) {
    InputQueue queue;
    for (const InputEvent& event : events) queue.push(event);
    std::vector<std::size_t> sizes;
    while (!queue.empty()) {
        sizes.push_back(queue.take_frame().size());
        if (sizes.back() == 0) break;  // it would never end
    }
    return sizes;
}

using Sizes = std::vector<std::size_t>;

struct Case {
    const char* name;
    std::vector<InputEvent> events;
    Sizes sizes;
};

class InputFrames : public testing::TestWithParam<Case> {};

TEST_P(InputFrames, AreCutWhereOneWouldHideWhatHappened) {
    EXPECT_EQ(frames(GetParam().events), GetParam().sizes);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, InputFrames,
    testing::Values(
        Case{"Nothing", {}, {}}, Case{"AStroke", {down(kSpace), typed(' '), up(kSpace)}, {2, 1}},
        Case{"TwoStrokesOfAKey", {down(kTab), up(kTab), down(kTab), up(kTab)}, {1, 1, 1, 1}},
        Case{"ACommandByCtrl", {down(kCtrl), down(kA), up(kA), up(kCtrl)}, {2, 2}},
        Case{"CtrlIsLetGoFirst", {down(kCtrl), down(kA), up(kCtrl), up(kA)}, {2, 2}},
        Case{"WhatIsTypedAfterACommand",
             {down(kCtrl), down(kA), up(kA), up(kCtrl), down(kB), typed('b'), up(kB)},
             {2, 4, 1}},
        Case{"FastTyping", {down(kA), typed('a'), down(kB), typed('b'), up(kA), up(kB)}, {4, 2}},
        Case{"ACapital", {down(kShift), down(kA), typed('A'), up(kA), up(kShift)}, {3, 2}},
        Case{"EnterAfterALetter", {down(kA), typed('a'), down(kEnter)}, {2, 1}},
        Case{"ALetterAfterEnter", {down(kEnter), down(kA), typed('a')}, {1, 2}},
        Case{"AHeldLetterRepeats", {down(kA), typed('a'), typed('a'), typed('a')}, {4}},
        Case{"AClick", {cursor(1), cursor(2), button(true), button(false)}, {3, 1}},
        Case{"TheMouseGoesOnAfterAPress", {button(true), cursor(9), button(false)}, {1, 2}},
        Case{"TypingAfterAClick", {button(true), button(false), down(kA), typed('a')}, {1, 1, 2}},
        Case{"AClickAfterTyping", {down(kA), typed('a'), button(true)}, {2, 1}},
        Case{"MovesAloneAreOneFrame", {cursor(1), cursor(2), cursor(3)}, {3}}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(InputQueue, KeepsOrderAndLosesNothing) {
    InputQueue queue;
    for (int i = 0; i < 20; ++i) {
        queue.push(down(kA));
        queue.push(typed('a'));
        queue.push(up(kA));
    }
    int presses = 0;
    int letters = 0;
    bool is_down = false;
    while (!queue.empty()) {
        for (const InputEvent& event : queue.take_frame()) {
            if (const auto* key = std::get_if<input::Key>(&event)) {
                EXPECT_NE(key->down, is_down);
                is_down = key->down;
                presses += key->down ? 1 : 0;
            } else {
                ++letters;
            }
        }
    }
    EXPECT_EQ(presses, 20);
    EXPECT_EQ(letters, 20);
    EXPECT_FALSE(is_down);
}

}  // namespace
}  // namespace gripscan::ui
