// The report as one self-contained HTML page: verdict, figures, error plot, Table 1, causes. No
// script, no font, no picture from outside; made for the screen and for paper.
#pragma once

#include <string>

#include "core/report/table1.h"

namespace gripscan {

struct HtmlPageInput {
    const TurnReport& report;
    const Table1& table;
    std::string session_name;
    std::size_t template_points = 0;
    std::string version;
};

[[nodiscard]] std::string html_page(const HtmlPageInput& input);

}  // namespace gripscan
