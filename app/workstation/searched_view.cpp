#include "app/workstation/searched_view.h"

#include "app/environment_work.h"
#include "app/workstation/picture_facts.h"
#include "core/stereo/rectifier.h"

namespace gripscan::app {

Result<SearchedView> searched_view(const StereoRig& rig, const StereoFrame& frame,
                                   const Progress& progress, const ForEach& for_each) {
    const auto rectifier = Rectifier::create(rig);
    if (!rectifier) return forward_error(rectifier.error());
    auto cloud = whole_cloud(frame, *rectifier, progress, for_each);
    if (!cloud) return forward_error(cloud.error());
    const auto rectified = rectifier->rectify(frame);
    if (!rectified) return forward_error(rectified.error());
    auto picture = std::make_shared<ui::StereoPicture>();
    picture->left = rectified->left.clone();
    picture->right = rectified->right.clone();
    picture->disparity = disparity_of(*cloud, rectifier->rig());
    picture->t_s = frame.t_s;
    return SearchedView{std::move(*cloud), std::move(picture), std::nullopt};
}

}  // namespace gripscan::app
