// One seed for the cell, an independent one for every use of it.
#pragma once

#include <cstdint>

#include "core/base/seeded_random.h"

namespace gripscan::sim {

enum class Use : std::uint64_t {
    kFixtures = 1,
    kTexture,
    kCamera,
    kLights,
    kNoise,
    kRobot,
    kFaults
};

[[nodiscard]] inline std::uint64_t seed_for(std::uint64_t seed, Use use, std::uint64_t number = 0) {
    SeededRandom first(seed * 64 + static_cast<std::uint64_t>(use));
    SeededRandom second(first.next() + number);
    return second.next();
}

}  // namespace gripscan::sim
