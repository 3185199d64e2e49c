// A capture as the turn takes it: what is known of it, its cloud, and the cloud made ready once.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "core/registration/holder.h"
#include "core/registration/image_health.h"
#include "core/registration/surface.h"
#include "core/registration/verdict.h"
#include "core/registration/view_field.h"

namespace gripscan {

/// What is known of a used capture beside its data.
struct CaptureFacts {
    int index = 0;                           ///< as in captures.csv
    std::optional<double> commanded_rad;     ///< turn since the first capture
    std::optional<double> joint6_rad;        ///< measured before the exposure
    std::optional<double> joint6_after_rad;  ///< measured after it
    /// J1 … J5, where they were read.
    std::optional<std::array<double, 5>> other_joints_rad;
    int attempts = 1;
    TurnMode mode = TurnMode::kFree;  ///< of the step that leads to this capture
    std::string note;                 ///< accepted by the operator against the verdict; empty: not
};

/// One used capture with its data.
struct TurnView : CaptureFacts {
    Cloud cloud;  ///< camera frame, cropped to the registration area
};

/// Data of a capture made ready for registration, once; only read afterwards.
struct PreparedView {
    Cloud cloud;
    Surface surface;
    std::string flaw;  ///< why there is no surface; empty: there is one
    Cause flaw_cause = Cause::kTexture;
    std::shared_ptr<const Holder> holder;  ///< what holds the part; null: it is the gripper itself
    std::optional<ImageHealth> image;      ///< where the cloud came from images
    std::optional<ViewField> field;        ///< of the camera, where it is known

    [[nodiscard]] bool usable() const { return flaw.empty(); }
};

/// A cloud that is too poor to register is no error but a flaw.
[[nodiscard]] PreparedView prepare_view(Cloud cloud);

}  // namespace gripscan
