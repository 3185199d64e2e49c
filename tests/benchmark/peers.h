// The methods that are compared: each turns two clouds into the motion of the first onto the
// second, from the identity, on one thread.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/cloud/cloud.h"
#include "core/geometry/pose.h"

namespace gripscan::test {

struct Peer {
    std::string name;
    /// Nothing if it says itself that it failed.
    std::function<std::optional<Pose>(const Cloud& source, const Cloud& target)> align;
};

/// gripscan first; then PCL's on clouds thinned to 3 mm, as these methods are used.
[[nodiscard]] std::vector<Peer> all_peers();

}  // namespace gripscan::test
