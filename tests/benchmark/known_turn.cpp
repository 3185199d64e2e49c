#include "tests/benchmark/known_turn.h"

#include <functional>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/base/units.h"
#include "core/session/session.h"
#include "core/stereo/rectifier.h"
#include "core/stereo/stereo_cloud.h"
#include "tests/tools/truth_files.h"

namespace gripscan::test {
namespace {

using TrueMotion = std::function<Pose(int index)>;

Result<TrueMotion> truth_of_axis(const std::filesystem::path& path) {
    const auto text = read_whole_file(path);
    if (!text) return forward_error(text.error());
    const auto json = nlohmann::json::parse(*text, nullptr, false);
    if (json.is_discarded() || !json.contains("axis_dir")) {
        return input_error("{} holds no axis of a turn", path.string());
    }
    Axis axis;
    for (int i = 0; i < 3; ++i) {
        axis.point_m[i] = json["axis_origin"][static_cast<std::size_t>(i)].get<double>();
        axis.direction[i] = json["axis_dir"][static_cast<std::size_t>(i)].get<double>();
    }
    axis.direction.normalize();
    const double step_rad = rad_from_deg(json["step_deg"].get<double>());
    return TrueMotion([=](int index) { return turn_about(axis, -index * step_rad); });
}

Result<TrueMotion> true_motion(const std::filesystem::path& path) {
    if (!std::filesystem::is_directory(path)) return truth_of_axis(path);
    const auto truth = load_truth(path);
    if (!truth) return forward_error(truth.error());
    return TrueMotion(
        [captures = truth->captures](int index) { return captures.at(index).T_first_k; });
}

Result<Cloud> cloud_of(const RecordedCapture& capture, const TurnRecording& recording,
                       const std::optional<Rectifier>& rectifier) {
    if (!capture.load_images) return capture.load_cloud();
    const auto frame = capture.load_images();
    if (!frame) return forward_error(frame.error());
    const auto rectified = rectifier->rectify(*frame);
    if (!rectified) return forward_error(rectified.error());
    auto made =
        stereo_cloud(*rectified, rectifier->rig(), recording.region, {}, {}, for_each_in_order);
    if (!made) return forward_error(made.error());
    return std::move(made->cloud);
}

}  // namespace

Result<KnownTurn> load_known_turn(const std::filesystem::path& session,
                                  const std::filesystem::path& truth) {
    const auto opened = open_session(session);
    if (!opened) return forward_error(opened.error());
    const auto motion = true_motion(truth);
    if (!motion) return forward_error(motion.error());
    const TurnRecording recording = recording_of(*opened);
    std::optional<Rectifier> rectifier;
    if (recording.rig) {
        auto created = Rectifier::create(*recording.rig);
        if (!created) return forward_error(created.error());
        rectifier.emplace(std::move(*created));
    }
    KnownTurn turn;
    for (const RecordedCapture& capture : recording.captures) {
        if (!capture.used) continue;
        auto cloud = cloud_of(capture, recording, rectifier);
        if (!cloud) return forward_error(cloud.error());
        turn.clouds.push_back(std::move(*cloud));
        turn.T_first_k.push_back((*motion)(capture.index));
    }
    return turn;
}

}  // namespace gripscan::test
