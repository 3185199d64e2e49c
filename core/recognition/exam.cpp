#include "core/recognition/exam.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/cloud/kd_tree.h"

namespace gripscan {
namespace {

std::vector<Eigen::Vector3f> moved(const std::vector<Eigen::Vector3f>& points, const Pose& T) {
    std::vector<Eigen::Vector3f> result;
    result.reserve(points.size());
    for (const auto& p : points) result.push_back((T * p.cast<double>()).cast<float>());
    return result;
}

double mean_distance_m(const std::vector<Eigen::Vector3f>& a,
                       const std::vector<Eigen::Vector3f>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += static_cast<double>((a[i] - b[i]).norm());
    return sum / static_cast<double>(a.size());
}

double largest_distance_m(const std::vector<Eigen::Vector3f>& a,
                          const std::vector<Eigen::Vector3f>& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        largest = std::max(largest, static_cast<double>((a[i] - b[i]).norm()));
    }
    return largest;
}

std::string sentence_of(const ExamResult& result, const ExamLimits& limits) {
    std::size_t found = 0;
    std::size_t passed = 0;
    double worst_m = 0.0;
    double worst_rad = 0.0;
    for (const ExamAnswer& a : result.answers) {
        passed += a.passed ? 1 : 0;
        if (!a.measures) continue;
        ++found;
        worst_m = std::max(worst_m, a.measures->mssd_m);
        worst_rad = std::max(worst_rad, a.measures->turn_rad);
    }
    return fmt::format(
        "{}: {} of {} held-out angles were recognised, {} within {:.1f} deg and {:.1f} mm; worst "
        "{:.2f} deg, {:.2f} mm",
        result.passed ? "yes" : "no", found, result.answers.size(), passed,
        deg_from_rad(limits.turn_rad), kMmPerM * limits.mssd_m, deg_from_rad(worst_rad),
        kMmPerM * worst_m);
}

}  // namespace

PoseMeasures measure_pose(const TemplateModel& model, const Pose& T_estimated,
                          const Pose& T_expected) {
    const auto& points = model.samples.points;
    const auto expected = moved(points, T_expected);
    const auto estimated = moved(points, T_estimated);
    PoseMeasures m;
    m.add_m = mean_distance_m(estimated, expected);
    const KdTree tree(estimated);
    double sum = 0.0;
    for (const auto& p : expected) {
        sum += std::sqrt(static_cast<double>(tree.nearest(p)->squared_distance_m2));
    }
    m.add_s_m = sum / static_cast<double>(points.size());
    const Pose nearest = nearest_equivalent(T_estimated, model.symmetry, T_expected);
    m.mssd_m = largest_distance_m(moved(points, nearest), expected);
    m.turn_rad = rotation_angle_rad(nearest.linear() * T_expected.linear().transpose());
    return m;
}

ExamResult judge_exam(const TemplateModel& model, std::vector<ExamAnswer> answers,
                      const ExamLimits& limits, const ForEach& for_each) {
    ExamResult result{std::move(answers), true, {}};
    for_each(result.answers.size(), [&](std::size_t i) {
        ExamAnswer& a = result.answers[i];
        if (!a.T_estimated) return;
        a.measures = measure_pose(model, *a.T_estimated, a.T_expected);
        a.passed = a.measures->turn_rad <= limits.turn_rad && a.measures->mssd_m <= limits.mssd_m;
    });
    for (const ExamAnswer& a : result.answers) result.passed = result.passed && a.passed;
    result.passed = result.passed && !result.answers.empty();
    result.sentence = sentence_of(result, limits);
    return result;
}

}  // namespace gripscan
