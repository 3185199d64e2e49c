#include "app/workstation/live_turn.h"

#include <chrono>

#include "ui/views/activity_text.h"

namespace gripscan::app {
namespace {

double now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

bool same_place(const JointAngles& a, const JointAngles& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (std::abs(a[i] - b[i]) > 1e-5) return false;
    }
    return true;
}

}  // namespace

LiveTurn::LiveTurn(std::function<void()> wake) : wake_(std::move(wake)), seen_(wake_) {}

LiveTurn::~LiveTurn() {
    // The live view asks the run's camera, and the run shows it what it takes.
    if (live_) live_->stop();
    run_.reset();
}

Result<std::unique_ptr<LiveTurn>> LiveTurn::open(const TurnRunOptions& options,
                                                 std::function<void()> wake,
                                                 const Progress& progress) {
    std::unique_ptr<LiveTurn> turn(new LiveTurn(std::move(wake)));
    if (Status begun = turn->begin(options, progress); !begun) return forward_error(begun.error());
    return turn;
}

Status LiveTurn::begin(const TurnRunOptions& options, const Progress& progress) {
    folder_ = options.out;
    TurnRunViewers viewers;
    viewers.opened = [this](const Cell& cell) -> Status {
        if (Status s = seen_.set_rig(cell.rig); !s) return s;
        LiveViewSettings settings;
        settings.region = cell.region;
        if (cell.simulated != nullptr) {
            settings.worth_a_look = [this] {
                const std::lock_guard lock(mutex_);
                if (!beat_) return false;
                if (looked_at_ && same_place(*looked_at_, beat_->joints_rad)) return false;
                looked_at_ = beat_->joints_rad;
                return true;
            };
        }
        auto live = LiveView::make(cell.rig, std::move(settings), wake_);
        if (!live) return forward_error(live.error());
        live_ = std::move(*live);
        return {};
    };
    viewers.beat = [this](const RobotBeat& beat) { note_beat(beat); };
    viewers.frame = [this](const FrameRequest& request, const StereoFrame& frame) {
        live_->show(request, frame);
    };
    viewers.prepared = [this](const RecordedCapture& capture, const PreparedCapture& prepared) {
        seen_.add(capture, prepared);
    };
    viewers.waits = [&](const std::string& what) { progress.tell(what, 0, 0); };
    opening_ = progress.report;
    viewers.progress = [this](std::string_view stage, std::size_t done, std::size_t total) {
        const std::lock_guard lock(mutex_);
        if (opening_) opening_(stage, done, total);
        stage_ = stage;
        part_ = total > 0 ? static_cast<double>(done) / static_cast<double>(total) : -1.0;
    };
    viewers.solved = [this](const ComputedTurn& turn) {
        auto kept = std::make_shared<ComputedTurn>(turn);
        const std::lock_guard lock(mutex_);
        solved_ = std::move(kept);
    };
    auto run = TurnRun::open(options, std::move(viewers), progress.stop);
    if (!run) return forward_error(run.error());
    run_ = std::move(*run);
    {
        // The job that opened the turn ends here; what goes on later is the turn's own.
        const std::lock_guard lock(mutex_);
        opening_ = nullptr;
    }
    run_->engine().on_event(wake_);
    live_->start(run_->camera());
    return {};
}

void LiveTurn::note_beat(const RobotBeat& beat) {
    bool moved = false;
    {
        const std::lock_guard lock(mutex_);
        if (beat.alive) {
            moved = !beat_ || !same_place(beat_->joints_rad, beat.reading.joints_rad);
            beat_ = beat.reading;
        }
    }
    if (moved) wake_();
}

Result<std::optional<std::string>> LiveTurn::submit(const Command& command) {
    auto reply = run_->engine().submit(command);
    clock_.tell(state(), now_s());
    tell_live_view();
    return reply;
}

void LiveTurn::tell_live_view() {
    const auto* busy_with = std::get_if<phase::Busy>(&state().phase);
    const bool operator_turns =
        busy_with != nullptr &&
        std::holds_alternative<activity::AwaitingOperator>(busy_with->activity);
    live_->set_quiet(busy() && !operator_turns ? "the turn has the processor to itself" : "");
}

Status LiveTurn::pump() {
    for (;;) {
        auto taken = run_->engine().pump(std::chrono::milliseconds(0));
        if (!taken) return forward_error(taken.error());
        if (!*taken) break;
        const std::lock_guard lock(mutex_);
        part_ = -1.0;
        stage_.clear();
    }
    clock_.tell(state(), now_s());
    tell_live_view();
    return {};
}

bool LiveTurn::busy() const {
    return std::holds_alternative<phase::Busy>(state().phase) ||
           std::holds_alternative<phase::Connecting>(state().phase) ||
           std::holds_alternative<phase::Halting>(state().phase);
}

ui::CellFrame LiveTurn::frame() const {
    const Cell& cell = run_->cell();
    ui::CellFrame frame;
    frame.rig = seen_.rig();
    frame.region = cell.region;
    if (!run_->cell_options().simulated()) frame.file = run_->cell_options().cell;
    frame.T_robot_camera = cell.T_robot_camera;
    const AxisEstimate* axis = nullptr;
    if (state().warm_up && state().warm_up->axis) axis = &*state().warm_up->axis;
    if (solved_ && solved_->report.axis) axis = &*solved_->report.axis;
    if (axis == nullptr) return frame;
    frame.axis = axis->axis;
    frame.axis_sd_rad = axis->sd_rad;
    frame.axis_sd_m = axis->sd_m;
    return frame;
}

std::shared_ptr<const ComputedTurn> LiveTurn::solved() const {
    const std::lock_guard lock(mutex_);
    return state().solved ? solved_ : nullptr;
}

Result<SearchedView> LiveTurn::look(const Progress& progress, const ForEach& for_each) {
    // Below the pictures of the warm-up and of the live view: noise of its own.
    constexpr int kFirstLook = -1000000;
    FrameRequest request;
    request.capture = kFirstLook - looks_++;
    const auto frame = run_->camera().grab(request);
    if (!frame) return forward_error(frame.error());
    auto view = searched_view(run_->cell().rig, *frame, progress, for_each);
    if (!view) return view;
    const std::lock_guard lock(mutex_);
    if (beat_) view->joints_rad = beat_->joints_rad;
    return view;
}

void LiveTurn::show_in(ui::Snapshot& snapshot) const {
    const std::lock_guard lock(mutex_);
    const CellOptions& options = run_->cell_options();
    snapshot.session =
        ui::SessionFacts{folder_,
                         folder_.filename().string(),
                         options.simulated() ? "simulated cell"
                                             : std::filesystem::path(options.cell).stem().string(),
                         false,
                         (folder_ / "results").string(),
                         run_->kind() == SessionKind::kObject};
    snapshot.procedure = &state();
    snapshot.captures = seen_.all();
    snapshot.solved = state().solved ? solved_ : nullptr;
    snapshot.cell = frame();
    snapshot.live = live_->shown();
    snapshot.reading = beat_ ? beat_ : state().reading;
    snapshot.seconds_left = clock_.seconds_left(state());
    const auto* busy = std::get_if<phase::Busy>(&state().phase);
    if (busy != nullptr) {
        const double since_s = clock_.busy_since_s() ? now_s() - *clock_.busy_since_s() : 0.0;
        snapshot.job =
            ui::ShownJob{std::string(ui::activity_word(busy->activity)), part_, since_s, true};
    }
}

}  // namespace gripscan::app
