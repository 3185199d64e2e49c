#include "core/procedure/turn_workspace.h"

#include <algorithm>
#include <atomic>

#include "core/procedure/view_evidence.h"
#include "core/registration/axis_lock.h"
#include "core/registration/diagnosed_step.h"
#include "core/registration/turn_rows.h"
#include "core/scene/split_view.h"

namespace gripscan {
namespace {

/// Images in memory at the same time: bounds the memory on machines with many cores.
constexpr std::size_t kCapturesAtOnce = 8;

tl::unexpected<Error> about(const RecordedCapture& capture, Error error) {
    if (error.kind != ErrorKind::kCancelled) {
        error.message = fmt::format("capture {}: {}", capture.index, error.message);
    }
    return forward_error(std::move(error));
}

CaptureFacts facts_of(const RecordedCapture& capture) {
    CaptureFacts facts;
    facts.index = capture.index;
    facts.commanded_rad = capture.commanded_rad;
    facts.joint6_rad = capture.joint6_rad;
    facts.joint6_after_rad = capture.joint6_after_rad;
    facts.other_joints_rad = capture.other_joints_rad;
    facts.attempts = capture.attempts;
    facts.mode = capture.mode;
    facts.note = capture.note;
    return facts;
}

/// Free steps from which on they show an axis better than a warm-up: a bad one among three is told.
constexpr std::ptrdiff_t kStepsForAxis = 3;

/// The axis of the steps so far: theirs once there are enough, before that the known one.
std::optional<AxisEstimate> axis_so_far(const std::vector<TurnStep>& rows,
                                        const TurnSettings& settings,
                                        const Eigen::Vector3d& centre_m) {
    const auto turned = std::count_if(rows.begin(), rows.end(), [](const TurnStep& row) {
        return row.T && row.mode == TurnMode::kFree;
    });
    if (turned < kStepsForAxis && settings.known_axis) return settings.known_axis;
    return axis_from_steps(rows, settings.axis_hint, centre_m).estimate;
}

}  // namespace

TurnWorkspace::TurnWorkspace(std::optional<Box> region, ComputeTurnSettings settings)
    : region_(std::move(region)), settings_(std::move(settings)) {
    if (settings_.crop) settings_.turn.region = region_;
}

Result<TurnWorkspace> TurnWorkspace::create(const std::optional<StereoRig>& rig,
                                            const std::optional<Box>& region,
                                            const ComputeTurnSettings& settings) {
    TurnWorkspace workspace(region, settings);
    if (!rig) return workspace;
    auto rectifier = Rectifier::create(*rig);
    if (!rectifier) return forward_error(rectifier.error());
    workspace.rectifier_.emplace(std::move(*rectifier));
    return workspace;
}

Status TurnWorkspace::prepare_images(const RecordedCapture& capture, const Progress& progress,
                                     const ForEach& for_each, PreparedCapture& made) const {
    if (!rectifier_) return input_error("the captures are images, but there is no stereo rig");
    auto frame = capture.load_images();
    if (!frame) return forward_error(frame.error());
    auto rectified = rectifier_->rectify(*frame);
    if (!rectified) return about(capture, rectified.error());
    *frame = StereoFrame{};
    StereoSettings stereo = settings_.stereo;
    stereo.crop_to_region = settings_.crop;
    auto result = stereo_cloud(*rectified, rectifier_->rig(), region_, stereo,
                               Progress{progress.stop, {}}, for_each);
    if (!result) return about(capture, result.error());
    made.health = result->health;
    made.background = background_beside(*rectified, rectifier_->rig(), region_);
    if (Status s = take_view(capture, std::move(result->cloud), for_each, made); !s) return s;
    made.view.image = image_health_of(result->health);
    made.view.field = field_of(rectifier_->rig());
    return {};
}

Result<PreparedCapture> TurnWorkspace::prepare(const RecordedCapture& capture,
                                               const Progress& progress,
                                               const ForEach& for_each) const {
    PreparedCapture made;
    made.index = capture.index;
    if (capture.load_images) {
        Status done = prepare_images(capture, progress, for_each, made);
        if (!done) return forward_error(std::move(done.error()));
        return made;
    }
    auto cloud = capture.load_cloud();
    if (!cloud) return forward_error(cloud.error());
    if (region_ && settings_.crop) *cloud = crop(*cloud, *region_);
    Status taken = take_view(capture, std::move(*cloud), for_each, made);
    if (!taken) return forward_error(std::move(taken.error()));
    return made;
}

Status TurnWorkspace::take_view(const RecordedCapture& capture, Cloud cloud,
                                const ForEach& for_each, PreparedCapture& made) const {
    if (settings_.environment) {
        const auto rest = settings_.environment->subtract(cloud, {}, for_each);
        if (!rest) return about(capture, rest.error());
        cloud = select(cloud, *rest);
    }
    if (!settings_.gripper) {
        made.view = prepare_view(std::move(cloud));
        return {};
    }
    SplitView view = prepare_split_view(*settings_.gripper, settings_.split, facts_of(capture),
                                        std::move(cloud));
    made.view = std::move(view.view);
    made.split = std::move(view.split);
    return {};
}

CaptureEvidence TurnWorkspace::insert(PreparedCapture capture) {
    const int index = capture.index;
    forget(index);
    const auto& kept = *(captures_[index] = std::make_unique<PreparedCapture>(std::move(capture)));
    CaptureEvidence evidence{index, kept.view.cloud.size(), kept.view.flaw, kept.health, {}};
    if (!kept.view.image) return evidence;
    std::vector<ImageHealth> others;
    for (const auto& [other, one] : captures_) {
        if (other != index && one->view.image) others.push_back(*one->view.image);
    }
    evidence.fault = image_fault(*kept.view.image, others);
    return evidence;
}

Result<CaptureEvidence> TurnWorkspace::add(const RecordedCapture& capture, const Progress& progress,
                                           const ForEach& for_each) {
    auto made = prepare(capture, progress, for_each);
    if (!made) return forward_error(std::move(made.error()));
    return insert(std::move(*made));
}

Status TurnWorkspace::add_all(std::span<const RecordedCapture* const> captures,
                              const Progress& progress, const ForEach& for_each,
                              const Viewer& viewer) {
    // One capture has all threads to itself; several run side by side, each in order.
    const ForEach inner = captures.size() == 1 ? for_each : ForEach(for_each_in_order);
    const ForEach outer = captures.size() == 1 ? ForEach(for_each_in_order) : for_each;
    std::atomic<std::size_t> done{0};
    progress.tell("stereo", 0, captures.size());
    for (std::size_t begin = 0; begin < captures.size(); begin += kCapturesAtOnce) {
        const std::size_t count = std::min(kCapturesAtOnce, captures.size() - begin);
        std::vector<Result<PreparedCapture>> made;
        for (std::size_t i = 0; i < count; ++i) made.emplace_back(cancelled_error());
        outer(count, [&](std::size_t i) {
            if (progress.cancelled()) return;
            made[i] = prepare(*captures[begin + i], progress, inner);
            progress.tell("stereo", ++done, captures.size());
        });
        // In order, so that the same capture is named whatever the threads did.
        for (std::size_t i = 0; i < count; ++i) {
            if (!made[i]) return forward_error(std::move(made[i].error()));
            if (viewer) viewer(*captures[begin + i], *made[i]);
            insert(std::move(*made[i]));
        }
    }
    return {};
}

void TurnWorkspace::forget(int index) {
    captures_.erase(index);
    std::erase_if(alignments_, [&](const auto& entry) {
        return entry.first.first == index || entry.first.second == index;
    });
}

void TurnWorkspace::set_known_axis(const std::optional<AxisEstimate>& axis) {
    settings_.turn.known_axis = axis;
}

void TurnWorkspace::set_plan(const TurnLimits& limits, double step_rad) {
    settings_.turn.limits = limits;
    settings_.turn.step_rad = step_rad;
}

const ObjectSplit* TurnWorkspace::split(int index) const {
    const auto found = captures_.find(index);
    return found == captures_.end() ? nullptr : found->second->split.get();
}

const PreparedView* TurnWorkspace::view(int index) const {
    const auto found = captures_.find(index);
    return found == captures_.end() ? nullptr : &found->second->view;
}

std::optional<CameraShift> TurnWorkspace::shift_between(int from, int to) const {
    const auto& before = captures_.at(from)->background;
    const auto& now = captures_.at(to)->background;
    if (!before || !now) return std::nullopt;
    return camera_shift_of(*before, *now);
}

StepFinding TurnWorkspace::finding(const CaptureFacts& from, const CaptureFacts& to) const {
    StepFinding result;
    const auto aligned = alignments_.find({from.index, to.index});
    if (aligned != alignments_.end()) result.alignment = aligned->second;
    result.camera_shift = shift_between(from.index, to.index);
    return result;
}

Result<PreparedTurn> TurnWorkspace::gather(std::span<const RecordedCapture> captures) const {
    PreparedTurn turn;
    for (const RecordedCapture& capture : captures) {
        if (!capture.used) continue;
        const PreparedView* prepared = view(capture.index);
        if (prepared == nullptr) {
            return input_error("capture {} is used but was not added to the turn", capture.index);
        }
        turn.facts.push_back(facts_of(capture));
        turn.views.push_back(prepared);
    }
    if (turn.views.size() < 2) {
        return input_error("a turn needs at least two used captures, there {} {}",
                           turn.views.size() == 1 ? "is" : "are", turn.views.size());
    }
    return turn;
}

Status TurnWorkspace::align_missing(const PreparedTurn& turn, const Progress& progress,
                                    const ForEach& for_each) {
    const std::size_t steps = turn.views.size() - 1;
    std::vector<std::size_t> missing;
    for (std::size_t i = 0; i < steps; ++i) {
        const bool locked = turn.facts[i + 1].mode == TurnMode::kAxisLocked &&
                            settings_.turn.method == TurnMethod::kTurn;
        if (!locked && !alignments_.contains({turn.facts[i].index, turn.facts[i + 1].index})) {
            missing.push_back(i);
        }
    }
    std::vector<Result<Alignment>> made(missing.size(), cancelled_error());
    std::atomic<std::size_t> done = steps - missing.size();
    // One alone shares its own loops among the threads; several run side by side.
    const ForEach inner = missing.size() == 1 ? for_each : ForEach(for_each_in_order);
    const auto body = [&](std::size_t m) {
        if (progress.cancelled()) return;
        const std::size_t i = missing[m];
        made[m] = align_views(turn.facts[i], *turn.views[i], turn.facts[i + 1], *turn.views[i + 1],
                              settings_.turn, progress, inner);
        progress.tell("registration", ++done, steps);
    };
    if (missing.size() == 1) {
        body(0);
    } else {
        for_each(missing.size(), body);
    }
    for (std::size_t m = 0; m < missing.size(); ++m) {
        if (!made[m]) return forward_error(std::move(made[m].error()));
        const std::size_t i = missing[m];
        alignments_[{turn.facts[i].index, turn.facts[i + 1].index}] = std::move(*made[m]);
    }
    return {};
}

Result<StepResult> TurnWorkspace::last_step(std::span<const RecordedCapture> so_far,
                                            const Progress& progress, const ForEach& for_each) {
    auto turn = gather(so_far);
    if (!turn) return forward_error(std::move(turn.error()));
    if (Status s = align_missing(*turn, progress, for_each); !s) {
        return forward_error(std::move(s.error()));
    }
    const auto faults = image_faults(turn->views);
    const auto end = [&](std::size_t k) {
        return StepEnd{turn->facts[k], *turn->views[k], faults[k]};
    };
    std::vector<TurnStep> rows;
    for (std::size_t i = 0; i + 1 < turn->views.size(); ++i) {
        turn->steps.push_back(finding(turn->facts[i], turn->facts[i + 1]));
        rows.push_back(measured_step(end(i), end(i + 1), turn->steps[i], settings_.turn));
    }
    auto axis = axis_so_far(rows, settings_.turn, turn->views.back()->surface.centre_m);
    const std::size_t last = turn->views.size() - 1;
    if (turn->facts[last].mode == TurnMode::kAxisLocked) {
        auto locked =
            axis_for_lock(turn->facts, turn->views, axis, settings_.turn, progress, for_each);
        if (!locked) return forward_error(std::move(locked.error()));
        axis = *locked;
    }
    DiagnosedStep judged =
        diagnosed_step(end(last - 1), end(last), turn->steps.back(), axis, settings_.turn);
    judged.step.index = static_cast<int>(last);
    StepResult result{std::move(judged.step), std::move(judged.evidence), {}};
    result.lines = evidence_lines(result.step, result.evidence, settings_.turn.limits);
    return result;
}

Result<ComputedTurn> TurnWorkspace::solve(std::span<const RecordedCapture> captures,
                                          const Progress& progress, const ForEach& for_each) {
    auto turn = gather(captures);
    if (!turn) return forward_error(std::move(turn.error()));
    // One view without points costs its steps; a recording without any is not the one meant.
    if (std::all_of(turn->views.begin(), turn->views.end(),
                    [](const PreparedView* view) { return view->cloud.empty(); })) {
        return input_error(
            "no capture has points in the registration area; check region, light and the camera's "
            "range");
    }
    if (Status s = align_missing(*turn, progress, for_each); !s) {
        return forward_error(std::move(s.error()));
    }
    for (std::size_t i = 0; i + 1 < turn->views.size(); ++i) {
        turn->steps.push_back(finding(turn->facts[i], turn->facts[i + 1]));
    }
    turn->camera_shift = [&](std::size_t from, std::size_t to) {
        return shift_between(turn->facts[from].index, turn->facts[to].index);
    };
    auto report = finish_turn(*turn, settings_.turn, progress, for_each);
    if (!report) return forward_error(std::move(report.error()));

    ComputedTurn computed;
    std::vector<std::optional<Pose>> poses;
    std::size_t k = 0;
    for (const RecordedCapture& capture : captures) {
        poses.push_back(capture.used ? report->poses[k++] : std::nullopt);
        computed.health.push_back(capture.used ? captures_.at(capture.index)->health
                                               : std::nullopt);
    }
    report->poses = std::move(poses);
    computed.report = std::move(*report);
    computed.held = held_in(captures, computed);
    return computed;
}

std::optional<HeldPose> TurnWorkspace::held_in(std::span<const RecordedCapture> captures,
                                               const ComputedTurn& computed) const {
    std::vector<HeldView> views;
    for (std::size_t k = 0; k < captures.size(); ++k) {
        const auto& T_first_k = computed.report.poses[k];
        if (!T_first_k) continue;
        const auto& holder = captures_.at(captures[k].index)->view.holder;
        if (!holder || !holder->usable()) continue;
        views.push_back({holder->T_camera_holder, T_first_k->inverse()});
    }
    return held_pose(views, centroid(computed.report.merged));
}

}  // namespace gripscan
