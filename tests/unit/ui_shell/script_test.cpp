#include "ui/shell/script.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gripscan::ui {
namespace {
using testing::HasSubstr;

TEST(Script, ReadsEveryStep) {
    const auto steps = parse_script(
        "# a tour\n"
        "\n"
        "click step.capture\n"
        "menu table.row.3\n"
        "key Ctrl+Z\n"
        "type 12.5 mm\n"
        "drag box.face.0 10 -4\n"
        "pause 0.5\n"
        "wait step.step\n"
        "wait window.export 900\n"
        "picture out.png\n"
        "say The first view.\n"
        "say\n",
        "tour.txt");
    ASSERT_TRUE(steps) << steps.error().message;
    ASSERT_EQ(steps->size(), 11U);
    EXPECT_EQ(std::get<script::Click>((*steps)[0]).id, "step.capture");
    EXPECT_EQ(std::get<script::RightClick>((*steps)[1]).id, "table.row.3");
    EXPECT_EQ(std::get<script::Type>((*steps)[3]).text, "12.5 mm");
    EXPECT_EQ(std::get<script::Drag>((*steps)[4]).dy_px, -4.0F);
    EXPECT_EQ(std::get<script::Pause>((*steps)[5]).seconds, 0.5);
    EXPECT_FALSE(std::get<script::WaitFor>((*steps)[6]).patience_s);
    EXPECT_EQ(std::get<script::WaitFor>((*steps)[7]).id, "window.export");
    EXPECT_EQ(std::get<script::WaitFor>((*steps)[7]).patience_s, 900.0);
    EXPECT_EQ(std::get<script::Picture>((*steps)[8]).file, "out.png");
    EXPECT_EQ(std::get<script::Say>((*steps)[9]).text, "The first view.");
    EXPECT_EQ(std::get<script::Say>((*steps)[10]).text, "");
}

TEST(Script, NamesTheLineThatMakesNoSense) {
    for (const char* bad :
         {"press step.capture", "click", "pause", "pause soon", "pause -1", "drag a 1", "picture",
          "key Spce", "key F13", "key", "wait", "wait a soon", "wait a -1", "wait a 3 4"}) {
        const auto steps = parse_script(std::string("key Space\n") + bad + "\n", "tour.txt");
        ASSERT_FALSE(steps) << bad;
        EXPECT_THAT(steps.error().message, HasSubstr("tour.txt:2")) << bad;
    }
}

}  // namespace
}  // namespace gripscan::ui
