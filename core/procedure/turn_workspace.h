// A turn while it grows: every capture is prepared once, every step aligned once, and the turn is
// solved from what is there. The live procedure and the replay of a recording go through it alike,
// so the same captures give the same bytes however they came.
#pragma once

#include <map>
#include <memory>
#include <span>

#include "core/base/for_each.h"
#include "core/base/progress.h"
#include "core/procedure/compute_turn.h"
#include "core/registration/evidence_lines.h"
#include "core/stereo/background_shift.h"
#include "core/stereo/rectifier.h"

namespace gripscan {

/// What a capture is worth by itself.
struct CaptureEvidence {
    int index = 0;
    std::size_t points = 0;              ///< in the registration area
    std::string flaw;                    ///< why it cannot be registered; empty: it can
    std::optional<StereoHealth> health;  ///< where it came as images
    std::optional<ImageFault> fault;     ///< against the captures so far
};

/// A step judged as far as is known now; later steps sharpen the axis and may find another cause.
struct StepResult {
    TurnStep step;
    StepEvidence evidence;
    std::vector<EvidenceLine> lines;  ///< the evidence in words
};

/// A capture made ready, on its way into the workspace.
struct PreparedCapture {
    int index = 0;
    PreparedView view;
    std::optional<StereoHealth> health;
    std::optional<Background> background;
    /// Of an object's turn: how gripper and object were told apart, with both clouds.
    std::shared_ptr<const ObjectSplit> split;
};

/// One thread at a time, but for prepare(); inner loops use the ForEach given.
class TurnWorkspace {
  public:
    /// Errors: a rig that makes no sense.
    [[nodiscard]] static Result<TurnWorkspace> create(const std::optional<StereoRig>& rig,
                                                      const std::optional<Box>& region,
                                                      const ComputeTurnSettings& settings);

    /// Loads the capture's images or cloud: stereo, crop, environment and gripper taken away,
    /// surface, health. May run for several captures at the same time. Errors: what cannot be
    /// loaded or matched, images without a rig, an environment that another camera has seen,
    /// cancelled.
    [[nodiscard]] Result<PreparedCapture> prepare(const RecordedCapture& capture,
                                                  const Progress& progress,
                                                  const ForEach& for_each) const;
    /// Takes it in; one of the same index is replaced and its steps are forgotten.
    CaptureEvidence insert(PreparedCapture capture);
    /// prepare() and insert().
    [[nodiscard]] Result<CaptureEvidence> add(const RecordedCapture& capture,
                                              const Progress& progress, const ForEach& for_each);
    /// Shown a capture that was made ready, in order, before it is taken in.
    using Viewer =
        std::function<void(const RecordedCapture& capture, const PreparedCapture& prepared)>;
    /// Several at the same time, a few in memory at once. The first error in order; what came
    /// before it has been taken in.
    [[nodiscard]] Status add_all(std::span<const RecordedCapture* const> captures,
                                 const Progress& progress, const ForEach& for_each,
                                 const Viewer& viewer = {});
    void forget(int index);

    /// The axis as a warm-up found it: used until three free steps have shown it, and by steps that
    /// are locked to it.
    void set_known_axis(const std::optional<AxisEstimate>& axis);

    /// By what steps are judged from here on; the settings' own before.
    void set_plan(const TurnLimits& limits, double step_rad);

    /// The step between the last two used captures of `so_far`, all of which must have been added.
    /// Errors: fewer than two, one that was not added, cancelled.
    [[nodiscard]] Result<StepResult> last_step(std::span<const RecordedCapture> so_far,
                                               const Progress& progress, const ForEach& for_each);

    /// The turn of the used captures, all of which must have been added; notes, modes and joints
    /// are those of `captures`. Missing alignments are made and kept, nothing is dropped. Errors:
    /// as compute_turn.
    [[nodiscard]] Result<ComputedTurn> solve(std::span<const RecordedCapture> captures,
                                             const Progress& progress, const ForEach& for_each);

    /// How a capture was taken apart; null: not there, or no turn of an object.
    [[nodiscard]] const ObjectSplit* split(int index) const;
    /// A capture's view as prepared; null: not there. Valid until it is forgotten or replaced.
    [[nodiscard]] const PreparedView* view(int index) const;

  private:
    using Pair = std::pair<int, int>;
    TurnWorkspace(std::optional<Box> region, ComputeTurnSettings settings);
    [[nodiscard]] Status prepare_images(const RecordedCapture& capture, const Progress& progress,
                                        const ForEach& for_each, PreparedCapture& made) const;
    [[nodiscard]] Status take_view(const RecordedCapture& capture, Cloud cloud,
                                   const ForEach& for_each, PreparedCapture& made) const;
    [[nodiscard]] std::optional<HeldPose> held_in(std::span<const RecordedCapture> captures,
                                                  const ComputedTurn& computed) const;
    [[nodiscard]] Result<PreparedTurn> gather(std::span<const RecordedCapture> captures) const;
    [[nodiscard]] Status align_missing(const PreparedTurn& turn, const Progress& progress,
                                       const ForEach& for_each);
    [[nodiscard]] StepFinding finding(const CaptureFacts& from, const CaptureFacts& to) const;
    [[nodiscard]] std::optional<CameraShift> shift_between(int from, int to) const;

    std::optional<Box> region_;
    ComputeTurnSettings settings_;
    std::optional<Rectifier> rectifier_;
    /// By index. On the heap: views are referred to while others come.
    std::map<int, std::unique_ptr<PreparedCapture>> captures_;
    std::map<Pair, Alignment> alignments_;  ///< free ones, of `first` onto `second`
};

}  // namespace gripscan
