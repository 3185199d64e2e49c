#include "core/registration/align.h"

#include "core/registration/align_surfaces.h"

namespace gripscan {

Result<Alignment> align(const Cloud& source, const Cloud& target, const AlignSettings& settings,
                        const Progress& progress, const ForEach& for_each) {
    Result<Surface> from = make_surface(source);
    if (!from) return forward_error({from.error().kind, "source: " + from.error().message});
    Result<Surface> to = make_surface(target);
    if (!to) return forward_error({to.error().kind, "target: " + to.error().message});
    return align_surfaces(*from, *to, settings, progress, for_each);
}

}  // namespace gripscan
