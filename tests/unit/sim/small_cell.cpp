#include "tests/unit/sim/small_cell.h"

#include "core/base/for_each.h"
#include "core/sim/seeds.h"

namespace gripscan::sim {
std::unique_ptr<SmallCell> make_small_cell(const SmallCellSettings& settings) {
    CellLayout layout = make_layout(settings.seed);
    layout.rig = shrunk(layout.rig, settings.image_fraction);
    SceneContents contents;
    contents.gripper = settings.gripper;
    contents.seed = settings.seed;
    contents.texture_contrast = 0.13;
    contents.gripper_centre_m =
        body_poses(layout.joints_rad)[SceneModel::kTool] * Eigen::Vector3d(0, 0, kGripperCentre_m);
    SceneModel model = make_scene(contents);
    const Box region = registration_area(layout, model);
    auto cell = std::unique_ptr<SmallCell>(new SmallCell{
        layout, std::move(model), region, ArmMotion(layout.joints_rad, 9), 0.0, nullptr});
    const CameraSettings camera{{settings.blur_px, settings.noise_levels, 0.22}, settings.seed};
    cell->camera =
        SimCamera::create(
            cell->layout, cell->model, region, camera,
            [cell = cell.get()](const FrameRequest&) { return cell->moment(); }, for_each_in_order)
            .value();
    return cell;
}

StereoFrame SmallCell::picture_at(double joint6_rad, const FrameRequest& request) {
    arm.turn_joint6(joint6_rad, 100.0, now_s);
    now_s += arm.duration_s() + ArmMotion::kSettle_s;
    return camera->grab(request).value();
}

}  // namespace gripscan::sim
