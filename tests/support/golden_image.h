// Pictures against pictures that were looked at before. The one place that says how much may
// differ.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace gripscan::test {

struct Picture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;  ///< rows from top to bottom
};

/// The software rasteriser compiles for the processor it runs on, so single steps of a channel may
/// differ between machines: a pixel counts as different from kChannel steps on, and kShare of all
/// pixels may.
struct ImageTolerance {
    static constexpr int kChannel = 12;
    static constexpr double kShare = 0.0005;
};

/// Number of pixels that differ; all of them where the sizes do.
[[nodiscard]] std::size_t different_pixels(const Picture& one, const Picture& other);

/// Compares with tests/render/golden/`name`.png. On failure actual, expected and difference are
/// written to the folder of the test programs and named in the failure.
/// GRIPSCAN_UPDATE_GOLDEN=1 writes the golden picture instead.
void expect_golden(const Picture& picture, const std::string& name);

}  // namespace gripscan::test
