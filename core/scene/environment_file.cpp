#include "core/scene/environment_file.h"

#include <bit>
#include <cmath>

#include "core/base/atomic_file.h"
#include "core/base/checksum.h"

namespace gripscan {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kMagic = "gripscan-environment/1\n";
constexpr std::string_view kAnyVersion = "gripscan-environment/";
constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 26;

class Writer {
  public:
    void number(std::uint64_t value, int bytes) {
        for (int i = 0; i < bytes; ++i) {
            bytes_.push_back(static_cast<char>(static_cast<unsigned char>(value >> (8 * i))));
        }
    }
    void real(double value) { number(std::bit_cast<std::uint64_t>(value), 8); }
    void raw(std::string_view bytes) { bytes_ += bytes; }
    /// Seven bits a byte, low ones first.
    void varint(std::uint64_t value) {
        while (value >= 0x80) {
            number((value & 0x7f) | 0x80, 1);
            value >>= 7;
        }
        number(value, 1);
    }
    [[nodiscard]] std::string& bytes() { return bytes_; }

  private:
    std::string bytes_;
};

/// Gives zeros once it has run short; ask is_whole() at the end.
class Reader {
  public:
    explicit Reader(std::string_view bytes) : left_(bytes) {}
    std::uint64_t number(std::size_t bytes) {
        if (bytes > left_.size()) {
            short_ = true;
            left_ = {};
            return 0;
        }
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < bytes; ++i) {
            value |= std::uint64_t{static_cast<unsigned char>(left_[i])} << (8 * i);
        }
        left_.remove_prefix(bytes);
        return value;
    }
    double real() { return std::bit_cast<double>(number(8)); }
    std::uint64_t varint() {
        std::uint64_t value = 0;
        for (int shift = 0; shift < 64; shift += 7) {
            const std::uint64_t part = number(1);
            value |= (part & 0x7f) << shift;
            if ((part & 0x80) == 0) break;
        }
        return value;
    }
    [[nodiscard]] std::size_t left() const { return left_.size(); }
    [[nodiscard]] bool is_whole() const { return left_.empty() && !short_; }

  private:
    std::string_view left_;
    bool short_ = false;
};

void write_voxels(Writer& to, const VoxelSet& voxels) {
    to.real(voxels.voxel_m());
    to.number(voxels.size(), 8);
    std::uint64_t last = 0;
    for (const std::uint64_t key : voxels.keys()) {
        to.varint(key - last);
        last = key;
    }
}

VoxelSet read_voxels(Reader& from) {
    const double voxel_m = from.real();
    const std::uint64_t count = from.number(8);
    std::vector<std::uint64_t> keys;
    std::uint64_t key = 0;
    for (std::uint64_t i = 0; i < count && from.left() > 0; ++i) {
        key += from.varint();
        keys.push_back(key);
    }
    return {voxel_m, std::move(keys)};
}

void write_pixels(Writer& to, const EnvironmentModel& model) {
    for (const EnvironmentPixel& pixel : model.pixels) {
        to.number(pixel.views, 1);
        if (pixel.views == 0) continue;
        to.number(pixel.mean, 2);
        to.number(pixel.far, 2);
        to.number(pixel.near, 2);
        to.number(pixel.sigma, 1);
        to.number(pixel.grey, 1);
    }
}

void read_pixels(Reader& from, EnvironmentModel& model) {
    for (EnvironmentPixel& pixel : model.pixels) {
        pixel.views = static_cast<std::uint8_t>(from.number(1));
        if (pixel.views == 0) continue;
        pixel.mean = static_cast<std::uint16_t>(from.number(2));
        pixel.far = static_cast<std::uint16_t>(from.number(2));
        pixel.near = static_cast<std::uint16_t>(from.number(2));
        pixel.sigma = static_cast<std::uint8_t>(from.number(1));
        pixel.grey = static_cast<std::uint8_t>(from.number(1));
    }
}

bool makes_sense(const EnvironmentModel& m) {
    return std::isfinite(m.zero_per_m) && m.quantum_per_m > 0.0 && m.noise_per_m > 0.0 &&
           std::isfinite(m.camera.fu_px) && m.camera.fu_px > 0.0 && m.camera.fv_px > 0.0 &&
           std::isfinite(m.camera.cu_px) && std::isfinite(m.camera.cv_px) && m.captures > 0;
}

Result<EnvironmentModel> read_model(const fs::path& path, std::string_view body) {
    Reader from(body);
    EnvironmentModel model;
    model.width = static_cast<int>(from.number(4));
    model.height = static_cast<int>(from.number(4));
    model.captures = static_cast<int>(from.number(4));
    for (double* value :
         {&model.camera.fu_px, &model.camera.cu_px, &model.camera.fv_px, &model.camera.cv_px,
          &model.zero_per_m, &model.quantum_per_m, &model.noise_per_m}) {
        *value = from.real();
    }
    const auto pixels = static_cast<std::uint64_t>(std::max(0, model.width)) *
                        static_cast<std::uint64_t>(std::max(0, model.height));
    if (pixels == 0 || pixels > kMostPixels || pixels > from.left() || !makes_sense(model)) {
        return input_error("{}: the numbers in it make no environment; learn it again",
                           path.string());
    }
    model.pixels.resize(pixels);
    read_pixels(from, model);
    model.occupied = read_voxels(from);
    model.arm = read_voxels(from);
    if (from.is_whole()) return model;
    return input_error("{}: the file is cut short or too long; learn the environment again",
                       path.string());
}

fs::path file_of(const fs::path& path) {
    std::error_code code;
    return fs::is_directory(path, code) ? path / "results" / "environment.bin" : path;
}

}  // namespace

Status save_environment(const fs::path& path, const EnvironmentModel& model) {
    Writer to;
    to.raw(kMagic);
    to.number(static_cast<std::uint64_t>(model.width), 4);
    to.number(static_cast<std::uint64_t>(model.height), 4);
    to.number(static_cast<std::uint64_t>(model.captures), 4);
    for (const double value :
         {model.camera.fu_px, model.camera.cu_px, model.camera.fv_px, model.camera.cv_px,
          model.zero_per_m, model.quantum_per_m, model.noise_per_m}) {
        to.real(value);
    }
    write_pixels(to, model);
    write_voxels(to, model.occupied);
    write_voxels(to, model.arm);
    to.number(fnv1a64(to.bytes()), 8);
    return write_file_atomically(path, to.bytes());
}

Result<EnvironmentModel> load_environment(const fs::path& path) {
    const fs::path file = file_of(path);
    const auto bytes = read_whole_file(file);
    if (!bytes) return forward_error(bytes.error());
    if (!bytes->starts_with(kMagic)) {
        const bool other = bytes->starts_with(kAnyVersion);
        return input_error("{}: {}", file.string(),
                           other ? "an environment of another version of gripscan; learn it again"
                                 : "no environment (gripscan run environment makes one)");
    }
    constexpr std::size_t kSum = 8;
    if (bytes->size() < kMagic.size() + kSum) {
        return input_error("{}: the file is cut short; learn the environment again", file.string());
    }
    const std::string_view all(*bytes);
    const std::string_view summed = all.substr(0, all.size() - kSum);
    if (Reader(all.substr(all.size() - kSum)).number(kSum) != fnv1a64(summed)) {
        return input_error("{}: the file is damaged (checksum); learn the environment again",
                           file.string());
    }
    return read_model(file, summed.substr(kMagic.size()));
}

}  // namespace gripscan
