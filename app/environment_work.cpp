#include "app/environment_work.h"

#include <nlohmann/json.hpp>

#include "app/console.h"
#include "app/progress_bar.h"
#include "app/threads.h"
#include "app/turn_session.h"
#include "app/turn_work.h"
#include "core/base/atomic_file.h"
#include "core/base/units.h"
#include "core/scene/environment_file.h"
#include "core/session/journal_file.h"
#include "core/stereo/stereo_cloud.h"

namespace gripscan::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr const char* kModelFile = "environment.bin";
constexpr const char* kSummaryFile = "environment.json";

ordered_json vector_mm(const Eigen::Vector3d& v) {
    return {kMmPerM * v.x(), kMmPerM * v.y(), kMmPerM * v.z()};
}

ordered_json summary_of(const EnvironmentModel& model) {
    return {{"format", "gripscan-environment/1"},
            {"captures", model.captures},
            {"width_px", model.width},
            {"height_px", model.height},
            {"known", model.known()},
            {"noise_per_m", model.noise_per_m},
            {"noise_at_1m_mm", kMmPerM * model.noise_per_m},
            {"occupied_voxels", model.occupied.size()},
            {"arm_voxels", model.arm.size()},
            {"voxel_mm", kMmPerM * model.occupied.voxel_m()}};
}

/// Only a folder that holds nothing but a learned environment is replaced.
Status check_target(const fs::path& out) {
    std::error_code code;
    if (!fs::exists(out, code)) return {};
    if (!fs::is_directory(out, code)) {
        return input_error("cannot write to {}: it is a file", out.string());
    }
    for (const auto& entry : fs::directory_iterator(out, code)) {
        const std::string name = entry.path().filename().string();
        if (name == kModelFile || name == kSummaryFile) continue;
        return input_error(
            "cannot write to {}: it holds {}, and the folder is replaced as a whole; choose "
            "another",
            out.string(), name);
    }
    return {};
}

ordered_json json_of(const EnvironmentShift& shift) {
    if (!shift.known) return nullptr;
    return {{"moved", shift.moved},
            {"shift_mm", vector_mm(shift.shift_m)},
            {"length_mm", kMmPerM * shift.shift_m.norm()},
            {"turn_deg", deg_from_rad(shift.turn_rad)},
            {"sd_mm", kMmPerM * shift.sd_m},
            {"sd_deg", deg_from_rad(shift.sd_rad)},
            {"agreeing", shift.agreeing},
            {"sentence", sentence(shift)}};
}

ordered_json json_of(const SceneSurvey& survey) {
    ordered_json things = ordered_json::array();
    for (const LeftOver& thing : survey.left_overs) {
        things.push_back({{"points", thing.points.size()},
                          {"centre_mm", vector_mm(thing.centre_m)},
                          {"size_mm", vector_mm(thing.size_m)},
                          {"sentence", sentence(thing)}});
    }
    return {{"format", "gripscan-survey/1"},
            {"clear", survey.clear()},
            {"shift", json_of(survey.shift)},
            {"in_the_way", things},
            {"points", survey.points},
            {"environment", survey.environment},
            {"arm", survey.arm},
            {"known", survey.known}};
}

}  // namespace

Result<Cloud> whole_cloud(const StereoFrame& frame, const Rectifier& rectifier,
                          const Progress& progress, const ForEach& for_each) {
    const auto rectified = rectifier.rectify(frame);
    if (!rectified) return forward_error(rectified.error());
    auto made = stereo_cloud(*rectified, rectifier.rig(), std::nullopt, {}, progress, for_each);
    if (!made) return forward_error(made.error());
    return std::move(made->cloud);
}

Result<LearnSettings> learn_settings_of(const Session& session) {
    LearnSettings settings;
    settings.region = session.spec.region;
    const auto journal = read_journal(session.file("journal"));
    if (!journal) return forward_error(journal.error());
    for (const JournalEntry& entry : journal->entries) {
        if (entry.event != "environment") continue;
        for (const auto& [name, value] : entry.fields) {
            if (name == "arm_in_view") settings.arm_in_view = value == "yes";
        }
    }
    return settings;
}

Result<EnvironmentModel> learn_environment(const Session& session, const Progress& progress,
                                           const ForEach& for_each) {
    if (session.spec.kind != SessionKind::kEnvironment) {
        return input_error("{}: a session of kind {} is none of an environment",
                           session.file("session.yaml").string(), word(session.spec.kind));
    }
    if (!session.rig) {
        return input_error("{}: an environment is learned from images, and there is no rig.yaml",
                           session.folder.string());
    }
    const auto settings = learn_settings_of(session);
    if (!settings) return forward_error(settings.error());
    const auto rectifier = Rectifier::create(*session.rig);
    if (!rectifier) return forward_error(rectifier.error());
    EnvironmentLearner learner(*settings);
    const TurnRecording recording = recording_of(session);
    std::size_t done = 0;
    for (const RecordedCapture& capture : recording.captures) {
        progress.tell("captures", done++, recording.captures.size());
        if (!capture.used) continue;
        if (!capture.load_images) {
            return input_error(
                "{}: capture {} has no images, and an environment is learned from "
                "images",
                session.folder.string(), capture.index);
        }
        const auto frame = capture.load_images();
        if (!frame) return forward_error(frame.error());
        const auto cloud = whole_cloud(*frame, *rectifier, {progress.stop, {}}, for_each);
        if (!cloud) return forward_error(cloud.error());
        if (Status added = learner.add(*cloud); !added) return forward_error(added.error());
    }
    return learner.finish({progress.stop, {}}, for_each);
}

Result<SessionStore> begin_environment(const fs::path& folder, const CellOptions& options,
                                       const Cell& cell, bool arm_in_view) {
    SessionSpec spec;
    spec.kind = SessionKind::kEnvironment;
    spec.region = cell.region;
    const std::array opening{
        JournalRecord{"cell", journal_fields(options)},
        JournalRecord{"environment", {{"arm_in_view", arm_in_view ? "yes" : "no"}}}};
    auto store = SessionStore::create(folder, spec, cell.rig, GRIPSCAN_VERSION, opening);
    if (!store) return store;
    if (Status kept = keep_alignment(folder, cell); !kept) return forward_error(kept.error());
    return store;
}

Status record_environment(Cell& cell, SessionStore& store, int captures,
                          const std::function<Status(int capture, Cell& cell)>& before,
                          const Progress& progress) {
    std::vector<CaptureRecord> records;
    for (int i = 0; i < captures; ++i) {
        progress.tell("capture", static_cast<std::size_t>(i), static_cast<std::size_t>(captures));
        if (progress.stop.stop_requested()) return cancelled_error();
        if (Status moved = before(i, cell); !moved) return moved;
        const auto frame = cell.camera->grab({i, 1, 0});
        if (!frame) return forward_error(frame.error());
        if (Status stored = store.store_images(i, 1, *frame); !stored) return stored;
        CaptureRecord capture;
        capture.index = i;
        capture.t_s = frame->t_s;
        records.push_back(capture);
    }
    return store.save_table(records);
}

Status write_environment(const EnvironmentModel& model, const fs::path& out) {
    if (Status target = check_target(out); !target) return target;
    return replace_folder_atomically(out, [&](const fs::path& fresh) -> Status {
        if (Status s = save_environment(fresh / kModelFile, model); !s) return s;
        return write_file_atomically(fresh / kSummaryFile, summary_of(model).dump(1) + "\n");
    });
}

Result<ExitStatus> deliver_environment(const EnvironmentModel& model, const fs::path& out,
                                       const Context& context) {
    const Status written = write_environment(model, out);
    if (!written) return forward_error(written.error());
    ordered_json summary = summary_of(model);
    const std::string file = (absolute_path(out) / kModelFile).string();
    if (context.options.json) {
        summary["path"] = file;
        print_result(summary.dump(1) + "\n");
    } else if (!context.options.quiet) {
        print_result(fmt::format(
            "environment  {}\ncaptures     {}\nknown        {:.1f} % of the image\nnoise        "
            "{:.2f} mm at 1 m\n",
            file, model.captures, 100.0 * model.known(), kMmPerM * model.noise_per_m));
        if (!model.arm.empty()) {
            print_result(fmt::format("arm          {} cubes of {:.0f} mm where it was seen\n",
                                     model.arm.size(), kMmPerM * model.arm.voxel_m()));
        }
    }
    return kDone;
}

Result<ExitStatus> replay_environment(const Session& session, const fs::path& out,
                                      const Context& context) {
    if (Status target = check_target(out); !target) return forward_error(target.error());
    WorkerPool pool(thread_count(context));
    ProgressBar bar(context);
    if (Status ok = check_session_files(session, bar.progress(), pool.for_each()); !ok) {
        return forward_error(ok.error());
    }
    const auto model = learn_environment(session, bar.progress(), pool.for_each());
    if (!model) return forward_error(model.error());
    return deliver_environment(*model, out, context);
}

ExitStatus tell_survey(const SceneSurvey& survey, const Context& context) {
    if (context.options.json) {
        print_result(json_of(survey).dump(1) + "\n");
    } else if (!context.options.quiet) {
        print_result(sentence(survey.shift) + "\n");
        for (const LeftOver& thing : survey.left_overs) print_result(sentence(thing) + "\n");
        if (survey.clear()) print_result("nothing is in the way\n");
    }
    return survey.clear() ? kDone : kNotTrusted;
}

}  // namespace gripscan::app
