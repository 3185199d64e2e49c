#include "core/registration/joint_system.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace gripscan {
namespace {

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
    Eigen::Matrix3d M;
    M << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return M;
}

}  // namespace

Vector6d motion_of(const Pose& T, const Eigen::Vector3d& centre) {
    Vector6d m;
    m.head<3>() = rotation_vector(T.linear());
    m.tail<3>() = T * centre - centre;
    return m;
}

Matrix6d adjoint_about(const Pose& T, const Eigen::Vector3d& centre) {
    const Eigen::Matrix3d R = T.linear();
    Matrix6d Ad = Matrix6d::Zero();
    Ad.topLeftCorner<3, 3>() = R;
    Ad.bottomRightCorner<3, 3>() = R;
    Ad.bottomLeftCorner<3, 3>() = -cross_matrix(centre - T * centre) * R;
    return Ad;
}

JointSystem::JointSystem(std::size_t views, const Axis& axis, const Eigen::Vector3d& centre)
    : axis_(axis), centre_(centre), globals_(6 * (static_cast<int>(views) - 1)) {
    across_.col(0) = axis.direction.unitOrthogonal();
    across_.col(1) = axis.direction.cross(across_.col(0));
    const int n = globals_ + kGlobals;
    H_ = Eigen::MatrixXd::Zero(n, n);
    g_ = Eigen::VectorXd::Zero(n);
    x_ = Eigen::VectorXd::Zero(n);
}

Vector6d JointSystem::unit_turn() const {
    Vector6d turn;
    turn.head<3>() = axis_.direction;
    turn.tail<3>() = axis_.direction.cross(centre_ - axis_.point_m);
    return turn;
}

void JointSystem::add_pair(std::size_t from, std::size_t to, const Pose& T_to_from,
                           double angle_rad, double scan_scale, const NormalEquations& sums,
                           double weight) {
    // The relative pose moves by δ = u_to − Ad · u_from; a scan scale off 1 asks for more turn.
    const Matrix6d H = weight * sums.H;
    const Vector6d stretch = angle_rad * unit_turn();
    const Vector6d g = weight * sums.g - (scan_scale - 1.0) * (H * stretch);
    Eigen::Matrix<double, 6, 13> J;
    J << Matrix6d::Identity(), -adjoint_about(T_to_from, centre_), -stretch;
    const Eigen::Matrix<double, 13, 13> JHJ = J.transpose() * H * J;
    const Eigen::Matrix<double, 13, 1> Jg = J.transpose() * g;
    struct Part {
        int column;
        int at;
        int size;
    };
    std::vector<Part> parts{{globals_ + kScanScale, 12, 1}};
    if (to > 0) parts.push_back({column(to), 0, 6});
    if (from > 0) parts.push_back({column(from), 6, 6});
    for (const Part& a : parts) {
        g_.segment(a.column, a.size) += Jg.segment(a.at, a.size);
        for (const Part& b : parts) {
            H_.block(a.column, b.column, a.size, b.size) += JHJ.block(a.at, b.at, a.size, b.size);
        }
    }
}

void JointSystem::add_prior(std::size_t view, const Pose& T_view_first, double scale,
                            double offset_rad, const Prior& prior) {
    const Pose turn = turn_about(axis_, scale * prior.angle_rad + offset_rad);
    const Vector6d e = motion_of(T_view_first * turn.inverse(), centre_);
    const Eigen::Vector3d a = axis_.direction;
    const Eigen::Matrix3d along = a * a.transpose();
    Matrix6d W = Matrix6d::Zero();
    W.topLeftCorner<3, 3>() =
        along / std::pow(prior.sigma_angle_rad, 2) +
        (Eigen::Matrix3d::Identity() - along) / std::pow(prior.sigma_off_axis_rad, 2);
    W.bottomRightCorner<3, 3>() = Eigen::Matrix3d::Identity() / std::pow(prior.sigma_shift_m, 2);

    // e answers to the view's own motion and, the other way round, to what moves the model turn:
    // a tilted or shifted axis conjugates it, scale and offset turn it further about the axis.
    Eigen::Matrix<double, 6, kGlobals> B = Eigen::Matrix<double, 6, kGlobals>::Zero();
    const Matrix6d difference = Matrix6d::Identity() - adjoint_about(turn, centre_);
    B.leftCols<2>() = difference.leftCols<3>() * across_;
    B.middleCols<2>(2) = difference.rightCols<3>() * across_;
    B.col(kRobotScale) = prior.angle_rad * unit_turn();
    B.col(kRobotOffset) = unit_turn();
    B = -B;

    const auto add_globals = [&] {
        H_.block<kGlobals, kGlobals>(globals_, globals_) += B.transpose() * W * B;
        g_.segment<kGlobals>(globals_) += B.transpose() * W * e;
    };
    add_globals();
    if (view == 0) return;
    const int c = column(view);
    H_.block<6, 6>(c, c) += W;
    g_.segment<6>(c) += W * e;
    const Eigen::Matrix<double, 6, kGlobals> WB = W * B;
    H_.block<6, kGlobals>(c, globals_) += WB;
    H_.block<kGlobals, 6>(globals_, c) += WB.transpose();
}

void JointSystem::add_global_prior(Global index, double wanted_correction, double sigma) {
    const int i = globals_ + index;
    H_(i, i) += 1.0 / (sigma * sigma);
    g_(i) -= wanted_correction / (sigma * sigma);
}

bool JointSystem::solve() {
    const Eigen::LDLT<Eigen::MatrixXd> ldlt(H_);
    if (ldlt.info() != Eigen::Success) return false;
    x_ = -ldlt.solve(g_);
    return x_.allFinite();
}

Pose JointSystem::correction(std::size_t view) const {
    if (view == 0) return Pose::Identity();
    return motion_about(x_.segment<6>(column(view)), centre_);
}

Eigen::Matrix<double, JointSystem::kGlobals, 1> JointSystem::global_corrections() const {
    return x_.segment<kGlobals>(globals_);
}

Eigen::Matrix<double, JointSystem::kGlobals, 1> JointSystem::global_sigmas() const {
    const Eigen::LDLT<Eigen::MatrixXd> ldlt(H_);
    Eigen::Matrix<double, kGlobals, 1> sigmas;
    for (int i = 0; i < kGlobals; ++i) {
        const Eigen::VectorXd unit = Eigen::VectorXd::Unit(H_.rows(), globals_ + i);
        sigmas(i) = std::sqrt(std::max(0.0, ldlt.solve(unit)(globals_ + i)));
    }
    return sigmas;
}

Axis JointSystem::corrected_axis() const {
    const auto q = global_corrections();
    Axis axis = axis_;
    Vector6d motion;
    motion.head<3>() = across_ * q.head<2>();
    motion.tail<3>() = across_ * q.segment<2>(2);
    const Pose T = motion_about(motion, centre_);
    axis.direction = (T.linear() * axis_.direction).normalized();
    axis.point_m = T * axis_.point_m;
    axis.point_m = axis.nearest_to(centre_);
    return axis;
}

}  // namespace gripscan
