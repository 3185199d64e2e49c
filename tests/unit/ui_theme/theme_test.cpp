#include "ui/theme/theme.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "ui/resources/resource_file.h"
#include "ui/theme/colour_map.h"

namespace gripscan::ui {
namespace {

using testing::HasSubstr;

std::string dark_text() {
    return read_resource("assets/themes/dark.json").value();
}

std::string with(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

TEST(Theme, ReadsEveryTokenOfItsFile) {
    const auto theme = theme_from_json(dark_text(), "dark.json");
    ASSERT_TRUE(theme.has_value()) << theme.error().message;
    EXPECT_EQ(theme->name, "Dark");
    EXPECT_TRUE(theme->dark);
    EXPECT_EQ(theme->accent, (Colour{0x4C, 0x8D, 0xFF}));
    EXPECT_EQ(theme->plate.a, 0xD1);
    EXPECT_FALSE(load_theme(ThemeChoice::kLight)->dark);
}

TEST(Theme, NamesTheTokenThatIsWrong) {
    const auto error = [](const std::string& text) {
        const auto theme = theme_from_json(text, "mine.json");
        return theme ? std::string("accepted") : theme.error().message;
    };
    EXPECT_THAT(error(with(dark_text(), "\"check\":", "\"chock\":")), HasSubstr("'check'"));
    EXPECT_THAT(error(with(dark_text(), "#35C08E", "#35C08")), HasSubstr("'ok'"));
    EXPECT_THAT(error(with(dark_text(), "\"#35C08E\"", "7")), HasSubstr("'ok'"));
    EXPECT_THAT(error(with(dark_text(), "\"ok\":", "\"okay\": \"#000000\", \"ok\":")),
                HasSubstr("'okay'"));
    EXPECT_THAT(error(with(dark_text(), "theme/1", "theme/9")), HasSubstr("gripscan-theme/1"));
    EXPECT_THAT(error(with(dark_text(), "true", "\"yes\"")), HasSubstr("dark"));
    EXPECT_THAT(error("{"), HasSubstr("mine.json"));
    EXPECT_THAT(error("[]"), HasSubstr("mine.json"));
}

TEST(ColourText, IsSixOrEightHexadecimalDigits) {
    EXPECT_EQ(colour_from_text("#01aBff"), (Colour{1, 0xAB, 255, 255}));
    EXPECT_EQ(colour_from_text("#01020304"), (Colour{1, 2, 3, 4}));
    for (const char* bad : {"", "#", "010203", "#12345", "#1234567", "#12345g", "#123456789"}) {
        EXPECT_FALSE(colour_from_text(bad).has_value()) << bad;
    }
}

TEST(ColourMaps, LightnessRisesWithStepAndSeenCountAndNearness) {
    for (const ColourMap map : {ColourMap::kStep, ColourMap::kSeen, ColourMap::kDepth}) {
        double before = 0.0;
        for (int i = 0; i <= 20; ++i) {
            const double now = contrast(map_colour(map, i / 20.0), {0, 0, 0});
            EXPECT_GT(now, before) << static_cast<int>(map) << " at " << i;
            before = now;
        }
    }
}

TEST(ColourMaps, AreClampedAtTheirEnds) {
    EXPECT_EQ(map_colour(ColourMap::kStep, -1.0), map_colour(ColourMap::kStep, 0.0));
    EXPECT_EQ(map_colour(ColourMap::kStep, 7.0), map_colour(ColourMap::kStep, 1.0));
    EXPECT_EQ(map_colour(ColourMap::kStep, std::nan("")), map_colour(ColourMap::kStep, 0.0));
}

TEST(ColourMaps, TheTextureHoldsTheSameColours) {
    const auto bytes = map_bytes(ColourMap::kResidual);
    for (const std::size_t i : {0, 77, 255}) {
        const Colour c = map_colour(ColourMap::kResidual, static_cast<double>(i) / 255.0);
        EXPECT_EQ(bytes[4 * i], c.r);
        EXPECT_EQ(bytes[4 * i + 2], c.b);
    }
}

}  // namespace
}  // namespace gripscan::ui
