// A run of the procedure with everything it needs: cell, session, computation, engine. The command
// `run` and the window both hold one.
#pragma once

#include <functional>
#include <memory>

#include "app/resumed_cell.h"
#include "app/run_results.h"
#include "app/turn_session.h"
#include "core/camera/shared_source.h"
#include "core/concurrency/worker_pool.h"
#include "core/procedure/cell_effects.h"
#include "core/procedure/engine.h"
#include "core/procedure/link_watch.h"

namespace gripscan::app {

struct TurnRunOptions {
    CellOptions cell;
    GivenOptions given;         ///< of the options of the cell: those of a command line
    std::filesystem::path out;  ///< the session folder
    /// Of an object's turn that begins: the template of the gripper that holds it, or the session
    /// that it was registered in. Empty: the gripper's own turn.
    std::filesystem::path gripper;
    /// Of a turn that begins: the learned environment, or the session it was learned from. Empty:
    /// nothing is taken away.
    std::filesystem::path environment;
    bool resume = false;
    /// Resumed in whatever mode it was: its window shows which, and asks before each motion by
    /// hand.
    bool in_its_mode = false;
    TurnOptions turn;
    unsigned threads = 1;
};

/// What a run shows while it goes on; every function may be empty and is called from the run's own
/// threads.
struct TurnRunViewers {
    /// What is waited for while the cell is opened, where that takes long.
    std::function<void(const std::string&)> waits;
    /// The cell is open, its link not yet connected.
    std::function<Status(const Cell&)> opened;
    SharedSource::Viewer frame;
    TurnWorkspace::Viewer prepared;
    decltype(Progress::report) progress;
    std::function<void(const ComputedTurn&)> solved;
    LinkWatch::Viewer beat;
};

class TurnRun {
  public:
    /// Opens cell and session and loads what was recorded. A resumed run that has not begun yet
    /// begins anew. Errors: the cell cannot be opened, the session is in use or damaged, cancelled.
    [[nodiscard]] static Result<std::unique_ptr<TurnRun>> open(const TurnRunOptions& options,
                                                               TurnRunViewers viewers,
                                                               const std::stop_token& stop);
    ~TurnRun();
    TurnRun(const TurnRun&) = delete;
    TurnRun& operator=(const TurnRun&) = delete;

    /// Belongs to the thread that calls it.
    [[nodiscard]] Engine& engine();
    [[nodiscard]] const Cell& cell() const { return cell_; }
    [[nodiscard]] SharedSource& camera() { return *camera_; }
    [[nodiscard]] const RunResults& results() const;
    [[nodiscard]] const CellOptions& cell_options() const { return options_; }
    [[nodiscard]] const SessionStore& store() const { return session_.store; }
    [[nodiscard]] bool resumed() const { return resumed_; }
    [[nodiscard]] SessionKind kind() const { return session_.spec.kind; }

  private:
    class Keeper;
    TurnRun(Cell cell, TurnSession session, CellOptions options, bool resumed);
    Status start(const TurnRunOptions& options, TurnRunViewers viewers,
                 const std::stop_token& stop);

    Cell cell_;
    TurnSession session_;
    CellOptions options_;
    bool resumed_ = false;
    std::unique_ptr<SharedSource> camera_;
    std::unique_ptr<WorkerPool> pool_;
    std::unique_ptr<Keeper> keeper_;
    std::unique_ptr<CellEffects> effects_;
    std::unique_ptr<Engine> engine_;  // its worker uses all of the above
    std::optional<LinkWatch> watch_;
};

}  // namespace gripscan::app
