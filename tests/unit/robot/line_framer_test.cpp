#include "core/robot/line_framer.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/seeded_random.h"

namespace gripscan {
namespace {

using testing::ElementsAre;

/// What came out, as short texts: lines as they are, "<200>" for an overlong one, "!" for a break.
std::vector<std::string> taken(LineFramer& framer) {
    std::vector<std::string> all;
    while (const auto item = framer.next()) {
        if (const auto* line = std::get_if<Line>(&*item)) all.push_back(line->text);
        if (const auto* line = std::get_if<OverlongLine>(&*item)) {
            all.push_back(fmt::format("<{}>", line->length));
        }
        if (std::holds_alternative<BrokenStream>(*item)) all.push_back("!");
    }
    return all;
}

std::vector<std::string> framed(std::string_view bytes) {
    LineFramer framer;
    framer.feed(bytes);
    return taken(framer);
}

TEST(LineFramer, TakesEveryLineEndAndSkipsEmptyLines) {
    EXPECT_THAT(framed("a\r\nb\nc\rd\r\n\r\n\n\re\n"), ElementsAre("a", "b", "c", "d", "e"));
    EXPECT_THAT(framed("no end"), ElementsAre());
}

TEST(LineFramer, DoesNotCareWhereSegmentsEnd) {
    const std::string bytes = "POS\r\nSTATE\rHELLO 1\n" + std::string(230, 'x') + "\r\nSTOP\r\n";
    const auto whole = framed(bytes);
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SeededRandom random(seed);
        LineFramer framer;
        std::vector<std::string> all;
        for (std::size_t at = 0; at < bytes.size();) {
            const auto length = static_cast<std::size_t>(random.uniform(1.0, 20.0));
            framer.feed(std::string_view(bytes).substr(at, length));
            for (auto& text : taken(framer)) all.push_back(std::move(text));
            at += length;
        }
        EXPECT_EQ(all, whole) << "seed " << seed;
    }
}

TEST(LineFramer, TellsLongLinesFromUnbearableOnes) {
    EXPECT_THAT(framed(std::string(200, 'a') + "\n"), ElementsAre(std::string(200, 'a')));
    EXPECT_THAT(framed(std::string(201, 'a') + "\nPOS\n"), ElementsAre("<201>", "POS"));
    EXPECT_THAT(framed(std::string(254, 'a') + "\nPOS\n"), ElementsAre("<254>", "POS"));
    // Broken as soon as it is known, and for good.
    EXPECT_THAT(framed("STATE\n" + std::string(255, 'a')), ElementsAre("STATE", "!"));
    EXPECT_THAT(framed(std::string(255, 'a') + "\nPOS\n"), ElementsAre("!"));
}

TEST(LineFramer, BreaksAtBytesThatAreNotAscii) {
    EXPECT_THAT(framed("POS\nPO\xC3\x9F\nPOS\n"), ElementsAre("POS", "!"));
}

}  // namespace
}  // namespace gripscan
