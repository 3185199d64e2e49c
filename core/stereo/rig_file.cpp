#include "core/stereo/rig_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/core.hpp>

#include "core/base/atomic_file.h"

namespace gripscan {
namespace fs = std::filesystem;
namespace {

/// A rig file has a few hundred bytes; whatever is larger is something else.
constexpr std::size_t kMaxBytes = std::size_t{1} << 20;

/// One line of what OpenCV says about a text that it cannot parse.
std::string one_line(const cv::Exception& e) {
    std::string text = e.err;
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

class RigReader {
  public:
    RigReader(const fs::path& path, const cv::FileStorage& file)
        : path_(path.string()), file_(file) {}

    Result<int> whole_number(const char* key) const {
        const cv::FileNode node = file_[key];
        if (node.empty()) return missing(key);
        if (!node.isInt() && !node.isReal()) {
            return input_error("{}: key {} must be a whole number", path_, key);
        }
        const double value = static_cast<double>(node);
        if (!(std::abs(value) < 1e9) || value != std::floor(value)) {
            return input_error("{}: key {} = {} must be a whole number", path_, key, value);
        }
        return static_cast<int>(value);
    }

    /// A matrix of finite numbers. rows = 0: any vector.
    Result<cv::Mat1d> matrix(const char* key, int rows, int cols) const {
        const cv::FileNode node = file_[key];
        if (node.empty()) return missing(key);
        cv::Mat raw;
        try {
            node >> raw;
        } catch (const cv::Exception& e) {
            return input_error("{}: key {} is no matrix: {}", path_, key, one_line(e));
        }
        if (raw.dims > 2 || raw.channels() != 1 || (raw.empty() && rows > 0)) {
            return input_error("{}: key {} must be a matrix of numbers (!!opencv-matrix)", path_,
                               key);
        }
        cv::Mat1d numbers;
        raw.convertTo(numbers, CV_64F);
        if (rows > 0 && (numbers.rows != rows || numbers.cols != cols) &&
            (cols > 1 || numbers.rows != cols || numbers.cols != rows)) {
            return input_error("{}: key {} is {} x {}, it must be {} x {}", path_, key,
                               numbers.rows, numbers.cols, rows, cols);
        }
        if (rows == 0 && numbers.rows > 1 && numbers.cols > 1) {
            return input_error("{}: key {} is {} x {}, it must be a vector", path_, key,
                               numbers.rows, numbers.cols);
        }
        if (numbers.empty()) return numbers;  // OpenCV's iterators divide by the width
        if (!std::all_of(numbers.begin(), numbers.end(),
                         [](double x) { return std::isfinite(x); })) {
            return input_error("{}: key {} holds a number that is not finite", path_, key);
        }
        return numbers;
    }

    Result<Eigen::Matrix3d> matrix3(const char* key) const {
        return matrix(key, 3, 3).map([](const cv::Mat1d& m) {
            Eigen::Matrix3d result;
            for (int i = 0; i < 9; ++i) result(i / 3, i % 3) = m(i / 3, i % 3);
            return result;
        });
    }

  private:
    tl::unexpected<Error> missing(const char* key) const {
        return input_error(
            "{}: key {} is missing; a rig has image_width, image_height, K1, D1, "
            "K2, D2, R, T (is the file cut short?)",
            path_, key);
    }

    std::string path_;
    const cv::FileStorage& file_;
};

Result<StereoRig> read_rig(const RigReader& reader) {
    StereoRig rig;
    const auto width = reader.whole_number("image_width");
    if (!width) return forward_error(width.error());
    const auto height = reader.whole_number("image_height");
    if (!height) return forward_error(height.error());
    rig.image = {*width, *height};
    Eigen::Matrix3d R;
    const std::array<std::pair<const char*, Eigen::Matrix3d*>, 3> matrices{
        {{"K1", &rig.K_left}, {"K2", &rig.K_right}, {"R", &R}}};
    for (const auto& [key, target] : matrices) {
        const auto m = reader.matrix3(key);
        if (!m) return forward_error(m.error());
        *target = *m;
    }
    const std::array<std::pair<const char*, std::vector<double>*>, 2> distortions{
        {{"D1", &rig.D_left}, {"D2", &rig.D_right}}};
    for (const auto& [key, target] : distortions) {
        const auto v = reader.matrix(key, 0, 0);
        if (!v) return forward_error(v.error());
        if (!v->empty()) target->assign(v->begin(), v->end());
    }
    const auto t = reader.matrix("T", 3, 1);
    if (!t) return forward_error(t.error());
    rig.T_right_left.linear() = R;
    rig.T_right_left.translation() = Eigen::Vector3d((*t)(0), (*t)(1), (*t)(2));
    return rig;
}

cv::Mat1d cv_matrix(const Eigen::Matrix3d& m) {
    cv::Mat1d result(3, 3);
    for (int i = 0; i < 9; ++i) result(i / 3, i % 3) = m(i / 3, i % 3);
    return result;
}

cv::Mat1d cv_column(const std::vector<double>& v) {
    return cv::Mat1d(v, true);
}

}  // namespace

Result<StereoRig> load_rig(const fs::path& path) {
    const Result<std::string> text = read_whole_file(path);
    if (!text) return forward_error(text.error());
    if (text->empty() || text->size() > kMaxBytes) {
        return input_error("{}: {} bytes are no rig file", path.string(), text->size());
    }
    try {
        const cv::FileStorage file(*text, cv::FileStorage::READ | cv::FileStorage::MEMORY);
        if (!file.isOpened()) return input_error("{}: not a YAML file of OpenCV", path.string());
        Result<StereoRig> rig = read_rig(RigReader(path, file));
        if (!rig) return rig;
        if (const Status status = validate(*rig); !status) {
            return input_error("{}: {}", path.string(), status.error().message);
        }
        return rig;
    } catch (const cv::Exception& e) {
        return input_error("{}: not a YAML file of OpenCV (%YAML:1.0 header, !!opencv-matrix): {}",
                           path.string(), one_line(e));
    }
}

Status save_rig(const fs::path& path, const StereoRig& rig) {
    if (const Status status = validate(rig); !status) return status;
    cv::FileStorage file(
        ".yaml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY | cv::FileStorage::FORMAT_YAML);
    const Eigen::Vector3d t = rig.T_right_left.translation();
    file << "image_width" << rig.image.width << "image_height" << rig.image.height;
    file << "K1" << cv_matrix(rig.K_left) << "D1" << cv_column(rig.D_left);
    file << "K2" << cv_matrix(rig.K_right) << "D2" << cv_column(rig.D_right);
    file << "R" << cv_matrix(rig.T_right_left.linear());
    file << "T" << cv_column({t.x(), t.y(), t.z()});
    return write_file_atomically(path, file.releaseAndGetString());
}

}  // namespace gripscan
