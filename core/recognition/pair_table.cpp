#include "core/recognition/pair_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gripscan {
namespace {

/// A pair this close (in bins) to the border of its bin is entered beyond it too, for noise will
/// carry its counterpart there.
constexpr float kBorder = 0.25F;

float angle_between(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
    // Abramowitz and Stegun 4.4.45: to 7e-5 rad, a two-thousandth of a bin, at a fifth of the time.
    const float c = std::clamp(a.dot(b), -1.0F, 1.0F);
    const float x = std::abs(c);
    const float near =
        std::sqrt(1.0F - x) * (1.5707288F + x * (-0.2121144F + x * (0.0742610F + x * -0.0187293F)));
    return c < 0.0F ? std::numbers::pi_v<float> - near : near;
}

/// One or two neighbouring bins.
struct BinRange {
    int first;
    int last;
};
BinRange bins_around(float value, int count) {
    const int middle = static_cast<int>(value);
    const float rest = value - static_cast<float>(middle);
    const int low = rest < kBorder ? middle - 1 : middle;
    const int high = rest > 1.0F - kBorder ? middle + 1 : middle;
    return {std::clamp(low, 0, count - 1), std::clamp(high, 0, count - 1)};
}

}  // namespace

Eigen::Isometry3f onto_x(const Eigen::Vector3f& point, const Eigen::Vector3f& normal) {
    Eigen::Isometry3f T = Eigen::Isometry3f::Identity();
    T.linear() =
        Eigen::Quaternionf::FromTwoVectors(normal, Eigen::Vector3f::UnitX()).toRotationMatrix();
    T.translation() = -(T.linear() * point);
    return T;
}

PairTable::Feature PairTable::feature(const Eigen::Vector3f& p1, const Eigen::Vector3f& n1,
                                      const Eigen::Vector3f& p2, const Eigen::Vector3f& n2) const {
    const Eigen::Vector3f d = p2 - p1;
    const float length = d.norm();
    const Eigen::Vector3f u = length > 0.0F ? Eigen::Vector3f(d / length) : n1;
    constexpr float kPerRad = kAngles / std::numbers::pi_v<float>;
    return {length * bins_per_m_,
            {angle_between(n1, u) * kPerRad, angle_between(n2, u) * kPerRad,
             angle_between(n1, n2) * kPerRad}};
}

template <typename Use>
void PairTable::for_each_pair(const OrientedPoints& part, Use use) const {
    for (std::size_t r = 0; r < part.size(); ++r) {
        const Eigen::Isometry3f T = onto_x(part.points[r], part.normals[r]);
        for (std::size_t i = 0; i < part.size(); ++i) {
            if (i == r) continue;
            const Eigen::Vector3f q = T * part.points[i];
            const float turn = std::atan2(-q.z(), q.y()) / (2.0F * std::numbers::pi_v<float>);
            const auto angle = static_cast<std::uint16_t>(
                static_cast<int>(std::floor(turn * kTurn)) & (kTurn - 1));
            const Feature f =
                feature(part.points[r], part.normals[r], part.points[i], part.normals[i]);
            const BinRange d = bins_around(f.distance, distances_);
            const BinRange a = bins_around(f.angles[0], kAngles);
            const BinRange b = bins_around(f.angles[1], kAngles);
            const BinRange c = bins_around(f.angles[2], kAngles);
            for (int i0 = d.first; i0 <= d.last; ++i0)
                for (int i1 = a.first; i1 <= a.last; ++i1)
                    for (int i2 = b.first; i2 <= b.last; ++i2)
                        for (int i3 = c.first; i3 <= c.last; ++i3) {
                            const int bin = ((i0 * kAngles + i1) * kAngles + i2) * kAngles + i3;
                            use(static_cast<std::size_t>(bin),
                                Pair{static_cast<std::uint16_t>(r), angle});
                        }
        }
    }
}

PairTable::PairTable(const OrientedPoints& part, double step_m)
    : bins_per_m_(static_cast<float>(1.0 / step_m)) {
    for (const auto& p : part.points) {
        for (const auto& q : part.points) longest_m_ = std::max(longest_m_, (p - q).norm());
    }
    distances_ = static_cast<int>(longest_m_ * bins_per_m_) + 2;
    begin_.assign(static_cast<std::size_t>(distances_ * kAngles * kAngles * kAngles) + 1, 0);
    for_each_pair(part, [&](std::size_t bin, Pair) { ++begin_[bin + 1]; });
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    pairs_.resize(begin_.back());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for_each_pair(part, [&](std::size_t bin, Pair pair) { pairs_[next[bin]++] = pair; });
}

std::span<const PairTable::Pair> PairTable::find(const Eigen::Vector3f& p1,
                                                 const Eigen::Vector3f& n1,
                                                 const Eigen::Vector3f& p2,
                                                 const Eigen::Vector3f& n2) const {
    const Feature f = feature(p1, n1, p2, n2);
    const int d = static_cast<int>(f.distance);
    if (d >= distances_) return {};
    const auto at = [](float x) { return std::min(static_cast<int>(x), kAngles - 1); };
    const int bin =
        ((d * kAngles + at(f.angles[0])) * kAngles + at(f.angles[1])) * kAngles + at(f.angles[2]);
    const auto i = static_cast<std::size_t>(bin);
    return {pairs_.data() + begin_[i], pairs_.data() + begin_[i + 1]};
}

}  // namespace gripscan
