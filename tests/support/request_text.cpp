#include "tests/support/request_text.h"

#include <cxxabi.h>
#include <fmt/format.h>

#include <cstdlib>
#include <memory>
#include <typeinfo>

#include "core/base/units.h"

namespace gripscan::test {
namespace {

using namespace ui;

constexpr const char* kPages[] = {"start", "procedure", "template", "recognise", "cell"};
constexpr const char* kDialogs[] = {"none",     "new session", "open", "note", "export",
                                    "settings", "keys",        "error", "close"};

template <typename T>
std::string kind() {
    int status = 0;
    const std::unique_ptr<char, decltype(&std::free)> name(
        abi::__cxa_demangle(typeid(T).name(), nullptr, nullptr, &status), &std::free);
    const std::string whole = status == 0 ? name.get() : typeid(T).name();
    return whole.substr(whole.rfind(':') + 1);
}

/// What tells two of a kind apart.
struct Details {
    std::string operator()(const request::Give& r) const {
        std::string text{word(r.command)};
        if (const auto* c = std::get_if<command::Exclude>(&r.command))
            text += fmt::format(" {}", c->index);
        if (const auto* c = std::get_if<command::Retake>(&r.command))
            text += fmt::format(" {}", c->index);
        return text;
    }
    std::string operator()(const request::HoldToMove& r) const { return r.held ? "on" : "off"; }
    std::string operator()(const request::GoTo& r) const {
        return kPages[static_cast<std::size_t>(r.page)];
    }
    std::string operator()(const request::Open& r) const { return r.path.string(); }
    std::string operator()(const request::Resume& r) const { return r.folder.string(); }
    std::string operator()(const request::Forget& r) const { return r.folder.string(); }
    std::string operator()(const request::Begin& r) const {
        return fmt::format("{}{}{}{}", r.wish.cell, r.wish.live ? ", live" : "",
                           r.wish.manual ? ", manual" : "", r.wish.object ? ", object" : "");
    }
    std::string operator()(const request::CloseSession& r) const {
        return r.stop_first ? "stop first" : "";
    }
    std::string operator()(const request::Show& r) const {
        return fmt::format("{}{}{}", kDialogs[static_cast<std::size_t>(r.dialog)],
                           r.cell_file ? ", cell file" : "", r.object ? ", object" : "");
    }
    std::string operator()(const request::SelectStep& r) const {
        return r.row ? fmt::format("{}", *r.row) : "last";
    }
    std::string operator()(const request::Export& r) const { return r.wish.file.string(); }
    std::string operator()(const request::SetPlan& r) const {
        return fmt::format("step {:.4g} deg", deg_from_rad(r.plan.step_rad));
    }
    std::string operator()(const request::SetRegion& r) const { return r.region ? "to" : "back"; }
    std::string operator()(const request::SetFilter& r) const {
        return fmt::format("seen {}, sigmas {:.4g}, crop {}{}", r.filter.min_seen,
                           r.filter.denoise_sigmas, r.filter.crop ? "on" : "off",
                           r.filter.invert_crop ? " inverted" : "");
    }
    std::string operator()(const request::Recognise& r) const {
        return r.capture ? fmt::format("capture {}", *r.capture) : "now";
    }
    std::string operator()(const request::LibraryRemove& r) const { return r.name; }
    std::string operator()(const request::WantResiduals& r) const { return r.on ? "on" : "off"; }
    std::string operator()(const request::CopyText& r) const { return r.what; }
    std::string operator()(const request::Screenshot& r) const {
        return r.view_only ? "view" : "window";
    }
    std::string operator()(const request::SetTheme& r) const {
        return r.theme == ThemeChoice::kDark ? "dark" : "light";
    }
    std::string operator()(const request::SetScale& r) const {
        return fmt::format("{:.4g}", r.factor);
    }
    std::string operator()(const request::SetLargeButtons& r) const { return r.on ? "on" : "off"; }
    std::string operator()(const request::SetKey& r) const { return r.action + " " + r.key; }
    std::string operator()(const request::SetNavigation& r) const { return r.preset; }
    std::string operator()(const request::LiveView& r) const { return r.on ? "on" : "off"; }
    std::string operator()(const request::CloseToast& r) const { return r.id; }
    template <typename T>
    std::string operator()(const T&) const {
        return {};
    }
};

}  // namespace

std::string request_text(const Request& request) {
    return std::visit(
        [](const auto& r) {
            const std::string details = Details{}(r);
            return kind<std::decay_t<decltype(r)>>() + (details.empty() ? "" : " " + details);
        },
        request);
}

}  // namespace gripscan::test
