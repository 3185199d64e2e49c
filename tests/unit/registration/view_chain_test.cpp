// Which views belong together, as a table.
#include "core/registration/view_chain.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace gripscan {
namespace {

using Views = std::vector<std::size_t>;
using Bridges = std::set<std::pair<std::size_t, std::size_t>>;

struct Case {
    std::string name;
    std::vector<bool> steps;
    Bridges bridges;  ///< that would hold
    Views trusted;
    Views bridged;
};

class LinkViews : public testing::TestWithParam<Case> {};

TEST_P(LinkViews, AsTheTableSays) {
    const Case& c = GetParam();
    const ViewChain chain = link_views(c.steps, 3, [&](std::size_t from, std::size_t to) {
        EXPECT_GT(to, from + 1) << "asked about neighbours";
        EXPECT_LE(to, from + 4) << "asked about a gap of more than three views";
        return c.bridges.contains({from, to});
    });
    EXPECT_EQ(chain.trusted, c.trusted);
    EXPECT_EQ(chain.bridged, c.bridged);
}

INSTANTIATE_TEST_SUITE_P(
    Table, LinkViews,
    testing::Values(
        Case{"OneView", {}, {}, {0}, {}},                          //
        Case{"AllFit", {true, true, true}, {}, {0, 1, 2, 3}, {}},  //
        Case{"NothingFits", {false, false, false}, {}, {0}, {}},   //
        Case{"OneViewWrong", {true, false, false, true}, {{1, 3}}, {0, 1, 3, 4}, {2}},
        Case{"TwoViewsSwapped", {true, false, false, false, true}, {{1, 4}}, {0, 1, 4, 5}, {2, 3}},
        Case{"ThreeViewsWrong",
             {true, false, false, false, false, true},
             {{1, 5}},
             {0, 1, 5, 6},
             {2, 3, 4}},
        Case{"FourViewsAreTooManyToBridge",
             {true, false, false, false, false, false, true, true},
             {{1, 6}},
             {6, 7, 8},
             {}},
        Case{"BrokenForGood", {true, true, false, true}, {}, {0, 1, 2}, {}},
        Case{"EarlierPartOfTwoEqualOnes", {true, false, true}, {}, {0, 1}, {}},
        Case{"LaterPartWhereItIsLonger", {true, false, true, true}, {}, {2, 3, 4}, {}},
        Case{"LastViewWrong", {true, true, false}, {}, {0, 1, 2}, {}},
        Case{"FirstViewWrong", {false, true, true}, {}, {1, 2, 3}, {}},
        Case{"TwoBridges",
             {false, false, true, false, false},
             {{0, 2}, {3, 5}},
             {0, 2, 3, 5},
             {1, 4}},
        Case{
            "TheNearestBridgeIsTaken", {false, false, false, true}, {{0, 2}, {0, 3}}, {0, 2}, {1}}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace gripscan
