#include "app/workstation/workstation.h"

#include <algorithm>

#include "app/results_of.h"
#include "app/workstation/export_template.h"
#include "app/workstation/hold_to_move.h"
#include "app/workstation/region_in_cell_file.h"
#include "app/workstation/stoppable_loop.h"
#include "core/base/atomic_file.h"
#include "core/report/results_folder.h"
#include "core/sim/sim_cell.h"
#include "ui/views/key_bindings.h"

namespace gripscan::app {
namespace {
namespace fs = std::filesystem;
using ui::LogLevel;

/// The template as the filter leaves it.
ui::ShownTemplate shown_template(const std::shared_ptr<const ComputedTurn>& turn,
                                 const TemplateFilter& filter, const ForEach& for_each) {
    ui::ShownTemplate shown;
    // The cloud lives as long as its turn.
    shown.whole = std::shared_ptr<const Cloud>(turn, &turn->report.merged);
    const FilteredTemplate filtered = filter_template(*shown.whole, filter, for_each);
    shown.kept = std::make_shared<Cloud>(select(*shown.whole, filtered.kept));
    shown.whole_facts = template_facts(*shown.whole, for_each);
    shown.kept_facts = template_facts(*shown.kept, for_each);
    shown.counts = filtered.counts;
    shown.filter = filter;
    return shown;
}

constexpr std::size_t kMostLogLines = 5000;

CellOptions cell_options_of(const ui::SessionWish& wish) {
    CellOptions options;
    options.cell = wish.cell;
    options.live = wish.live;
    options.manual = wish.manual;
    options.step_deg = wish.step_deg;
    options.speed_percent = wish.speed_percent;
    options.seed = wish.seed;
    options.faults = wish.faults;
    options.object = wish.sim_object;
    return options;
}

/// What to do about an error whose message does not go with a place of its own.
std::string_view advice_for(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::kDevice:
            return "Check power, cable and address of the device that is named, then do it again. "
                   "What was recorded is safe.";
        case ErrorKind::kRejected:
            return "Nothing was kept of it. Look at the number that is over its limit, change what "
                   "it names, then do it again.";
        case ErrorKind::kInput:
        case ErrorKind::kCancelled:
            break;
    }
    return "Nothing was changed. Correct what is named above, or choose something else, then do it "
           "again.";
}

}  // namespace

Workstation::Workstation(WorkstationSettings settings)
    : settings_(std::move(settings)),
      recent_(settings_.files.state),
      desk_(settings_.files.sessions / "library", settings_.threads, jobs_,
            [this](std::string title, const Error& error) { fail(std::move(title), error, ""); }),
      environment_(
          settings_.files.sessions, settings_.threads, jobs_,
          [this](std::string title, const Error& error) { fail(std::move(title), error, ""); }),
      jobs_(settings_.wake) {
    desk_.refresh();
    preferences_ = settings_.preferences.stored;
    for (const std::string& sentence : settings_.preferences.refused) {
        log(LogLevel::kWarning, "SET-010", sentence);
    }
    refresh_recent();
}

Workstation::~Workstation() {
    jobs_.cancel_all();
}

LiveTurn* Workstation::live() {
    auto* live = std::get_if<std::unique_ptr<LiveTurn>>(&turn_);
    return live == nullptr ? nullptr : live->get();
}

const LiveTurn* Workstation::live() const {
    return const_cast<Workstation*>(this)->live();
}

std::shared_ptr<const ComputedTurn> Workstation::solved() const {
    if (const LiveTurn* turn = live()) return turn->solved();
    const auto* recorded = std::get_if<std::unique_ptr<RecordedTurn>>(&turn_);
    return recorded == nullptr ? nullptr : (*recorded)->solved;
}

void Workstation::log(LogLevel level, std::string code, std::string text) {
    if (log_.size() >= kMostLogLines) log_.erase(log_.begin(), log_.begin() + kMostLogLines / 10);
    log_.push_back({std::chrono::system_clock::now(), level, std::move(code), std::move(text)});
}

void Workstation::toast(LogLevel level, std::string id, std::string title, std::string text) {
    const ui::State state = level == LogLevel::kInformation ? ui::State::kAccept
                            : level == LogLevel::kWarning   ? ui::State::kCheck
                                                            : ui::State::kReject;
    toasts_.add({std::move(id), state, std::move(title), std::move(text), ""}, now_s_);
}

void Workstation::fail(std::string title, const Error& error, std::string advice) {
    if (error.kind == ErrorKind::kCancelled) return;
    log(LogLevel::kError, "WIN-010", fmt::format("{}: {}", title, error.message));
    if (advice.empty()) advice = advice_for(error.kind);
    error_ = ui::ShownError{std::move(title), error.message, std::move(advice), "", {}};
    dialog_ = ui::Dialog::kError;
}

void Workstation::pump(double now_s) {
    now_s_ = now_s;
    toasts_.forget_old(now_s);
    jobs_.pump();
    if (residuals_.wanted()) residuals_.refresh(snapshot(), jobs_, settings_.threads);
    LiveTurn* turn = live();
    if (turn == nullptr) return;
    if (Status s = turn->pump(); !s) {
        fail("The session cannot be written any more", s.error(),
             "What was recorded is safe. Free the disk, then resume the session.");
        close_turn();
        return;
    }
    for (ui::LogLine& line : turn_log_.news(turn->state())) log_.push_back(std::move(line));
    refresh_filter();
}

ui::Snapshot Workstation::snapshot() const {
    ui::Snapshot shown;
    shown.page = page_;
    shown.dialog = dialog_;
    shown.preferences = preferences_.preferences;
    shown.recent = recent_shown_;
    if (const LiveTurn* turn = live()) {
        turn->show_in(shown);
        environment_.show_in(shown, turn->cell_options());
    }
    if (const auto* recorded = std::get_if<std::unique_ptr<RecordedTurn>>(&turn_)) {
        (*recorded)->show_in(shown);
    }
    shown.cell.wished_region = wished_region_;
    shown.residuals_wanted = residuals_.wanted();
    residuals_.attach(shown.captures);
    desk_.show_in(shown);
    if (const auto job = jobs_.shown()) {
        shown.job = ui::ShownJob{job->stopping ? job->name + ", stopping" : job->name, job->part,
                                 job->elapsed_s, !job->stopping};
    }
    const std::size_t rows = shown.procedure != nullptr ? table_of(*shown.procedure).size() : 0;
    shown.follows_last = !selected_row_ || *selected_row_ >= rows;
    shown.selected_row = shown.follows_last ? (rows > 0 ? rows - 1 : 0) : *selected_row_;
    shown.log = log_;
    for (const ui::Toast& toast : toasts_.shown()) {
        const LogLevel level = toast.state == ui::State::kReject  ? LogLevel::kError
                               : toast.state == ui::State::kCheck ? LogLevel::kWarning
                                                                  : LogLevel::kInformation;
        shown.toasts.push_back({toast.id, level, toast.title, toast.text});
    }
    shown.error = error_;
    shown.filter = filter_;
    if (shown.solved && shown_template_.whole) shown.shown_template = shown_template_;
    shown.last_export = last_export_;
    static const std::vector<std::string> kObjects = sim_objects();
    shown.sim_objects = kObjects;
    shown.keys = ui::key_bindings(preferences_.preferences);
    shown.version = GRIPSCAN_VERSION;
    return shown;
}

bool Workstation::busy() const {
    const LiveTurn* turn = live();
    return turn != nullptr && turn->busy();
}

double Workstation::next_change_s(double now_s) const {
    const double toast_s = toasts_.next_end_s() - now_s;
    // Clocks and turning rings move while something goes on.
    return busy() || jobs_.shown() ? std::min(toast_s, 0.1) : toast_s;
}

void Workstation::close_turn() {
    const LiveTurn* turn = live();
    const fs::path folder = turn != nullptr ? turn->folder() : fs::path();
    desk_.leave_session();  // it may be using the camera
    turn_ = std::monostate{};
    turn_log_ = {};
    residuals_.forget();
    selected_row_.reset();
    filter_ = {};
    shown_template_ = {};
    filtered_turn_.reset();
    last_export_.clear();
    wished_region_.reset();
    page_ = ui::Page::kStart;
    if (!folder.empty()) refresh_recent();
}

void Workstation::begin(const ui::SessionWish& wish) {
    if (asks_to_stop_first()) return;
    TurnRunOptions options;
    options.cell = cell_options_of(wish);
    options.out = wish.folder.empty() ? new_session_folder(settings_.files.sessions,
                                                           wish.object ? "object" : "gripper")
                                      : wish.folder;
    options.gripper = wish.gripper;
    open_live(std::move(options), "Opening the cell");
}

void Workstation::resume(const fs::path& folder) {
    if (asks_to_stop_first()) return;
    TurnRunOptions options;
    options.out = folder;
    options.resume = true;
    options.in_its_mode = true;
    open_live(std::move(options), "Resuming the session");
}

void Workstation::open_live(TurnRunOptions options, const std::string& job) {
    close_turn();
    options.threads = settings_.threads;
    std::error_code code;
    fs::create_directories(options.out.parent_path(), code);
    dialog_ = ui::Dialog::kNone;
    jobs_.start(job, [this, options, job](const Progress& progress) -> JobList::Outcome {
        // A shared pointer, because an outcome can be copied.
        auto turn = std::make_shared<Result<std::unique_ptr<LiveTurn>>>(
            LiveTurn::open(options, settings_.wake, progress));
        return [this, turn, options, job] {
            if (!*turn) {
                fail(job + " failed", turn->error(), "");
                return;
            }
            turn_ = std::move(**turn);
            page_ = ui::Page::kProcedure;
            if (Status s = recent_.add(options.out, std::chrono::system_clock::now()); !s) {
                log(LogLevel::kWarning, "SET-011", s.error().message);
            }
            log(LogLevel::kInformation, "RUN-001", "Session " + options.out.string());
            give(command::Connect{});
        };
    });
}

void Workstation::open(const fs::path& path) {
    if (asks_to_stop_first()) return;
    close_turn();
    dialog_ = ui::Dialog::kNone;
    const unsigned threads = settings_.threads;
    jobs_.start("Opening " + path.filename().string(),
                [this, path, threads](const Progress& progress) -> JobList::Outcome {
                    std::error_code code;
                    WorkerPool pool(threads);
                    auto turn = std::make_shared<Result<RecordedTurn>>(
                        fs::is_directory(path, code)
                            ? load_recorded_turn(path, progress, pool.for_each())
                            : load_cloud_alone(path));
                    return [this, path, turn] {
                        if (!*turn) {
                            fail("This could not be opened", turn->error(), "");
                            return;
                        }
                        const bool cloud = !(*turn)->state;
                        turn_ = std::make_unique<RecordedTurn>(std::move(**turn));
                        page_ = cloud ? ui::Page::kTemplate : ui::Page::kProcedure;
                        if (!cloud) {
                            (void)recent_.add(path, std::chrono::system_clock::now());
                            refresh_recent();
                        }
                        refresh_filter();
                    };
                });
}

fs::path Workstation::gripper_to_hold_with() const {
    const ui::Snapshot shown = snapshot();
    if (shown.session && !shown.session->object && shown.solved) return shown.session->folder;
    for (const ui::RecentSession& recent : recent_shown_) {
        if (recent.kind == "gripper" && recent.end == ui::RecentSession::End::kComplete) {
            return recent.folder;
        }
    }
    return {};
}

void Workstation::give(const Command& command) {
    LiveTurn* turn = live();
    if (turn == nullptr) {
        toast(LogLevel::kWarning, "toast.refused", "Nothing to command",
              "A recording is only looked at. Open a cell to go on.");
        return;
    }
    const auto refuse = [&](const std::string& why) {
        toast(LogLevel::kWarning, "toast.refused", fmt::format("Not now: {}", word(command)), why);
        log(LogLevel::kWarning, "RUN-011", fmt::format("{}: {}", word(command), why));
    };
    if (const auto why = why_not_held(turn->state(), command, held_)) return refuse(*why);
    auto reply = turn->submit(command);
    if (!reply) {
        fail("The session cannot be written any more", reply.error(),
             "What was recorded is safe. Free the disk, then resume the session.");
        close_turn();
        return;
    }
    // Stop is never greyed: where nothing is going on there is nothing to tell.
    if (*reply && std::holds_alternative<command::Stop>(command)) return;
    if (*reply) return refuse(**reply);
    selected_row_.reset();
    refresh_filter();
}

void Workstation::hold(bool held) {
    held_ = held;
    LiveTurn* turn = live();
    if (turn == nullptr) return;
    const auto asked = held ? begun_by_holding(turn->state()) : asked_by_letting_go(turn->state());
    if (asked) give(*asked);
}

bool Workstation::asks_to_stop_first() {
    if (!busy()) return false;
    dialog_ = ui::Dialog::kClose;
    return true;
}

void Workstation::refresh_recent() {
    auto list = recent_.list();
    if (!list) {
        log(LogLevel::kWarning, "SET-012", list.error().message);
        return;
    }
    recent_shown_ = std::move(*list);
}

void Workstation::set_preferences(const ui::WindowPreferences& changed) {
    preferences_.preferences = changed;
    if (Status s = ui::save_preferences(settings_.files.preferences, preferences_); !s) {
        log(LogLevel::kWarning, "SET-013", s.error().message);
    }
}

void Workstation::set_splits(const ui::Splits& splits) {
    if (splits == preferences_.splits) return;
    preferences_.splits = splits;
    set_preferences(preferences_.preferences);
}

void Workstation::refresh_filter() {
    const auto turn = solved();
    const bool done = turn == filtered_turn_ && shown_template_.filter == filter_;
    if (!turn || done || jobs_.running("Filtering the template")) return;
    jobs_.start("Filtering the template",
                [this, turn, filter = filter_,
                 threads = settings_.threads](const Progress& progress) -> JobList::Outcome {
                    WorkerPool pool(threads);
                    auto made = std::make_shared<ui::ShownTemplate>(
                        shown_template(turn, filter, stoppable(pool.for_each(), progress.stop)));
                    if (progress.cancelled()) return [this, turn] { filter_cancelled(turn); };
                    return [this, turn, made] {
                        shown_template_ = *made;
                        filtered_turn_ = turn;
                        refresh_filter();
                    };
                });
}

/// The filter before stands; where there is none, a change of the filter begins again.
void Workstation::filter_cancelled(const std::shared_ptr<const ComputedTurn>& turn) {
    if (filtered_turn_ == turn) {
        filter_ = shown_template_.filter;
    } else {
        shown_template_ = {};
        shown_template_.filter = filter_;
        filtered_turn_ = turn;
    }
    toast(
        LogLevel::kInformation, "toast.cancelled", "Filtering cancelled",
        shown_template_.whole ? "The filter before stands." : "Change the filter to begin again.");
}

void Workstation::recognise(std::optional<int> capture) {
    const ui::Snapshot shown = snapshot();
    if (!shown.session || shown.procedure == nullptr) return;
    SearchRequest request;
    request.capture = capture;
    request.session = shown.session->folder;
    request.T_robot_camera = shown.cell.T_robot_camera;
    if (const LiveTurn* turn = live()) {
        request.environment = environment_.model(turn->cell_options());
    }
    request.region = shown.cell.region;
    const auto used = shown.procedure->data.used();
    if (!used.empty()) {
        const auto& first = shown.procedure->data.captures[used.front()].before;
        if (first) request.first_joint6_rad = first->joints_rad[5];
    }
    if (!capture) {
        LiveTurn* turn = live();
        if (turn == nullptr) return;
        request.view = [turn](const Progress& progress, const ForEach& for_each) {
            return turn->look(progress, for_each);
        };
        desk_.recognise(std::move(request));
        return;
    }
    const auto seen = std::ranges::find(shown.captures, *capture, &ui::ShownCapture::index);
    if (seen == shown.captures.end() || !seen->cloud) return;
    SearchedView view{*seen->cloud, seen->picture, std::nullopt};
    const CaptureRecord* record = shown.procedure->data.find(*capture);
    if (record != nullptr && record->before) view.joints_rad = record->before->joints_rad;
    request.view = [view](const Progress&, const ForEach&) -> Result<SearchedView> { return view; };
    desk_.recognise(std::move(request));
}

void Workstation::learn_environment() {
    const LiveTurn* turn = live();
    if (turn == nullptr) return;
    environment_.learn(turn->cell_options(), [this] {
        toast(LogLevel::kInformation, "toast.environment", "Environment learned",
              "What comes into the registration area is told from it.");
        log(LogLevel::kInformation, "ENV-001", "The environment was learned");
    });
}

void Workstation::keep_region() {
    const fs::path file = snapshot().cell.file;
    if (!wished_region_ || file.empty()) return;
    if (Status kept = app::keep_region(file, *wished_region_); !kept) {
        fail("The registration area was not kept", kept.error(), "");
        return;
    }
    log(LogLevel::kInformation, "CEL-020",
        fmt::format("The registration area is kept in {}", file.string()));
    toast(LogLevel::kInformation, "toast.region", "Kept in " + file.filename().string(),
          "It holds for every session that begins from now on.");
    dialog_ = ui::Dialog::kNewSession;
}

void Workstation::add_to_library() {
    const ui::Snapshot shown = snapshot();
    if (!shown.session || shown.procedure == nullptr) return;
    std::optional<Pose> T_tool;
    const auto used = shown.procedure->data.used();
    if (shown.cell.T_robot_camera && !used.empty()) {
        const auto& first = shown.procedure->data.captures[used.front()].before;
        if (first) T_tool = T_tool_template(*shown.cell.T_robot_camera, first->joints_rad);
    }
    desk_.add(shown.session->folder, T_tool, [this](const std::string& name) {
        toast(LogLevel::kInformation, "toast.library", "In the library", name);
        log(LogLevel::kInformation, "LIB-001",
            fmt::format("{} is in the library {}", name, desk_.folder().string()));
    });
}

Status Workstation::note(const fs::path& session, std::string_view event,
                         const JournalFields& fields) {
    LiveTurn* turn = live();
    // A recording is only looked at.
    if (turn == nullptr || turn->folder() != session) return {};
    return turn->note(event, fields);
}

void Workstation::export_as(const ui::ExportWish& wish) {
    const auto turn = solved();
    if (!turn) return;
    const fs::path session = live() != nullptr ? live()->folder() : fs::path();
    if (Status noted = note(session, "export", journal_fields(wish)); !noted) {
        fail("The template was not exported", noted.error(), "");
        return;
    }
    jobs_.start(
        "Export",
        [this, turn, wish, session,
         threads = settings_.threads](const Progress& progress) -> JobList::Outcome {
            WorkerPool pool(threads);
            auto exported = std::make_shared<Result<Exported>>(
                export_template(turn->report, wish, progress, pool.for_each()));
            return [this, exported, session] {
                if (!*exported && exported->error().kind == ErrorKind::kCancelled) {
                    toast(LogLevel::kInformation, "toast.cancelled", "Export cancelled",
                          "Nothing was written.");
                    return;
                }
                if (!*exported) {
                    fail("The template was not exported", exported->error(), "");
                    return;
                }
                const Exported& file = **exported;
                if (Status noted = note(session, "exported", journal_fields(file)); !noted) {
                    fail("The file is there, but the journal could not be written", noted.error(),
                         "");
                    return;
                }
                last_export_ =
                    fmt::format("{}: {} points, read back equal", file.file.string(), file.points);
                log(LogLevel::kInformation, "EXP-001", last_export_);
                toast(LogLevel::kInformation, "toast.exported",
                      fmt::format("Exported {}", file.file.filename().string()),
                      fmt::format("{} points, {:.1f} MB, read back equal", file.points,
                                  static_cast<double>(file.bytes) / 1e6));
                dialog_ = ui::Dialog::kNone;
            };
        });
}

void Workstation::write_file(const std::string& name, const std::function<std::string()>& text) {
    const auto shown = snapshot();
    if (!shown.session || shown.session->recorded) {
        toast(LogLevel::kWarning, "toast.file", "Nothing written",
              "A recording is never changed; use `gripscan report` on it.");
        return;
    }
    const fs::path file = shown.session->folder / name;
    if (Status s = write_file_atomically(file, text()); !s) {
        fail("The file was not written", s.error(), "");
        return;
    }
    toast(LogLevel::kInformation, "toast.file", "Written", file.string());
}

}  // namespace gripscan::app
