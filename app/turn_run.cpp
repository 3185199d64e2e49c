#include "app/turn_run.h"

#include "app/session_settings.h"
#include "core/procedure/region_stillness.h"
#include "core/report/gripper_template_file.h"
#include "core/scene/environment_file.h"

namespace gripscan::app {
namespace {

/// Begins the session. What it needs from elsewhere is looked at before anything is made: a
/// template, an environment or a region that cannot be used is the likeliest mistake.
Result<TurnSession> begin(const TurnRunOptions& options, const TurnRunViewers& viewers, Cell& cell,
                          const std::stop_token& stop) {
    std::optional<std::string> gripper;
    if (!options.gripper.empty()) {
        gripper = name_of_template(options.out, options.gripper);
        auto usable = load_gripper_template(options.out, *gripper);
        if (!usable) return forward_error(usable.error());
    }
    std::optional<EnvironmentModel> environment;
    if (!options.environment.empty()) {
        auto loaded = load_environment(options.environment);
        if (!loaded) return forward_error(loaded.error());
        environment = std::move(*loaded);
    }
    auto opened = open_cell(options.cell, stop, viewers.waits);
    if (!opened) return forward_error(opened.error());
    cell = std::move(*opened);
    if (auto seen = region_stillness(cell.rig, cell.region); !seen) {
        return input_error("{}: {}", options.cell.cell, seen.error().message);
    }
    auto session = begin_session(options.out, options.cell, cell, gripper);
    if (!session || !environment) return session;
    Status kept = keep_environment(options.out, *environment);
    if (!kept) return forward_error(kept.error());
    return session;
}

}  // namespace

/// Keeps the results and shows the turn to whoever looks.
class TurnRun::Keeper : public ResultKeeper {
  public:
    Keeper(const TurnRunOptions& options, std::function<void(const ComputedTurn&)> viewer)
        : results(options.out, options.turn), viewer_(std::move(viewer)) {}
    Status keep(const ComputedTurn& turn) override {
        Status kept = results.keep(turn);
        if (kept && viewer_) viewer_(turn);
        return kept;
    }
    RunResults results;

  private:
    std::function<void(const ComputedTurn&)> viewer_;
};

TurnRun::TurnRun(Cell cell, TurnSession session, CellOptions options, bool resumed)
    : cell_(std::move(cell)),
      session_(std::move(session)),
      options_(std::move(options)),
      resumed_(resumed) {}

TurnRun::~TurnRun() = default;

Engine& TurnRun::engine() {
    return *engine_;
}

const RunResults& TurnRun::results() const {
    return keeper_->results;
}

Result<std::unique_ptr<TurnRun>> TurnRun::open(const TurnRunOptions& options,
                                               TurnRunViewers viewers,
                                               const std::stop_token& stop) {
    std::unique_ptr<TurnRun> run;
    if (!options.resume || is_fresh_session(options.out)) {
        Cell cell;
        auto session = begin(options, viewers, cell, stop);
        if (!session) return forward_error(session.error());
        run.reset(new TurnRun(std::move(cell), std::move(*session), options.cell, false));
    } else {
        auto remembered = remember_session(options.out);
        if (!remembered) return forward_error(remembered.error());
        auto resumed = options.in_its_mode
                           ? Result<CellOptions>(remembered->options)
                           : resumed_cell(remembered->options, options.cell, options.given);
        if (!resumed) {
            return input_error("{}: {}", options.out.string(), resumed.error().message);
        }
        const CellOptions cell_options = std::move(*resumed);
        if (Status there = check_cell_file(options.out, cell_options); !there) {
            return forward_error(there.error());
        }
        auto cell = open_cell(cell_options, stop, viewers.waits);
        if (!cell) return forward_error(cell.error());
        run.reset(new TurnRun(std::move(*cell),
                              TurnSession{std::move(remembered->store), std::move(remembered->spec),
                                          std::move(remembered->state)},
                              cell_options, true));
    }
    if (Status started = run->start(options, std::move(viewers), stop); !started) {
        return forward_error(started.error());
    }
    return run;
}

Status TurnRun::start(const TurnRunOptions& options, TurnRunViewers viewers,
                      const std::stop_token& stop) {
    if (viewers.opened) {
        if (Status s = viewers.opened(cell_); !s) return s;
    }
    camera_ = std::make_unique<SharedSource>(*cell_.camera, std::move(viewers.frame));
    pool_ = std::make_unique<WorkerPool>(options.threads);
    keeper_ = std::make_unique<Keeper>(options, std::move(viewers.solved));
    auto settings =
        session_settings(Session{options.out, session_.spec, cell_.rig, {}}, options.turn);
    if (!settings) return forward_error(settings.error());
    auto workspace = TurnWorkspace::create(cell_.rig, session_.spec.region, *settings);
    if (!workspace) return forward_error(workspace.error());
    auto differs = region_stillness(cell_.rig, session_.spec.region);
    if (!differs) return forward_error(differs.error());
    CellEquipment equipment{.robot = cell_.robot.get(),
                            .source = *camera_,
                            .rig = cell_.rig,
                            .region = session_.spec.region,
                            .axis_hint = session_.spec.axis_hint,
                            .T_robot_camera = cell_.T_robot_camera,
                            .session = options.out,
                            .exposure = {.settle_s = cell_.settle_s},
                            .differs = std::move(*differs)};
    effects_ = std::make_unique<CellEffects>(std::move(equipment), std::move(*workspace),
                                             session_.store, *keeper_, pool_->for_each());
    effects_->on_progress(viewers.progress);
    effects_->on_prepared(std::move(viewers.prepared));
    if (resumed_) {
        if (Status s = effects_->load(session_.state.data, {stop, viewers.progress}); !s) return s;
    }
    engine_ = std::make_unique<Engine>(std::move(session_.state), *effects_, session_.store,
                                       session_.store.journal());
    if (cell_.robot) watch_.emplace(*cell_.robot, *engine_, std::move(viewers.beat));
    if (!resumed_) return {};
    engine_->tell(event::ProgramEnded{});
    auto taken = engine_->pump(std::chrono::seconds(1));
    if (!taken) return forward_error(taken.error());
    return {};
}

}  // namespace gripscan::app
