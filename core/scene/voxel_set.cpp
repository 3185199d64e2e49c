#include "core/scene/voxel_set.h"

#include <algorithm>
#include <cmath>

namespace gripscan {
namespace {

constexpr int kBits = 21;
constexpr std::int64_t kHalf = std::int64_t{1} << (kBits - 1);
constexpr std::uint64_t kMask = (std::uint64_t{1} << kBits) - 1;

std::int64_t index_of(double x_m, double voxel_m) {
    const double cell = std::floor(x_m / voxel_m);
    const double limit = static_cast<double>(kHalf - 1);
    return static_cast<std::int64_t>(std::clamp(cell, -limit, limit));
}

std::uint64_t key_of(std::int64_t x, std::int64_t y, std::int64_t z) {
    const auto part = [](std::int64_t i) { return static_cast<std::uint64_t>(i + kHalf) & kMask; };
    return (part(x) << (2 * kBits)) | (part(y) << kBits) | part(z);
}

}  // namespace

std::uint64_t VoxelSet::key_of(const Eigen::Vector3d& p_m, double voxel_m) {
    return gripscan::key_of(index_of(p_m.x(), voxel_m), index_of(p_m.y(), voxel_m),
                            index_of(p_m.z(), voxel_m));
}

VoxelSet VoxelSet::of(double voxel_m, std::span<const Eigen::Vector3f> points, std::size_t fewest) {
    std::vector<std::uint64_t> all;
    all.reserve(points.size());
    for (const Eigen::Vector3f& p : points) all.push_back(key_of(p.cast<double>(), voxel_m));
    std::sort(all.begin(), all.end());
    std::vector<std::uint64_t> keys;
    for (std::size_t i = 0; i < all.size();) {
        std::size_t end = i;
        while (end < all.size() && all[end] == all[i]) ++end;
        if (end - i >= fewest) keys.push_back(all[i]);
        i = end;
    }
    return {voxel_m, std::move(keys)};
}

bool VoxelSet::near(const Eigen::Vector3d& p_m) const {
    if (keys_.empty()) return false;
    const std::int64_t x = index_of(p_m.x(), voxel_m_);
    const std::int64_t y = index_of(p_m.y(), voxel_m_);
    const std::int64_t z = index_of(p_m.z(), voxel_m_);
    for (std::int64_t dx = -1; dx <= 1; ++dx) {
        for (std::int64_t dy = -1; dy <= 1; ++dy) {
            // Three neighbours along z follow each other.
            const std::uint64_t first = gripscan::key_of(x + dx, y + dy, z - 1);
            const auto at = std::lower_bound(keys_.begin(), keys_.end(), first);
            if (at != keys_.end() && *at <= first + 2) return true;
        }
    }
    return false;
}

bool VoxelSet::contains(const Eigen::Vector3d& p_m) const {
    return std::binary_search(keys_.begin(), keys_.end(), key_of(p_m, voxel_m_));
}

std::vector<Eigen::Vector3f> VoxelSet::centres_m() const {
    std::vector<Eigen::Vector3f> centres;
    centres.reserve(keys_.size());
    const auto middle = [&](std::uint64_t part) {
        return static_cast<float>(
            (static_cast<double>(static_cast<std::int64_t>(part) - kHalf) + 0.5) * voxel_m_);
    };
    for (const std::uint64_t key : keys_) {
        centres.emplace_back(middle(key >> (2 * kBits)), middle((key >> kBits) & kMask),
                             middle(key & kMask));
    }
    return centres;
}

void VoxelSet::merge(const VoxelSet& other) {
    if (keys_.empty()) voxel_m_ = other.voxel_m_;
    std::vector<std::uint64_t> all;
    all.reserve(keys_.size() + other.keys_.size());
    std::set_union(keys_.begin(), keys_.end(), other.keys_.begin(), other.keys_.end(),
                   std::back_inserter(all));
    keys_ = std::move(all);
}

}  // namespace gripscan
