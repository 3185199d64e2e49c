// Clouds for the tests of files and filters: every combination of what a cloud may know.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "core/base/seeded_random.h"
#include "core/cloud/cloud.h"

namespace gripscan::test {

/// Bits of a set of fields.
enum Fields : unsigned {
    kNormals = 1,
    kIntensity = 2,
    kSigma = 4,
    kSeen = 8,
    kGrid = 16,
    kViewpoint = 32,
    kFieldSets = 64,  ///< number of sets
};

inline std::string name_of_fields(unsigned fields) {
    std::string name = "xyz";
    const char* names[] = {"Normals", "Intensity", "Sigma", "Seen", "Grid", "Viewpoint"};
    for (unsigned i = 0; i < 6; ++i) {
        if ((fields & (1U << i)) != 0) name += names[i];
    }
    return name;
}

/// About n points with awkward floats; with kGrid about a third of the cells is empty.
inline Cloud random_cloud(std::uint64_t seed, std::size_t n, unsigned fields) {
    SeededRandom random(seed);
    const auto number = [&](double low, double high) {
        return static_cast<float>(random.uniform(low, high));
    };
    Cloud cloud;
    const int width = 17;
    for (std::size_t i = 0; i < n; ++i) {
        if ((fields & kGrid) != 0 && random.uniform() < 0.3) continue;
        cloud.points.emplace_back(number(-0.2, 0.2), number(-0.2, 0.2), number(0.6, 0.9));
        if ((fields & kNormals) != 0) {
            Eigen::Vector3f normal(number(-1, 1), number(-1, 1), number(-2, -1));
            cloud.normals.push_back(normal.normalized());
        }
        if ((fields & kIntensity) != 0) cloud.intensity.push_back(number(0, 255));
        if ((fields & kSigma) != 0) cloud.sigma.push_back(number(0, 1e-3));
        if ((fields & kSeen) != 0) {
            cloud.seen.push_back(static_cast<std::uint16_t>(random.next() % 65536));
        }
        if ((fields & kGrid) != 0) cloud.cell.push_back(static_cast<std::int32_t>(i));
    }
    if ((fields & kGrid) != 0) {
        cloud.grid_width = width;
        cloud.grid_height = static_cast<int>((n + width - 1) / width);
    }
    if ((fields & kViewpoint) != 0) {
        cloud.viewpoint = Eigen::Vector3f(number(-1, 1), number(-1, 1), number(-1, 1));
    }
    return cloud;
}

}  // namespace gripscan::test
