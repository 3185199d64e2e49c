#include "core/recognition/pose_voting.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gripscan {
namespace {

constexpr int kAngleBins = 32;
/// Features that very many pairs share tell little; their votes are worth less, and only so many
/// are cast.
constexpr std::size_t kMostVotes = 600;
/// A second peak below this share of the first is noise.
constexpr float kLeastPeak = 0.7F;

/// Votes for (point of the template, angle about its normal).
class Ballot {
  public:
    explicit Ballot(std::size_t points) : votes_(points * kAngleBins) {}

    void clear() { std::fill(votes_.begin(), votes_.end(), 0.0F); }
    void add(std::uint16_t reference, std::uint16_t angle, float weight) {
        // Between two bins, so that no angle is worth less than others.
        const int fine = angle;
        constexpr int kWide = PairTable::kTurn / kAngleBins;
        const int bin = fine / kWide;
        const float rest = static_cast<float>(fine % kWide) / static_cast<float>(kWide);
        float* row = &votes_[static_cast<std::size_t>(reference) * kAngleBins];
        row[bin] += weight * (1.0F - rest);
        row[(bin + 1) % kAngleBins] += weight * rest;
    }
    struct Peak {
        std::size_t reference = 0;
        float angle_rad = 0.0F;
        float votes = 0.0F;
    };
    [[nodiscard]] std::vector<Peak> peaks(int count) const;

  private:
    std::vector<float> votes_;
};

std::vector<Ballot::Peak> Ballot::peaks(int count) const {
    std::vector<Peak> all;
    const std::size_t points = votes_.size() / kAngleBins;
    for (std::size_t r = 0; r < points; ++r) {
        const float* row = &votes_[r * kAngleBins];
        const auto best = static_cast<int>(std::max_element(row, row + kAngleBins) - row);
        if (row[best] <= 0.0F) continue;
        const float before = row[(best + kAngleBins - 1) % kAngleBins];
        const float after = row[(best + 1) % kAngleBins];
        const float sum = before + row[best] + after;
        const float bin = static_cast<float>(best) + (after - before) / sum;
        all.push_back({r, bin * 2.0F * std::numbers::pi_v<float> / kAngleBins, sum});
    }
    const auto n = std::min<std::size_t>(all.size(), static_cast<std::size_t>(count));
    std::partial_sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(n), all.end(),
                      [](const Peak& a, const Peak& b) {
                          return a.votes != b.votes ? a.votes > b.votes : a.reference < b.reference;
                      });
    all.resize(n);
    return all;
}

void cast_votes(const TemplateModel& model, const CoarseScene& scene, std::size_t r,
                const std::vector<Neighbour>& partners, std::size_t stride, Ballot& ballot) {
    const auto& points = scene.points.points;
    const auto& normals = scene.points.normals;
    const Eigen::Isometry3f T = onto_x(points[r], normals[r]);
    for (std::size_t k = 0; k < partners.size(); k += stride) {
        const std::size_t i = partners[k].index;
        if (i == r) continue;
        const auto found = model.pairs->find(points[r], normals[r], points[i], normals[i]);
        if (found.empty()) continue;
        const Eigen::Vector3f q = T * points[i];
        const float turn = std::atan2(-q.z(), q.y()) / (2.0F * std::numbers::pi_v<float>);
        const int scene_angle = static_cast<int>(std::floor(turn * PairTable::kTurn));
        const std::size_t skip = (found.size() + kMostVotes - 1) / kMostVotes;
        const float weight = static_cast<float>(skip) /
                             std::sqrt(1.0F + static_cast<float>(found.size()) /
                                                  static_cast<float>(model.coarse.size()));
        for (std::size_t j = 0; j < found.size(); j += skip) {
            const int angle =
                (static_cast<int>(found[j].angle) - scene_angle) & (PairTable::kTurn - 1);
            ballot.add(found[j].reference, static_cast<std::uint16_t>(angle), weight);
        }
    }
}

}  // namespace

std::vector<VotedPose> vote_for_poses(const TemplateModel& model, const CoarseScene& scene,
                                      const VotingSettings& settings, const ForEach& for_each) {
    const std::size_t n = scene.points.size();
    const std::size_t references = std::min(n, settings.references);
    constexpr std::size_t kBlock = 32;
    std::vector<std::vector<VotedPose>> found(references);
    for_each((references + kBlock - 1) / kBlock, [&](std::size_t block) {
        Ballot ballot(model.coarse.size());
        std::vector<Neighbour> partners;
        for (std::size_t k = block * kBlock; k < std::min(references, (block + 1) * kBlock); ++k) {
            const std::size_t r = k * n / references;
            scene.tree.all_within(scene.points.points[r], model.pairs->longest_m(), partners);
            const std::size_t stride =
                (partners.size() + settings.partners - 1) / settings.partners;
            ballot.clear();
            cast_votes(model, scene, r, partners, std::max<std::size_t>(1, stride), ballot);
            const Eigen::Isometry3f T_x_scene =
                onto_x(scene.points.points[r], scene.points.normals[r]);
            const auto peaks = ballot.peaks(settings.peaks);
            for (const auto& peak : peaks) {
                if (peak.votes < kLeastPeak * peaks.front().votes) break;
                const Eigen::Isometry3f T_x_template = onto_x(model.coarse.points[peak.reference],
                                                              model.coarse.normals[peak.reference]);
                const Eigen::Isometry3f turn(
                    Eigen::AngleAxisf(peak.angle_rad, Eigen::Vector3f::UnitX()));
                found[k].push_back(
                    {T_x_scene.inverse() * turn * T_x_template,
                     peak.votes * static_cast<float>(std::max<std::size_t>(1, stride))});
            }
        }
    });
    std::vector<VotedPose> all;
    for (const auto& some : found) all.insert(all.end(), some.begin(), some.end());
    return all;
}

}  // namespace gripscan
