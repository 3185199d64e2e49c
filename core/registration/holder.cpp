#include "core/registration/holder.h"

namespace gripscan {

Holder make_holder(const Cloud& cloud, const Pose& T_camera_holder) {
    Holder holder;
    auto surface = make_surface(cloud);
    if (surface) {
        holder.surface = std::move(*surface);
    } else {
        holder.flaw = std::move(surface.error().message);
    }
    holder.T_camera_holder = T_camera_holder;
    return holder;
}

}  // namespace gripscan
