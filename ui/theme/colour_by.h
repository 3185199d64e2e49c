// What colours the points of a cloud.
#pragma once

namespace gripscan::ui {

enum class ColourBy { kImage, kStep, kResidual, kSeen, kDepth, kNormal, kSigma, kChunk };

}  // namespace gripscan::ui
