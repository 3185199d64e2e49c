#include "core/geometry/stereo_rig.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/units.h"

namespace gripscan {
namespace {

Status validate_camera(const Eigen::Matrix3d& K, const std::vector<double>& D, ImageSize image,
                       const char* which) {
    if (!K.allFinite()) return input_error("{} has numbers that are not finite", which);
    if (K(0, 0) <= 0.0 || K(1, 1) <= 0.0) {
        return input_error("{}: focal lengths {} and {} px must be positive", which, K(0, 0),
                           K(1, 1));
    }
    if (std::abs(K(0, 1)) > 1e-6 || std::abs(K(1, 0)) > 1e-9 ||
        (K.row(2) - Eigen::RowVector3d(0, 0, 1)).norm() > 1e-9) {
        return input_error("{}: a camera matrix is [fx 0 cx; 0 fy cy; 0 0 1]", which);
    }
    if (K(0, 2) < -0.5 * image.width || K(0, 2) > 1.5 * image.width ||
        K(1, 2) < -0.5 * image.height || K(1, 2) > 1.5 * image.height) {
        return input_error("{}: principal point ({}, {}) px lies far outside the {} x {} image",
                           which, K(0, 2), K(1, 2), image.width, image.height);
    }
    constexpr std::array<std::size_t, 6> kCounts{0, 4, 5, 8, 12, 14};
    if (std::find(kCounts.begin(), kCounts.end(), D.size()) == kCounts.end()) {
        return input_error("{}: {} distortion coefficients; OpenCV knows 4, 5, 8, 12 or 14", which,
                           D.size());
    }
    if (!std::all_of(D.begin(), D.end(), [](double x) { return std::isfinite(x); })) {
        return input_error("{}: a distortion coefficient is not finite", which);
    }
    return {};
}

}  // namespace

bool StereoRig::is_rectified() const {
    const auto none = [](const std::vector<double>& D) {
        return std::all_of(D.begin(), D.end(), [](double x) { return x == 0.0; });
    };
    const Eigen::Vector3d t = T_right_left.translation();
    return T_right_left.linear().isIdentity(1e-9) && none(D_left) && none(D_right) &&
           std::hypot(t.y(), t.z()) < 1e-9 && K_left(0, 0) == K_right(0, 0) &&
           K_left(1, 1) == K_right(1, 1) && K_left(0, 0) == K_left(1, 1) &&
           K_left(1, 2) == K_right(1, 2);
}

Status validate(const StereoRig& rig) {
    if (rig.image.width < 16 || rig.image.height < 16 || rig.image.width > 32768 ||
        rig.image.height > 32768) {
        return input_error("image_width x image_height = {} x {} px is no image size",
                           rig.image.width, rig.image.height);
    }
    if (Status s = validate_camera(rig.K_left, rig.D_left, rig.image, "left camera (K1, D1)"); !s)
        return s;
    if (Status s = validate_camera(rig.K_right, rig.D_right, rig.image, "right camera (K2, D2)"); !s)
        return s;
    const Eigen::Vector3d t = rig.T_right_left.translation();
    const Eigen::Matrix3d R = rig.T_right_left.linear();
    if (!t.allFinite() || !R.allFinite()) return input_error("R or T has numbers that are not finite");
    if ((R * R.transpose() - Eigen::Matrix3d::Identity()).norm() > 1e-4 || R.determinant() < 0.0) {
        return input_error("R is not a rotation");
    }
    const double turn_deg = deg_from_rad(rotation_angle_rad(R));
    if (turn_deg > 60.0) {
        return input_error("the cameras look {:.1f} deg apart; a stereo pair shares its view",
                           turn_deg);
    }
    if (t.norm() < 1e-4) {
        return input_error("the baseline is {} m; T must be the right camera's shift in metres",
                           t.norm());
    }
    if (t.norm() > 10.0) {
        return input_error("the baseline is {} m; T must be in metres (is it in millimetres?)",
                           t.norm());
    }
    if (t.x() >= 0.0) {
        return input_error("T_x = {} m: the right camera lies on the left (wrong sign); exchange "
                           "the cameras or invert R, T",
                           t.x());
    }
    if (-t.x() < 0.8 * t.norm()) {
        return input_error("the baseline ({}, {}, {}) m is not along x; turn the images by 90 deg",
                           t.x(), t.y(), t.z());
    }
    return {};
}

}  // namespace gripscan
