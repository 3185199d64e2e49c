#include "tests/unit/sim/small_cell.h"

#include "core/base/for_each.h"
#include "core/sim/seeds.h"

namespace gripscan::sim {
namespace {

void shrink(Eigen::Matrix3d& K, unsigned fraction) {
    // Pixel centres are whole numbers, so places scale about the corner (−0.5, −0.5).
    K.topRows<2>() /= fraction;
    K(0, 2) += 0.5 / fraction - 0.5;
    K(1, 2) += 0.5 / fraction - 0.5;
}

}  // namespace

std::unique_ptr<SmallCell> make_small_cell(const SmallCellSettings& settings) {
    CellLayout layout = make_layout(settings.seed);
    const auto n = settings.image_fraction;
    layout.rig.image = {layout.rig.image.width / static_cast<int>(n),
                        layout.rig.image.height / static_cast<int>(n)};
    shrink(layout.rig.K_left, n);
    shrink(layout.rig.K_right, n);
    SceneContents contents;
    contents.gripper = settings.gripper;
    contents.seed = settings.seed;
    contents.texture_contrast = 0.13;
    contents.gripper_centre_m =
        body_poses(layout.joints_rad)[SceneModel::kTool] * Eigen::Vector3d(0, 0, kGripperCentre_m);
    SceneModel model = make_scene(contents);
    const Box region = registration_area(layout, model);
    auto cell = std::unique_ptr<SmallCell>(
        new SmallCell{layout, std::move(model), region, SimRobot(layout.joints_rad, 9), nullptr});
    const CameraSettings camera{{settings.blur_px, settings.noise_levels, 0.22}, settings.seed};
    cell->camera =
        SimCamera::create(
            cell->layout, cell->model, region, camera,
            [robot = &cell->robot] { return robot->arm().true_rad; }, for_each_in_order)
            .value();
    return cell;
}

StereoFrame SmallCell::picture_at(double joint6_rad, const FrameRequest& request) {
    robot.turn_joint6({1, joint6_rad}, {}).value();
    return camera->grab(request).value();
}

}  // namespace gripscan::sim
