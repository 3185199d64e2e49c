// Learns the static environment from several captures of it.
#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/geometry/box.h"
#include "core/scene/environment_model.h"

namespace gripscan {

struct LearnSettings {
    /// The arm stands in the picture, elsewhere in every capture: the farthest surface that is seen
    /// again and again is the environment, what was seen before it is the arm. Otherwise the arm is
    /// out of the picture and all that is seen again is the environment.
    bool arm_in_view = false;
    std::optional<Box> region;  ///< registration area: what is seen there is never the arm
    double voxel_m = 0.008;
    int fewest_captures = 3;
};

/// Captures are added one after the other; a capture costs 4 bytes a pixel.
class EnvironmentLearner {
  public:
    explicit EnvironmentLearner(LearnSettings settings) : settings_(std::move(settings)) {}

    /// Errors: a cloud without a grid, too few points to know the camera by, or a cloud of another
    /// camera than the ones before.
    [[nodiscard]] Status add(const Cloud& cloud);

    /// Errors: too few captures, hardly anything seen twice, cancelled.
    [[nodiscard]] Result<EnvironmentModel> finish(const Progress& progress,
                                                  const ForEach& for_each) const;

    [[nodiscard]] int captures() const { return static_cast<int>(planes_.size()); }

  private:
    LearnSettings settings_;
    int width_ = 0;
    int height_ = 0;
    Pinhole camera_;
    std::vector<std::vector<float>> planes_;  ///< inverse depth of every pixel; 0: not seen
    std::vector<std::uint16_t> grey_sum_;
    std::vector<std::uint8_t> seen_;
};

}  // namespace gripscan
