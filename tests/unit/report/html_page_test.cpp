#include "core/report/html_page.h"

#include <gmock/gmock.h>

#include <regex>
#include <set>

#include "core/report/error_plot.h"
#include "tests/unit/report/sample_report.h"

namespace gripscan {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string page_of(const TurnReport& report, const std::string& name = "monday") {
    return html_page({report, table1_of(report, {}), name, 2, "1.2.3"});
}

/// Every element that is opened is closed, in order. Empty text if so, else what is wrong.
std::string unbalanced(const std::string& html) {
    const std::set<std::string> kVoid{"meta", "br"};
    const std::regex tag("<(/?)([a-zA-Z0-9]+)[^>]*?(/?)>");
    std::vector<std::string> open;
    for (std::sregex_iterator it(html.begin(), html.end(), tag), end; it != end; ++it) {
        const std::string name = (*it)[2];
        if (kVoid.contains(name) || (*it)[3] == "/") continue;
        if ((*it)[1] != "/") {
            open.push_back(name);
        } else if (open.empty() || open.back() != name) {
            return "</" + name + "> closes " + (open.empty() ? "nothing" : open.back());
        } else {
            open.pop_back();
        }
    }
    return open.empty() ? "" : "never closed: " + open.back();
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
}

TEST(HtmlPage, IsWellFormedAndStandsAlone) {
    const std::string page = page_of(test::sample_report());
    EXPECT_EQ(unbalanced(page), "");
    EXPECT_THAT(page, HasSubstr("charset=\"utf-8\""));
    EXPECT_THAT(page, HasSubstr("@media print"));
    for (const char* outside : {"http:", "https:", "src=", "<script", "<link", "url("}) {
        EXPECT_THAT(page, Not(HasSubstr(outside)));
    }
}

TEST(HtmlPage, TellsTheBadStepsAndEscapesWhatItIsGiven) {
    const std::string page = page_of(test::sample_report(), "a<b>&\"c\"");
    EXPECT_THAT(page, HasSubstr("a&lt;b&gt;&amp;&quot;c&quot;"));
    EXPECT_THAT(page, HasSubstr("no alignment of &lt;the two&gt; clouds &amp; nothing else"));
    EXPECT_THAT(page, HasSubstr("class=\"verdict reject\""));
    EXPECT_EQ(unbalanced(page), "");
}

TEST(HtmlPage, WithoutAnyAngleToCompareSaysSo) {
    TurnReport report = test::sample_report();
    for (auto& step : report.steps) step.error_rad.reset();
    EXPECT_EQ(error_plot_svg(report), "");
    EXPECT_THAT(page_of(report), HasSubstr("nothing to compare"));
}

TEST(ErrorPlot, MarksEveryStepByItsVerdict) {
    const std::string svg = error_plot_svg(test::sample_report());
    EXPECT_EQ(count(svg, "class=\"mark accept\""), 1u);
    EXPECT_EQ(count(svg, "class=\"mark check\""), 1u);
    EXPECT_EQ(count(svg, "class=\"mark reject\""), 1u);
    EXPECT_EQ(count(svg, "class=\"limit\""), 2u);
    EXPECT_EQ(count(svg, "class=\"band\""), 2u) << "one for each known sigma";
}

/// One wild step must not flatten all the others: it is drawn at the edge, with its value.
TEST(ErrorPlot, NamesWhatLiesBeyondTheScale) {
    TurnReport report = test::sample_report();
    report.steps[1].error_rad = rad_from_deg(14.3);
    const std::string svg = error_plot_svg(report);
    EXPECT_THAT(svg, HasSubstr("class=\"value\""));
    EXPECT_THAT(svg, HasSubstr(">14.30</text>"));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

/// Neighbours beyond the scale write their values in different rows, far ones in the same.
TEST(ErrorPlot, KeepsNeighbouringValuesApart) {
    TurnReport report = test::sample_report();
    const TurnStep step = report.steps[0];
    report.steps.assign(36, step);
    for (const std::size_t i : {3u, 4u, 20u}) report.steps[i].error_rad = rad_from_deg(-14.3);
    const std::string svg = error_plot_svg(report);
    const std::regex value("class=\"value\" x=\"[0-9.]+\" y=\"([0-9.]+)\"");
    std::vector<double> rows;
    for (std::sregex_iterator it(svg.begin(), svg.end(), value), end; it != end; ++it) {
        rows.push_back(std::stod((*it)[1]));
    }
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_GE(std::abs(rows[0] - rows[1]), 12.0) << "the height of the text";
    EXPECT_EQ(rows[0], rows[2]);
}

TEST(HtmlPage, TellsOnlyOfWhatWasComputed) {
    TurnReport report = test::sample_report();
    EXPECT_THAT(page_of(report), HasSubstr("Closure, joint solution"));
    EXPECT_THAT(page_of(report), HasSubstr("Dark band"));
    report.closure_after = report.closure_before;
    for (auto& step : report.steps) step.sigma_rad.reset();
    EXPECT_THAT(page_of(report), Not(HasSubstr("Closure, joint solution")));
    EXPECT_THAT(page_of(report), Not(HasSubstr("Dark band")));
}

}  // namespace
}  // namespace gripscan
