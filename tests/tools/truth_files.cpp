#include "tests/tools/truth_files.h"

#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/atomic_file.h"
#include "core/cloud/cloud_file.h"

namespace gripscan::test {
namespace {

template <typename T>
T take(const char*& bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    bytes += sizeof value;
    return value;
}

/// Binary PLY with vertices of three floats and triangles, as the simulated cell writes it.
Result<Surface> load_surface(const std::filesystem::path& path) {
    const auto bytes = read_whole_file(path);
    if (!bytes) return forward_error(bytes.error());
    const std::string end_mark = "end_header\n";
    const auto end = bytes->find(end_mark);
    if (end == std::string::npos) return input_error("{}: no PLY header", path.string());
    std::istringstream header(bytes->substr(0, end));
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    for (std::string word; header >> word;) {
        if (word == "vertex") header >> vertices;
        if (word == "face") header >> triangles;
    }
    constexpr std::size_t kVertexBytes = 12;
    constexpr std::size_t kTriangleBytes = 13;
    if (bytes->size() !=
        end + end_mark.size() + vertices * kVertexBytes + triangles * kTriangleBytes) {
        return input_error("{}: {} vertices and {} triangles do not fit its size", path.string(),
                           vertices, triangles);
    }
    Surface surface;
    const char* at = bytes->data() + end + end_mark.size();
    for (std::size_t i = 0; i < vertices; ++i) {
        Eigen::Vector3d& v = surface.vertices.emplace_back();
        for (int k = 0; k < 3; ++k) v[k] = take<float>(at);
    }
    for (std::size_t i = 0; i < triangles; ++i) {
        ++at;  // the number of corners
        auto& t = surface.triangles.emplace_back();
        for (auto& index : t) index = take<std::uint32_t>(at);
    }
    return surface;
}

void read_json(const nlohmann::json& json, Truth& truth) {
    const auto vector = [](const nlohmann::json& v) {
        return Eigen::Vector3d(v.at(0).get<double>(), v.at(1).get<double>(), v.at(2).get<double>());
    };
    truth.axis.point_m = vector(json.at("axis").at("point_m"));
    truth.axis.direction = vector(json.at("axis").at("direction"));
    for (const auto& capture : json.at("captures")) {
        TrueCapture& entry = truth.captures[capture.at("index").get<int>()];
        entry.T_first_k =
            pose_from_row_major(capture.at("T_first_k").get<std::array<double, 16>>()).value();
        entry.joint6_deg = capture.at("joints_deg").at(5).get<double>();
    }
}

Result<Truth> load(const std::filesystem::path& folder, const std::string& prefix) {
    const auto text = read_whole_file(folder / "truth.json");
    if (!text) return forward_error(text.error());
    Truth truth;
    try {
        read_json(nlohmann::json::parse(*text), truth);
    } catch (const std::exception& e) {
        return input_error("{}: {}", (folder / "truth.json").string(), e.what());
    }
    auto surface = load_surface(folder / (prefix + "surface.ply"));
    if (!surface) return forward_error(surface.error());
    truth.surface = std::move(*surface);
    auto visible = load_cloud(folder / (prefix + "visible.ply"));
    if (!visible) return forward_error(visible.error());
    truth.visible = std::move(*visible);
    return truth;
}

}  // namespace

Result<Truth> load_truth(const std::filesystem::path& folder) {
    return load(folder, "");
}

Result<Truth> load_object_truth(const std::filesystem::path& folder) {
    auto truth = load(folder, "object_");
    if (!truth) return truth;
    auto whole = load_surface(folder / "surface.ply");
    if (!whole) return forward_error(whole.error());
    truth->whole = std::move(*whole);
    return truth;
}

}  // namespace gripscan::test
