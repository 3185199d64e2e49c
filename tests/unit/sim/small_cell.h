// The simulated cell through a camera of a quarter of the resolution: what the tests render.
#pragma once

#include <memory>

#include "core/sim/arm_motion.h"
#include "core/sim/cell_layout.h"
#include "core/sim/sim_camera.h"

namespace gripscan::sim {

struct SmallCellSettings {
    std::uint64_t seed = 1;
    std::string gripper = "two-finger";
    double noise_levels = 0.0;
    double blur_px = 0.6;
    unsigned image_fraction = 4;  ///< 4: a quarter of the default's pixels a side
};

/// Scene, camera and arm wired as SimCell does it, without its controller.
struct SmallCell {
    CellLayout layout;
    SceneModel model;
    Box region;
    ArmMotion arm;
    double now_s = 0.0;
    std::unique_ptr<SimCamera> camera;

    [[nodiscard]] Lens left_lens() const {
        return {layout.rig.K_left, layout.rig.D_left, layout.rig.image};
    }
    [[nodiscard]] Lens right_lens() const {
        return {layout.rig.K_right, layout.rig.D_right, layout.rig.image};
    }
    /// What one camera sees with the arm standing at these joints.
    [[nodiscard]] Moment moment() const {
        Moment moment;
        moment.true_rad = arm.at(now_s).true_rad;
        return moment;
    }
    [[nodiscard]] StereoFrame picture_at(double joint6_rad, const FrameRequest& request = {});
};

[[nodiscard]] std::unique_ptr<SmallCell> make_small_cell(const SmallCellSettings& settings = {});

}  // namespace gripscan::sim
