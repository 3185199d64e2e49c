#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/ui_driver.h"
#include "ui/widgets/splitter.h"
#include "ui/widgets/toast_queue.h"

namespace gripscan::ui {
namespace {

struct Edge {
    int x = 100;
    bool reset = false;
    test::UiDriver driver{
        400, 200, [this](const Ui& ui) {
            const auto event = splitter(ui, {x, 0, 4, 200}, "edge", SplitterWay::kLeftRight);
            x += event.moved_px;
            reset |= event.reset;
        }};
};

TEST(Splitter, FollowsTheMouseWhileItIsHeld) {
    Edge edge;
    ASSERT_TRUE(edge.driver.hover("edge"));
    edge.driver.mouse(104, 100);
    EXPECT_EQ(edge.x, 100);
    edge.driver.press(ImGuiMouseButton_Left, true);
    edge.driver.mouse(134, 100);
    EXPECT_EQ(edge.x, 130);
    edge.driver.mouse(124, 50);
    EXPECT_EQ(edge.x, 120);
    edge.driver.press(ImGuiMouseButton_Left, false);
    edge.driver.mouse(300, 50);
    EXPECT_EQ(edge.x, 120);
    EXPECT_FALSE(edge.reset);
}

TEST(Splitter, ADoubleClickAsksForTheDefault) {
    Edge edge;
    ASSERT_TRUE(edge.driver.click("edge"));
    EXPECT_FALSE(edge.reset);
    ASSERT_TRUE(edge.driver.click("edge"));
    EXPECT_TRUE(edge.reset);
    EXPECT_EQ(edge.x, 100);
}

std::vector<std::string> ids(const ToastQueue& queue) {
    std::vector<std::string> all;
    for (const Toast& toast : queue.shown()) all.push_back(toast.id);
    return all;
}

Toast toast(std::string id) {
    Toast t;
    t.id = std::move(id);
    return t;
}

TEST(ToastQueue, ShowsEachForSixSeconds) {
    ToastQueue queue;
    EXPECT_TRUE(std::isinf(queue.next_end_s()));
    queue.add(toast("a"), 10.0);
    queue.add(toast("b"), 12.0);
    EXPECT_EQ(queue.next_end_s(), 16.0);
    queue.forget_old(15.9);
    EXPECT_THAT(ids(queue), testing::ElementsAre("a", "b"));
    queue.forget_old(16.0);
    EXPECT_THAT(ids(queue), testing::ElementsAre("b"));
    queue.forget_old(100.0);
    EXPECT_TRUE(queue.shown().empty());
}

TEST(ToastQueue, TheSameNewsReplacesItselfAndTheOldestMakeRoom) {
    ToastQueue queue;
    for (const char* id : {"a", "b", "a"}) queue.add(toast(id), 1.0);
    EXPECT_THAT(ids(queue), testing::ElementsAre("b", "a"));
    for (const char* id : {"c", "d", "e"}) queue.add(toast(id), 2.0);
    EXPECT_THAT(ids(queue), testing::ElementsAre("a", "c", "d", "e"));
    queue.close("c");
    queue.close("never shown");
    EXPECT_THAT(ids(queue), testing::ElementsAre("a", "d", "e"));
}

}  // namespace
}  // namespace gripscan::ui
