// A lamp mirrored in polished metal: a spot so bright that the sensor saturates.
#pragma once

#include <opencv2/core/mat.hpp>

namespace gripscan::sim {

/// Adds a spot to an image of brightness (CV_32F levels): white within the radius, fading around
/// it over half as much again.
void add_glare(cv::Mat& brightness, cv::Point2d centre_px, double radius_px);

}  // namespace gripscan::sim
