#include "core/registration/residual_row.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace gripscan {
std::vector<ResidualRow> rows_of(const std::vector<Match>& matches, const Eigen::Vector3d& centre) {
    std::vector<ResidualRow> rows;
    rows.reserve(matches.size());
    for (const Match& m : matches) {
        if (m.weight <= 0.0F) continue;
        const double sigma = m.sigma_m;
        rows.push_back({jacobian(m, centre), m.residual_m, m.weight / (sigma * sigma), m.middle});
    }
    return rows;
}

double correlation_factor(const std::vector<ResidualRow>& rows, double patch_m) {
    std::map<std::array<int, 3>, double> patches;
    double squares = 0.0;
    for (const ResidualRow& row : rows) {
        const double z = std::sqrt(row.information) * row.residual;
        const Eigen::Array3d k = (row.where.cast<double>().array() / patch_m).floor();
        patches[{static_cast<int>(k.x()), static_cast<int>(k.y()), static_cast<int>(k.z())}] += z;
        squares += z * z;
    }
    double sums = 0.0;
    for (const auto& [cube, z] : patches) sums += z * z;
    return squares > 0.0 ? std::max(1.0, sums / squares) : 1.0;
}

void add_rows(const std::vector<ResidualRow>& rows, double correlation, NormalEquations& sums) {
    for (const ResidualRow& row : rows) {
        if (row.information <= 0.0) continue;
        const double w = row.information / correlation;
        sums.H.selfadjointView<Eigen::Lower>().rankUpdate(row.J, w);
        sums.g += (w * row.residual) * row.J;
        sums.weight += 1.0;
    }
    sums.H = Matrix6d(sums.H.selfadjointView<Eigen::Lower>());
}

}  // namespace gripscan
