// How a surface lies on another one of the same shape, or on itself.
#pragma once

#include <vector>

#include "core/base/for_each.h"
#include "core/cloud/kd_tree.h"
#include "core/geometry/pose.h"

namespace gripscan {

struct TemplateModel;

struct ShapeMatch {
    Pose T_still_moving = Pose::Identity();
    double same = 0.0;  ///< share of the moving surface that lies on the still one
};

class ShapeMatcher {
  public:
    /// Refers to the model.
    explicit ShapeMatcher(const TemplateModel& still);

    /// Share of the samples of `moving` that T carries onto the surface.
    [[nodiscard]] double same(const TemplateModel& moving, const Pose& T) const;
    [[nodiscard]] ShapeMatch settled(const TemplateModel& moving, const Pose& start) const;
    /// Poses in which most of `moving` lies on the surface, the best first; poses closer than
    /// 12° in rotation count as one.
    [[nodiscard]] std::vector<ShapeMatch> search(const TemplateModel& moving, double least_same,
                                                 const ForEach& for_each) const;

  private:
    const TemplateModel& still_;
    KdTree tree_;
    double tolerance_m_;
};

}  // namespace gripscan
