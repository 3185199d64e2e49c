// What the workstation does with each thing that a panel asked for.
#include <algorithm>

#include "app/workstation/workstation.h"
#include "core/report/results_folder.h"

namespace gripscan::app {
namespace {
using ui::LogLevel;
}  // namespace

/// One request, taken.
struct Workstation::Taker {
    Workstation& self;

    void operator()(const ui::request::Give& r) const {
        self.give(r.command);
        if (self.dialog_ == ui::Dialog::kNote) self.dialog_ = ui::Dialog::kNone;
    }
    void operator()(const ui::request::HoldToMove& r) const { self.hold(r.held); }
    void operator()(const ui::request::GoTo& r) const {
        self.hold(false);  // the button that was held is not there any more
        self.page_ = r.page;
    }
    void operator()(const ui::request::Open& r) const { self.open(r.path); }
    void operator()(const ui::request::Resume& r) const { self.resume(r.folder); }
    void operator()(const ui::request::Begin& r) const { self.begin(r.wish); }
    void operator()(const ui::request::Tour&) const { self.begin({}); }
    void operator()(const ui::request::CloseSession& r) const {
        if (!r.stop_first && self.asks_to_stop_first()) return;
        self.dialog_ = ui::Dialog::kNone;
        self.close_turn();
    }
    void operator()(const ui::request::Forget& r) const {
        if (Status s = self.recent_.forget(r.folder); !s) {
            self.log(LogLevel::kWarning, "SET-014", s.error().message);
        }
        self.refresh_recent();
    }
    void operator()(const ui::request::Show& r) const {
        if (r.dialog == ui::Dialog::kClose && !self.busy()) return self.close_turn();
        if (r.dialog != ui::Dialog::kNone) self.hold(false);
        self.dialog_ = r.dialog;
        // It stands beside the template, with its counts in sight.
        if (r.dialog == ui::Dialog::kExport) self.page_ = ui::Page::kTemplate;
        if (r.dialog != ui::Dialog::kError) self.error_.reset();
    }
    void operator()(const ui::request::SelectStep& r) const { self.selected_row_ = r.row; }
    void operator()(const ui::request::Export& r) const { self.export_as(r.wish); }
    void operator()(const ui::request::SetPlan& r) const { self.give(command::SetPlan{r.plan}); }
    void operator()(const ui::request::SetRegion& r) const { self.wished_region_ = r.region; }
    void operator()(const ui::request::KeepRegion&) const { self.keep_region(); }
    void operator()(const ui::request::SetFilter& r) const {
        self.filter_ = r.filter;
        self.refresh_filter();
    }
    void operator()(const ui::request::Recognise& r) const { self.recognise(r.capture); }
    void operator()(const ui::request::LearnEnvironment&) const { self.learn_environment(); }
    void operator()(const ui::request::LibraryAdd&) const { self.add_to_library(); }
    void operator()(const ui::request::LibraryRemove& r) const { self.desk_.remove(r.name); }
    void operator()(const ui::request::WantResiduals& r) const { self.residuals_.want(r.on); }
    void operator()(const ui::request::CopyText& r) const {
        self.wish_.clipboard = r.text;
        self.toast(LogLevel::kInformation, "toast.copied", "Copied", r.what);
    }
    void operator()(const ui::request::SaveTable&) const { write_report(false); }
    void operator()(const ui::request::SaveReport&) const { write_report(true); }
    void operator()(const ui::request::Screenshot& r) const {
        (r.view_only ? self.wish_.view_picture : self.wish_.screenshot) = true;
    }
    void operator()(const ui::request::SetTheme& r) const {
        change([&](auto& p) { p.theme = r.theme; });
    }
    void operator()(const ui::request::SetScale& r) const {
        change([&](auto& p) { p.user_scale = std::clamp(r.factor, 0.5, 3.0); });
    }
    void operator()(const ui::request::SetLargeButtons& r) const {
        change([&](auto& p) { p.large_buttons = r.on; });
    }
    void operator()(const ui::request::SetNavigation& r) const {
        change([&](auto& p) { p.navigation = r.preset; });
    }
    void operator()(const ui::request::SetKey& r) const {
        change([&](auto& p) {
            std::erase_if(p.keys, [&](const auto& key) { return key.first == r.action; });
            if (!r.key.empty()) p.keys.emplace_back(r.action, r.key);
        });
    }
    void operator()(const ui::request::ResetLayout&) const { self.wish_.reset_layout = true; }
    void operator()(const ui::request::LiveView& r) const {
        if (LiveTurn* turn = self.live()) turn->set_live(r.on);
    }
    void operator()(const ui::request::CancelJob&) const {
        if (self.jobs_.shown()) {
            self.jobs_.cancel_all();
        } else if (self.busy()) {
            self.give(command::Stop{});
        }
    }
    void operator()(const ui::request::CloseToast& r) const { self.toasts_.close(r.id); }
    void operator()(const ui::request::Quit&) const {
        if (self.dialog_ != ui::Dialog::kClose && self.asks_to_stop_first()) return;
        self.wish_.quit = true;
    }

  private:
    template <typename Change>
    void change(const Change& how) const {
        ui::WindowPreferences changed = self.preferences_.preferences;
        how(changed);
        self.set_preferences(changed);
    }
    /// Table 1 of a turn that is not finished yet has no file so far; that of a finished one lies
    /// in the results.
    void write_report(bool page) const {
        const ui::Snapshot shown = self.snapshot();
        if (!shown.solved || !shown.session) {
            self.toast(LogLevel::kWarning, "toast.file", "Nothing to write yet",
                       "The report is written when the turn is solved: finish it first.");
            return;
        }
        const auto session = open_session(shown.session->folder);
        if (!session) {
            self.fail("The report was not written", session.error(), "");
            return;
        }
        const TurnReport& report = shown.solved->report;
        ReportFiles files = report_files(report, report.merged.size(), *session, GRIPSCAN_VERSION);
        self.write_file(page ? "report.html" : "turns.csv",
                        [&] { return page ? std::move(files.html) : std::move(files.csv); });
    }
};

void Workstation::take(const ui::Request& request) {
    std::visit(Taker{*this}, request);
}

}  // namespace gripscan::app
