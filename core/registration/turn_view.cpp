#include "core/registration/turn_view.h"

namespace gripscan {

PreparedView prepare_view(Cloud cloud) {
    PreparedView view;
    auto surface = make_surface(cloud);
    if (surface) {
        view.surface = std::move(*surface);
    } else {
        view.flaw = std::move(surface.error().message);
    }
    view.cloud = std::move(cloud);
    return view;
}

}  // namespace gripscan
