// A part of the simulated cell: a solid and what it is made of.
#pragma once

#include <string>
#include <vector>

#include "core/sim/mesh.h"
#include "core/sim/texture.h"

namespace gripscan::sim {

struct Material {
    double albedo = 0.5;  ///< share of the light that is scattered
    double gloss = 0.0;   ///< strength of the highlight
    Texture texture;
};

struct Part {
    std::string name;
    Mesh mesh;  ///< in the frame of whatever carries the part
    Material material;
};

}  // namespace gripscan::sim
