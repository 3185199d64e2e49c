// The turn that is being recorded, as the window holds it: the run, and what can be shown of it.
#pragma once

#include <atomic>
#include <memory>

#include "app/turn_run.h"
#include "app/workstation/live_view.h"
#include "app/workstation/searched_view.h"
#include "app/workstation/seen_captures.h"
#include "app/workstation/step_clock.h"

namespace gripscan::app {

class LiveTurn {
  public:
    /// Opens cell and session; slow, for a job's thread. `wake` is called from the turn's threads.
    [[nodiscard]] static Result<std::unique_ptr<LiveTurn>> open(const TurnRunOptions& options,
                                                                std::function<void()> wake,
                                                                const Progress& progress);
    ~LiveTurn();
    LiveTurn(const LiveTurn&) = delete;
    LiveTurn& operator=(const LiveTurn&) = delete;

    // On the window's thread.
    [[nodiscard]] const ProcedureState& state() const { return run_->engine().state(); }
    /// Why it was refused; nothing: taken. An error: the session cannot be written any more.
    [[nodiscard]] Result<std::optional<std::string>> submit(const Command& command);
    [[nodiscard]] Status pump();
    /// Into the session's journal; see Engine::note.
    [[nodiscard]] Status note(std::string_view event, const JournalFields& fields) {
        return run_->engine().note(event, fields);
    }
    /// Something of the turn is going on.
    [[nodiscard]] bool busy() const;
    void set_live(bool on) { live_->set_on(on); }

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    [[nodiscard]] const CellOptions& cell_options() const { return run_->cell_options(); }
    /// For the captures as they are: another step makes it a thing of the past. Null: not solved.
    [[nodiscard]] std::shared_ptr<const ComputedTurn> solved() const;
    /// Takes a view of all that the camera sees, for recognition. From any thread while the turn is
    /// open.
    [[nodiscard]] Result<SearchedView> look(const Progress& progress, const ForEach& for_each);
    [[nodiscard]] std::optional<Pose> T_robot_camera() const { return run_->cell().T_robot_camera; }
    /// Fills what the turn knows.
    void show_in(ui::Snapshot& snapshot) const;

  private:
    explicit LiveTurn(std::function<void()> wake);
    Status begin(const TurnRunOptions& options, const Progress& progress);
    void note_beat(const RobotBeat& beat);
    /// Live pairs are matched only while the turn itself has nothing to do.
    void tell_live_view();
    [[nodiscard]] ui::CellFrame frame() const;

    std::function<void()> wake_;
    std::filesystem::path folder_;
    SeenCaptures seen_;
    std::unique_ptr<LiveView> live_;
    mutable std::mutex mutex_;
    std::shared_ptr<const ComputedTurn> solved_;  ///< the latest
    std::optional<RobotReading> beat_;            ///< the latest reading of the heartbeat
    std::optional<JointAngles> looked_at_;        ///< joints at the latest live picture
    decltype(Progress::report) opening_;          ///< the job's, while the turn is opened
    double part_ = -1.0;                          ///< of the work that goes on
    std::string stage_;
    std::atomic<int> looks_ = 0;
    StepClock clock_;
    std::unique_ptr<TurnRun> run_;
};

}  // namespace gripscan::app
