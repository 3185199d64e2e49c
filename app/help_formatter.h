// The help pages: an option that must be given says so.
#pragma once

#include <CLI/CLI.hpp>

namespace gripscan::app {

class HelpFormatter : public CLI::Formatter {
  public:
    std::string make_option_desc(const CLI::Option* option) const override {
        const bool named = option->get_required() && !option->get_positional();
        return option->get_description() + (named ? "; required" : "");
    }
};

}  // namespace gripscan::app
