#include "core/procedure/compute_turn.h"

#include <algorithm>
#include <atomic>

#include "core/stereo/rectifier.h"

namespace gripscan {
namespace {

/// Images in memory at the same time: bounds the memory on machines with many cores.
constexpr std::size_t kCapturesAtOnce = 8;

struct CapturedCloud {
    Cloud cloud;
    std::optional<StereoHealth> health;
};

/// Everything that is the same for every capture.
struct CloudMaker {
    const TurnRecording& recording;
    const ComputeTurnSettings& settings;
    std::optional<Rectifier> rectifier;
    const Progress& progress;

    Result<CapturedCloud> operator()(const RecordedCapture& capture) const {
        return capture.load_images ? from_images(capture) : from_cloud(capture);
    }

    Result<CapturedCloud> from_images(const RecordedCapture& capture) const {
        auto frame = capture.load_images();
        if (!frame) return forward_error(frame.error());
        auto rectified = rectifier->rectify(*frame);
        if (!rectified) return about(capture, rectified.error());
        *frame = StereoFrame{};
        StereoSettings stereo = settings.stereo;
        stereo.crop_to_region = settings.crop;
        // The captures run side by side; within one, everything runs in order.
        auto result = stereo_cloud(*rectified, rectifier->rig(), recording.region, stereo,
                                   Progress{progress.stop, {}}, for_each_in_order);
        if (!result) return about(capture, result.error());
        return CapturedCloud{std::move(result->cloud), result->health};
    }

    Result<CapturedCloud> from_cloud(const RecordedCapture& capture) const {
        auto cloud = capture.load_cloud();
        if (!cloud) return forward_error(cloud.error());
        if (recording.region && settings.crop) *cloud = crop(*cloud, *recording.region);
        return CapturedCloud{std::move(*cloud), std::nullopt};
    }

    static tl::unexpected<Error> about(const RecordedCapture& capture, Error error) {
        if (error.kind != ErrorKind::kCancelled) {
            error.message = fmt::format("capture {}: {}", capture.index, error.message);
        }
        return forward_error(std::move(error));
    }
};

Result<CloudMaker> cloud_maker(const TurnRecording& recording, const ComputeTurnSettings& settings,
                               const Progress& progress) {
    CloudMaker maker{recording, settings, std::nullopt, progress};
    const bool has_images =
        std::any_of(recording.captures.begin(), recording.captures.end(),
                    [](const RecordedCapture& c) { return c.used && c.load_images; });
    if (!has_images) return maker;
    if (!recording.rig) return input_error("the captures are images, but there is no stereo rig");
    auto rectifier = Rectifier::create(*recording.rig);
    if (!rectifier) return forward_error(rectifier.error());
    maker.rectifier.emplace(std::move(*rectifier));
    return maker;
}

Result<std::vector<CapturedCloud>> make_clouds(const CloudMaker& make,
                                               const std::vector<std::size_t>& used,
                                               const Progress& progress, const ForEach& for_each) {
    std::vector<Result<CapturedCloud>> made(used.size(), cancelled_error());
    std::atomic<std::size_t> done{0};
    progress.tell("stereo", 0, used.size());
    for (std::size_t begin = 0; begin < used.size(); begin += kCapturesAtOnce) {
        for_each(std::min(kCapturesAtOnce, used.size() - begin), [&](std::size_t i) {
            if (progress.cancelled()) return;
            made[begin + i] = make(make.recording.captures[used[begin + i]]);
            progress.tell("stereo", ++done, used.size());
        });
        // In order, so that the same capture is named whatever the threads did.
        for (std::size_t i = begin; i < std::min(begin + kCapturesAtOnce, used.size()); ++i) {
            if (!made[i]) return forward_error(made[i].error());
        }
    }
    std::vector<CapturedCloud> clouds;
    for (auto& one : made) clouds.push_back(std::move(*one));
    // One view without points costs its steps; a recording without any is not the one meant.
    if (std::all_of(clouds.begin(), clouds.end(),
                    [](const CapturedCloud& c) { return c.cloud.empty(); })) {
        return input_error(
            "no capture has points in the registration area; check region, light and the camera's "
            "range");
    }
    return clouds;
}

TurnView view_of(const RecordedCapture& capture, Cloud cloud) {
    TurnView view;
    view.index = capture.index;
    view.cloud = std::move(cloud);
    view.commanded_rad = capture.commanded_rad;
    view.joint6_rad = capture.joint6_rad;
    view.joint6_after_rad = capture.joint6_after_rad;
    view.other_joints_rad = capture.other_joints_rad;
    view.attempts = capture.attempts;
    return view;
}

}  // namespace

Result<ComputedTurn> compute_turn(const TurnRecording& recording,
                                  const ComputeTurnSettings& settings, const Progress& progress,
                                  const ForEach& for_each) {
    std::vector<std::size_t> used;
    for (std::size_t i = 0; i < recording.captures.size(); ++i) {
        if (recording.captures[i].used) used.push_back(i);
    }
    if (used.size() < 2) {
        return input_error("a turn needs at least two used captures, there {} {}",
                           used.size() == 1 ? "is" : "are", used.size());
    }
    const auto maker = cloud_maker(recording, settings, progress);
    if (!maker) return forward_error(maker.error());
    auto clouds = make_clouds(*maker, used, progress, for_each);
    if (!clouds) return forward_error(clouds.error());

    ComputedTurn computed;
    computed.health.resize(recording.captures.size());
    std::vector<TurnView> views;
    for (std::size_t k = 0; k < used.size(); ++k) {
        views.push_back(view_of(recording.captures[used[k]], std::move((*clouds)[k].cloud)));
        computed.health[used[k]] = (*clouds)[k].health;
    }
    clouds->clear();
    auto report = solve_turn(views, settings.turn, progress, for_each);
    if (!report) return forward_error(report.error());

    std::vector<std::optional<Pose>> poses(recording.captures.size());
    for (std::size_t k = 0; k < used.size() && k < report->poses.size(); ++k) {
        poses[used[k]] = report->poses[k];
    }
    report->poses = std::move(poses);
    computed.report = std::move(*report);
    return computed;
}

}  // namespace gripscan
