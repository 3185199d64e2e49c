#include "core/procedure/surface_pieces.h"

#include <algorithm>

#include "core/cloud/filters.h"
#include "core/cloud/kd_tree.h"

namespace gripscan {
namespace {

constexpr double kVoxel_m = 0.002;

/// Points that are reached from `start` in jumps below gap_m; they are marked.
std::vector<std::size_t> flood(const Cloud& cloud, const KdTree& tree, std::size_t start,
                               float gap_m, std::vector<char>& marked) {
    std::vector<std::size_t> piece{start};
    std::vector<Neighbour> near;
    marked[start] = 1;
    for (std::size_t next = 0; next < piece.size(); ++next) {
        tree.all_within(cloud.points[piece[next]], gap_m, near);
        for (const Neighbour& n : near) {
            if (marked[n.index] != 0) continue;
            marked[n.index] = 1;
            piece.push_back(n.index);
        }
    }
    return piece;
}

}  // namespace

std::vector<Piece> pieces_of(const Cloud& cloud, double gap_m, double least_m2) {
    if (cloud.empty()) return {};
    const Cloud thin = thinned(cloud, kVoxel_m);
    const KdTree tree(thin.points);
    std::vector<char> marked(thin.size(), 0);
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < thin.size(); ++i) {
        if (marked[i] != 0) continue;
        const auto members = flood(thin, tree, i, static_cast<float>(gap_m), marked);
        const double area_m2 = static_cast<double>(members.size()) * kVoxel_m * kVoxel_m;
        if (area_m2 >= least_m2) pieces.push_back({centroid(select(thin, members)), area_m2});
    }
    std::stable_sort(pieces.begin(), pieces.end(),
                     [](const Piece& a, const Piece& b) { return a.area_m2 > b.area_m2; });
    return pieces;
}

}  // namespace gripscan
