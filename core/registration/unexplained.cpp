#include "core/registration/unexplained.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "core/registration/region_walls.h"
#include "core/registration/visibility.h"

namespace gripscan {
namespace {

/// Points that are looked at, spread over the surface.
constexpr std::size_t kPoints = 8000;
/// Partners lie within this share of the part's radius, or so many point spacings.
constexpr double kPartnerShare = 0.03;
constexpr double kPartnerSpacings = 3.0;
constexpr float kPartnerNormal = 0.3F;
/// Cosine of the viewing angle from which on a point counts, and from which on stereo is sure to
/// see it in the other view.
constexpr float kFacing = 0.5F;
constexpr float kWellFacing = 0.65F;
/// Points darker than this share of the view's median say nothing: turned a little further from
/// the light they have no texture left.
constexpr float kDark = 0.6F;
/// Next to what the other view saw (in radii of the part) a direction without data says nothing:
/// stereo leaves a margin at silhouettes. Nor does it near the walls of the region.
constexpr double kMargin = 0.1;
/// Edge of the cubes that are joined into pieces, in radii of the part; at least so many spacings
/// of the sample, so that a surface fills neighbouring cubes.
constexpr double kCube = 0.05;
constexpr double kCubeSpacings = 2.5;
/// A cube belongs to a piece if at least this share of its points is unexplained: holes that
/// stereo leaves here and there have explained points around them.
constexpr double kMostOfCube = 0.6;
constexpr int kFewestInCube = 2;

/// A point that is found unmoved stands only if the turn would have taken it so many reaches away.
constexpr float kPlainlyMoved = 4.0F;
/// Directions in which the surroundings are looked at.
constexpr std::array<std::pair<float, float>, 8> kAround{{{1.0F, 0.0F},
                                                          {-1.0F, 0.0F},
                                                          {0.0F, 1.0F},
                                                          {0.0F, -1.0F},
                                                          {0.7F, 0.7F},
                                                          {-0.7F, 0.7F},
                                                          {0.7F, -0.7F},
                                                          {-0.7F, -0.7F}}};

using Cube = std::array<int, 3>;

struct Looked {
    std::uint32_t index = 0;
    bool explained = true;
};

struct CubeContent {
    std::vector<std::uint32_t> unexplained;
    int points = 0;
    int piece = -1;

    [[nodiscard]] bool stands_out() const {
        const auto n = static_cast<int>(unexplained.size());
        return n >= kFewestInCube && n >= kMostOfCube * points;
    }
};
using Cubes = std::map<Cube, CubeContent>;

float median_of(std::span<const float> values) {
    if (values.empty()) return 0.0F;
    std::vector<float> sorted(values.begin(), values.end());
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    return *middle;
}

class Looker {
  public:
    Looker(const Surface& shown, const Surface& other, const Pose& T, const SeenWhere& where)
        : shown_(shown),
          other_(other),
          map_(other),
          R_(T.linear().cast<float>()),
          t_(T.translation().cast<float>()),
          where_(where),
          reach_m_(static_cast<float>(
              std::max(kPartnerShare * std::max(shown.radius_m, other.radius_m),
                       kPartnerSpacings * std::max(shown.spacing_m, other.spacing_m)))),
          margin_m_(static_cast<float>(kMargin * std::max(shown.radius_m, other.radius_m))),
          darkest_(kDark * median_of(where.brightness)) {
        if (where.holder != nullptr && where.holder->viewpoint) holder_.emplace(*where.holder);
        if (where.region) walls_.emplace(*where.region, other.points, margin_m_);
    }

    /// Nothing if the point says nothing: at a rim, in the dark, or seen at a grazing angle.
    [[nodiscard]] std::optional<Looked> look(std::uint32_t i) const {
        if (shown_.rim[i] != 0) return std::nullopt;
        if (!where_.brightness.empty() && where_.brightness[i] < darkest_) return std::nullopt;
        const Eigen::Vector3f ray = (shown_.points[i] - *shown_.viewpoint).normalized();
        if (-shown_.normals[i].dot(ray) < kFacing) return std::nullopt;
        const Eigen::Vector3f p = R_ * shown_.points[i] + t_;
        const Eigen::Vector3f n = R_ * shown_.normals[i];
        if (walls_ && walls_->leaves(p)) return Looked{i, false};
        if (-n.dot((p - *other_.viewpoint).normalized()) < kWellFacing) return Looked{i, true};
        if (partner_at(p, n)) return Looked{i, true};
        return Looked{i, !ought_to_be_seen(p) && !stands_instead(i, p)};
    }

    /// Does the other view have the point where it is, unmoved?
    [[nodiscard]] bool stands(std::uint32_t i) const {
        return partner_at(shown_.points[i], shown_.normals[i]);
    }

  private:
    [[nodiscard]] bool partner_at(const Eigen::Vector3f& p, const Eigen::Vector3f& n) const {
        const auto found = other_.tree.nearest_within(p, reach_m_);
        return found && other_.normals[found->index].dot(n) > kPartnerNormal;
    }

    [[nodiscard]] bool ought_to_be_seen(const Eigen::Vector3f& p) const {
        if (hidden_by_holder(p)) return false;
        const Sight sight = map_.look(p, reach_m_);
        if (sight != Sight::kNothing) return sight == Sight::kInFront;
        return walls_ && walls_->deep_inside(p) && where_.field &&
               where_.field->sees(p.cast<double>()) && !beside_data(p);
    }

    /// Where nothing is known of the place it would have turned to: is it still where it was?
    [[nodiscard]] bool stands_instead(std::uint32_t i, const Eigen::Vector3f& p) const {
        return (p - shown_.points[i]).norm() > kPlainlyMoved * reach_m_ && stands(i);
    }

    [[nodiscard]] bool beside_data(const Eigen::Vector3f& p) const { return beside(map_, p); }

    /// Behind the gripper, next to its silhouette, or where it touches the part.
    [[nodiscard]] bool hidden_by_holder(const Eigen::Vector3f& p) const {
        if (!holder_) return false;
        const Sight sight = holder_->look(p, reach_m_);
        return sight == Sight::kHidden || sight == Sight::kSeen || beside(*holder_, p);
    }

    [[nodiscard]] bool beside(const DepthMap& map, const Eigen::Vector3f& p) const {
        const Eigen::Vector3f ray = (p - *other_.viewpoint).normalized();
        const Eigen::Vector3f right = ray.unitOrthogonal();
        const Eigen::Vector3f down = ray.cross(right);
        for (const auto& [u, v] : kAround) {
            const Sight sight = map.look(p + margin_m_ * (u * right + v * down), reach_m_);
            if (sight != Sight::kNothing && sight != Sight::kInFront) return true;
        }
        return false;
    }

    const Surface& shown_;
    const Surface& other_;
    DepthMap map_;
    std::optional<DepthMap> holder_;
    Eigen::Matrix3f R_;
    Eigen::Vector3f t_;
    const SeenWhere& where_;
    float reach_m_;
    float margin_m_;
    float darkest_ = 0.0F;
    std::optional<RegionWalls> walls_;
};

Cubes sort_into_cubes(const Surface& shown, const Looker& looker,
                      const std::vector<std::uint32_t>& sample, double edge_m) {
    Cubes cubes;
    for (const std::uint32_t i : sample) {
        const auto looked = looker.look(i);
        if (!looked) continue;
        const Eigen::Array3d k = (shown.points[i].cast<double>().array() / edge_m).floor();
        CubeContent& cube =
            cubes[{static_cast<int>(k.x()), static_cast<int>(k.y()), static_cast<int>(k.z())}];
        ++cube.points;
        if (!looked->explained) cube.unexplained.push_back(i);
    }
    return cubes;
}

/// Points of the piece that `seed` belongs to; its cubes are marked.
std::vector<std::uint32_t> collect(Cubes& cubes, const Cube& seed, int piece) {
    std::vector<std::uint32_t> points;
    std::vector<Cube> open{seed};
    cubes.at(seed).piece = piece;
    while (!open.empty()) {
        const Cube at = open.back();
        open.pop_back();
        const auto& own = cubes.at(at).unexplained;
        points.insert(points.end(), own.begin(), own.end());
        for (int n = 0; n < 27; ++n) {
            const Cube next{at[0] + n % 3 - 1, at[1] + n / 3 % 3 - 1, at[2] + n / 9 - 1};
            const auto found = cubes.find(next);
            if (found == cubes.end() || found->second.piece >= 0) continue;
            if (!found->second.stands_out()) continue;
            found->second.piece = piece;
            open.push_back(next);
        }
    }
    std::sort(points.begin(), points.end());
    return points;
}

/// Surface that a point of the sample stands for.
double area_of(const Surface& shown, std::uint32_t i, double points_each) {
    const Eigen::Vector3f ray = (shown.points[i] - *shown.viewpoint).normalized();
    const double facing = std::max(0.3F, -shown.normals[i].dot(ray));
    return points_each * shown.spacing_m * shown.spacing_m / facing;
}

Unexplained describe(const Surface& shown, const Looker& looker,
                     const std::vector<std::uint32_t>& piece, double points_each) {
    Unexplained result;
    result.points =
        static_cast<std::size_t>(std::lround(points_each * static_cast<double>(piece.size())));
    Eigen::Array3d low = Eigen::Array3d::Constant(1e9);
    Eigen::Array3d high = -low;
    double stand = 0.0;
    for (const std::uint32_t i : piece) {
        const Eigen::Vector3d p = shown.points[i].cast<double>();
        result.centre_m += p / static_cast<double>(piece.size());
        low = low.min(p.array());
        high = high.max(p.array());
        result.area_m2 += area_of(shown, i, points_each);
        stand += looker.stands(i) ? 1.0 : 0.0;
    }
    result.size_m = (high - low).maxCoeff();
    result.standing = stand / static_cast<double>(piece.size());
    return result;
}

}  // namespace

std::optional<Unexplained> unexplained_part(const Surface& shown, const Surface& other,
                                            const Pose& T_other_shown, const SeenWhere& where) {
    if (!shown.viewpoint || !other.viewpoint) return std::nullopt;
    const Looker looker(shown, other, T_other_shown, where);
    const auto sample = spread_sample(shown, kPoints);
    const double points_each =
        static_cast<double>(shown.size()) / static_cast<double>(sample.size());
    const double edge_m =
        std::max(kCube * shown.radius_m, kCubeSpacings * shown.spacing_m * std::sqrt(points_each));
    Cubes cubes = sort_into_cubes(shown, looker, sample, edge_m);
    std::optional<Unexplained> largest;
    double all_m2 = 0.0;
    int pieces = 0;
    for (auto& [at, cube] : cubes) {
        if (cube.piece >= 0 || !cube.stands_out()) continue;
        const Unexplained piece =
            describe(shown, looker, collect(cubes, at, pieces++), points_each);
        all_m2 += piece.area_m2;
        if (!largest || piece.area_m2 > largest->area_m2) largest = piece;
    }
    if (largest) largest->other_area_m2 = all_m2 - largest->area_m2;
    return largest;
}

}  // namespace gripscan
