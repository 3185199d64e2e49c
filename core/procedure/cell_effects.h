// The procedure's effects on a real or simulated cell: link, camera, disk and computation.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>

#include "core/base/for_each.h"
#include "core/base/progress.h"
#include "core/camera/stereo_source.h"
#include "core/procedure/capture_store.h"
#include "core/procedure/effect_runner.h"
#include "core/procedure/exposure.h"
#include "core/procedure/warm_up_axis.h"

namespace gripscan {

/// What the effects work on. References outlive them.
struct CellEquipment {
    RobotLink* robot = nullptr;  ///< null: there is none to read
    StereoSource& source;
    StereoRig rig;
    std::optional<Box> region;
    std::optional<Eigen::Vector3d> axis_hint;
    std::optional<Pose> T_robot_camera;
    std::filesystem::path session;  ///< folder of the recording
    ExposureSettings exposure;
    StillnessTest differs;
};

/// Where the solved turn goes.
class ResultKeeper {
  public:
    virtual ~ResultKeeper() = default;
    /// Returns once it is safe.
    [[nodiscard]] virtual Status keep(const ComputedTurn& turn) = 0;
};

class CellEffects : public EffectRunner {
  public:
    CellEffects(CellEquipment equipment, TurnWorkspace workspace, CaptureStore& store,
                ResultKeeper& results, ForEach for_each);

    /// Told of long work; called from worker threads.
    void on_progress(decltype(Progress::report) report) { report_ = std::move(report); }

    /// Shown every capture that was made ready, before it is taken into the turn; called from
    /// worker threads, one capture at a time.
    void on_prepared(TurnWorkspace::Viewer viewer) { prepared_ = std::move(viewer); }

    /// Makes the used captures of a resumed turn ready, so that nothing has to wait for it later.
    [[nodiscard]] Status load(const TurnData& data, const Progress& progress);

    [[nodiscard]] Event run(const Effect& effect, const ProcedureState& state,
                            std::stop_token stop) override;
    void halt() override;

  private:
    struct Doing;
    [[nodiscard]] Event expose_shot(const Shot& shot, const Progress& progress);
    [[nodiscard]] Event judge(const effect::Judge& pair, const ProcedureState& state,
                              const Progress& progress);
    [[nodiscard]] Event estimate(const ProcedureState& state, const Progress& progress);
    [[nodiscard]] Event solve(const ProcedureState& state, const Progress& progress);
    /// Everything used, loaded and prepared, that is not there yet.
    [[nodiscard]] Status prepare(const std::vector<RecordedCapture>& captures,
                                 const Progress& progress);
    /// Errors: robot or camera stopped answering, so that there is nothing to assess.
    [[nodiscard]] Result<CellReport> checked(const ProcedureState& state, const WarmUpAxis& warm_up,
                                             const Progress& progress);

    CellEquipment cell_;
    TurnWorkspace workspace_;
    CaptureStore& store_;
    ResultKeeper& results_;
    ForEach for_each_;
    decltype(Progress::report) report_;
    TurnWorkspace::Viewer prepared_;
    std::map<int, int> prepared_attempts_;  ///< by index: which attempt the workspace holds
    std::vector<RecordedCapture> warm_up_;
};

}  // namespace gripscan
