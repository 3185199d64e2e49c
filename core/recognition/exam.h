// The robot-truth exam: poses recognised at held-out angles against what the joint says.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/for_each.h"
#include "core/recognition/template_model.h"

namespace gripscan {

/// Errors of a pose as object pose benchmarks measure them, m.
struct PoseMeasures {
    double add_m = 0.0;     ///< mean distance of the points (Hinterstoisser 2012)
    double add_s_m = 0.0;   ///< mean distance to the nearest point, for parts that look alike (ADI)
    double mssd_m = 0.0;    ///< largest distance, over the symmetries (Hodaň 2020)
    double turn_rad = 0.0;  ///< rotation between the two, over the symmetries
};
[[nodiscard]] PoseMeasures measure_pose(const TemplateModel& model, const Pose& T_estimated,
                                        const Pose& T_expected);

struct ExamLimits {
    double turn_rad = 0.017453292519943295;  ///< 1°
    double mssd_m = 0.003;
};

struct ExamAnswer {
    int capture = 0;
    double joint_rad = 0.0;           ///< of the held-out angle, from the template's own
    std::optional<Pose> T_estimated;  ///< camera ← template; nothing: not found
    Pose T_expected = Pose::Identity();
    double score = 0.0;
    std::optional<PoseMeasures> measures;
    bool passed = false;
};

struct ExamResult {
    std::vector<ExamAnswer> answers;
    bool passed = false;
    std::string sentence;  ///< a plain yes or no, and why
};

/// Fills in the measures and judges: passed if every angle was found within the limits.
[[nodiscard]] ExamResult judge_exam(const TemplateModel& model, std::vector<ExamAnswer> answers,
                                    const ExamLimits& limits, const ForEach& for_each);

}  // namespace gripscan
