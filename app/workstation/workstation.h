// What the window works on: the turn that is open, the jobs beside it, log, toasts and what the
// user has set. Fills the snapshot of a frame and takes what the panels asked for. On the window's
// thread.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <variant>

#include "app/workstation/environment_desk.h"
#include "app/workstation/job_list.h"
#include "app/workstation/live_turn.h"
#include "app/workstation/recognition_desk.h"
#include "app/workstation/recorded_turn.h"
#include "app/workstation/session_files.h"
#include "app/workstation/turn_log.h"
#include "app/workstation/view_residuals.h"
#include "ui/memory/preferences_file.h"
#include "ui/memory/recent_sessions.h"
#include "ui/views/request.h"
#include "ui/views/snapshot.h"
#include "ui/widgets/toast_queue.h"

namespace gripscan::app {

struct WorkstationSettings {
    unsigned threads = 1;
    SessionFiles files;                 ///< where sessions, recent ones and preferences are kept
    ui::LoadedPreferences preferences;  ///< as they were found there
    /// From any thread: there is something new to show.
    std::function<void()> wake;
};

/// What only the window itself can do.
struct WindowWish {
    bool quit = false;
    std::optional<std::string> clipboard;
    bool screenshot = false;    ///< of the whole window
    bool view_picture = false;  ///< of the 3D view alone
    bool reset_layout = false;
};

class Workstation {
  public:
    explicit Workstation(WorkstationSettings settings);
    ~Workstation();
    Workstation(const Workstation&) = delete;
    Workstation& operator=(const Workstation&) = delete;

    /// Takes in what has come since. `now_s` is the window's time.
    void pump(double now_s);
    /// Valid until the next call of pump() or take().
    [[nodiscard]] ui::Snapshot snapshot() const;
    [[nodiscard]] const ui::StoredPreferences& preferences() const { return preferences_; }
    /// What the user dragged; kept with the preferences.
    void set_splits(const ui::Splits& splits);
    void take(const ui::Request& request);
    /// What has been asked of the window since it was last asked.
    [[nodiscard]] WindowWish window_wish() { return std::exchange(wish_, {}); }
    /// Something goes on that a closing window would interrupt.
    [[nodiscard]] bool busy() const;
    /// When something changes by itself, s from now; infinity: nothing does.
    [[nodiscard]] double next_change_s(double now_s) const;
    /// The session of the gripper for an object's turn: the one that is open, else the one used
    /// last whose turn is complete. Empty: there is none.
    [[nodiscard]] std::filesystem::path gripper_to_hold_with() const;
    void toast(ui::LogLevel level, std::string id, std::string title, std::string text);

  private:
    struct Taker;
    using OpenTurn =
        std::variant<std::monostate, std::unique_ptr<LiveTurn>, std::unique_ptr<RecordedTurn>>;

    void begin(const ui::SessionWish& wish);
    void resume(const std::filesystem::path& folder);
    void open(const std::filesystem::path& path);
    void open_live(TurnRunOptions options, const std::string& job);
    void close_turn();
    void give(const Command& command);
    void hold(bool held);
    /// Another session may not push a running one aside: the question whether to stop it comes up.
    bool asks_to_stop_first();
    void export_as(const ui::ExportWish& wish);
    /// Into the journal of this session, if it is the one that is being recorded.
    [[nodiscard]] Status note(const std::filesystem::path& session, std::string_view event,
                              const JournalFields& fields);
    void refresh_filter();
    void filter_cancelled(const std::shared_ptr<const ComputedTurn>& turn);
    void recognise(std::optional<int> capture);
    void add_to_library();
    void learn_environment();
    void keep_region();
    void refresh_recent();
    void set_preferences(const ui::WindowPreferences& changed);
    void write_file(const std::string& name, const std::function<std::string()>& text);
    void fail(std::string title, const Error& error, std::string advice);
    void log(ui::LogLevel level, std::string code, std::string text);

    [[nodiscard]] LiveTurn* live();
    [[nodiscard]] const LiveTurn* live() const;
    [[nodiscard]] std::shared_ptr<const ComputedTurn> solved() const;

    WorkstationSettings settings_;
    ui::RecentSessions recent_;
    std::vector<ui::RecentSession> recent_shown_;
    ui::StoredPreferences preferences_;
    OpenTurn turn_;
    TurnLog turn_log_;
    std::vector<ui::LogLine> log_;
    ui::ToastQueue toasts_;
    ui::Page page_ = ui::Page::kStart;
    ui::Dialog dialog_ = ui::Dialog::kNone;
    std::optional<ui::ShownError> error_;
    std::optional<std::size_t> selected_row_;
    TemplateFilter filter_;
    ui::ShownTemplate shown_template_;
    std::shared_ptr<const ComputedTurn> filtered_turn_;  ///< what shown_template_ was made of
    ViewResiduals residuals_;
    RecognitionDesk desk_;
    EnvironmentDesk environment_;
    std::string last_export_;
    std::optional<Box> wished_region_;  ///< of the next session; nothing: as the cell's is
    WindowWish wish_;
    bool held_ = false;  ///< `Hold to move`
    double now_s_ = 0.0;
    JobList jobs_;  // last: its threads use all of the above
};

}  // namespace gripscan::app
