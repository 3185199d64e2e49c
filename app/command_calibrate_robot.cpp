#include "app/command_calibrate_robot.h"

#include <memory>
#include <nlohmann/json.hpp>

#include "app/console.h"
#include "app/progress_bar.h"
#include "app/threads.h"
#include "app/turn_work.h"
#include "core/alignment/robot_alignment.h"
#include "core/base/units.h"
#include "core/camera/image_file.h"
#include "core/session/alignment_file.h"
#include "core/session/robot_poses_file.h"
#include "core/stereo/rig_file.h"

namespace gripscan::app {
namespace {
using nlohmann::ordered_json;

struct RobotOptions {
    std::string poses;
    std::string out;
    bool force = false;
};

struct Views {
    std::vector<AlignmentView> used;
    std::vector<std::size_t> without_board;  ///< numbers of the file's rows
};

Result<BoardEye> eye_of(const RobotPosesFile& file) {
    if (file.rig.empty()) return BoardEye::create(file.camera, file.board);
    const auto rig = load_rig(file.rig);
    if (!rig) return forward_error(rig.error());
    return BoardEye::create(*rig, file.board);
}

Result<cv::Mat> image_of(const std::filesystem::path& path, const BoardEye& eye) {
    auto image = load_grey_image(path);
    const ImageSize size = eye.camera().image;
    if (image && eye.stereo() && ImageSize{image->cols, image->rows} != size) {
        return input_error("{} is {} x {} px, but the rig is for {} x {} px", path.string(),
                           image->cols, image->rows, size.width, size.height);
    }
    return image;
}

Result<Views> look_at(const RobotPosesFile& file, const BoardEye& eye, const Progress& progress,
                      const ForEach& for_each) {
    std::vector<Result<std::optional<BoardObservation>>> seen(file.rows.size());
    for_each(file.rows.size(), [&](std::size_t i) {
        if (progress.cancelled()) return;
        auto left = image_of(file.rows[i].left, eye);
        if (!left) {
            seen[i] = forward_error(left.error());
            return;
        }
        cv::Mat right;
        if (eye.stereo()) {
            auto second = image_of(file.rows[i].right, eye);
            if (!second) {
                seen[i] = forward_error(second.error());
                return;
            }
            right = *second;
        }
        seen[i] = eye.look(*left, right);
    });
    if (progress.cancelled()) return cancelled_error();
    Views views;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (!seen[i]) return forward_error(seen[i].error());
        if (*seen[i]) {
            views.used.push_back({file.rows[i].T_robot_flange, std::move(**seen[i])});
        } else {
            views.without_board.push_back(i);
        }
    }
    return views;
}

AlignmentFile file_of(const RobotAlignment& alignment, std::size_t views) {
    AlignmentFile file;
    const bool fixed = alignment.mounting == Mounting::kBoardOnFlange;
    (fixed ? file.T_robot_camera : file.T_flange_camera) = alignment.poses.X;
    (fixed ? file.T_flange_board : file.T_robot_board) = alignment.poses.Y;
    file.method = (alignment.refined ? "refined from " : "") + alignment.start;
    file.views = static_cast<int>(views);
    file.spread_mm = kMmPerM * alignment.spread.rms_m;
    file.spread_deg = deg_from_rad(alignment.spread.rms_rad);
    file.spread_max_mm = kMmPerM * alignment.spread.max_m;
    file.spread_max_deg = deg_from_rad(alignment.spread.max_rad);
    file.reprojection_px = alignment.reprojection_px;
    file.sd_mm = kMmPerM * alignment.sd_m;
    file.sd_deg = deg_from_rad(alignment.sd_rad);
    return file;
}

ordered_json json_of(const RobotAlignment& alignment, const AlignmentFile& file,
                     const std::string& path) {
    const auto pose = [](const std::optional<Pose>& T) -> ordered_json {
        if (!T) return nullptr;
        return row_major_from_pose(*T);
    };
    ordered_json candidates = ordered_json::array();
    for (const HandEyeCandidate& c : alignment.candidates) {
        candidates.push_back({{"method", c.method},
                              {"spread_mm", kMmPerM * c.spread.rms_m},
                              {"spread_deg", deg_from_rad(c.spread.rms_rad)}});
    }
    return {{"format", "gripscan-alignment/1"},
            {"path", path.empty() ? ordered_json(nullptr) : ordered_json(path)},
            {"T_robot_camera", pose(file.T_robot_camera)},
            {"T_flange_camera", pose(file.T_flange_camera)},
            {"T_flange_board", pose(file.T_flange_board)},
            {"T_robot_board", pose(file.T_robot_board)},
            {"method", file.method},
            {"views", file.views},
            {"spread_mm", file.spread_mm},
            {"spread_deg", file.spread_deg},
            {"spread_max_mm", file.spread_max_mm},
            {"spread_max_deg", file.spread_max_deg},
            {"reprojection_px", file.reprojection_px},
            {"board_px", alignment.board_px},
            {"sd_mm", file.sd_mm},
            {"sd_deg", file.sd_deg},
            {"rejected", alignment.rejected},
            {"reason", alignment.reason},
            {"candidates", candidates}};
}

std::string text_of(const RobotAlignment& alignment, const AlignmentFile& file) {
    std::string text = "method        spread of the board over the views\n";
    for (const HandEyeCandidate& c : alignment.candidates) {
        text += fmt::format("  {:<12}{:>9.2f} mm {:>8.3f} deg\n", c.method,
                            kMmPerM * c.spread.rms_m, deg_from_rad(c.spread.rms_rad));
    }
    text += fmt::format("  {:<12}{:>9.2f} mm {:>8.3f} deg, at most {:.2f} mm {:.3f} deg\n",
                        alignment.refined ? "refined" : "chosen", file.spread_mm, file.spread_deg,
                        file.spread_max_mm, file.spread_max_deg);
    const Pose& X = alignment.poses.X;
    const EulerAngles wpr = euler_from_rotation(X.linear());
    text += fmt::format(
        "camera        x {:.2f} y {:.2f} z {:.2f} mm, w {:.3f} p {:.3f} r {:.3f} deg in the {}\n",
        kMmPerM * X.translation().x(), kMmPerM * X.translation().y(), kMmPerM * X.translation().z(),
        deg_from_rad(wpr.roll_rad), deg_from_rad(wpr.pitch_rad), deg_from_rad(wpr.yaw_rad),
        alignment.mounting == Mounting::kBoardOnFlange ? "robot's frame" : "flange's frame");
    return text + fmt::format(
                      "known to      {:.2f} mm, {:.3f} deg (standard deviation)\n"
                      "reprojection  {:.3f} px rms, of the boards alone {:.3f} px\n",
                      file.sd_mm, file.sd_deg, alignment.reprojection_px, alignment.board_px);
}

Result<ExitStatus> calibrate_robot(const RobotOptions& options, const Context& context) {
    const auto file = load_robot_poses(options.poses);
    if (!file) return forward_error(file.error());
    const auto eye = eye_of(*file);
    if (!eye) return forward_error(eye.error());
    WorkerPool pool(thread_count(context));
    ProgressBar bar(context);
    const auto views = look_at(*file, *eye, bar.progress(), pool.for_each());
    if (!views) return forward_error(views.error());
    for (const std::size_t i : views->without_board) {
        say(context, fmt::format("{}: no board found, left out", file->rows[i].left.string()));
    }
    const auto alignment =
        align_robot(views->used, eye->camera(), file->mounting, AlignmentLimits{}, bar.progress());
    if (!alignment) {
        // What the views cannot tell is no mistake in the file.
        return input_error("{}: {}", options.poses, alignment.error().message);
    }
    if (context.stop.stop_requested()) return cancelled_error();
    const AlignmentFile result = file_of(*alignment, views->used.size());
    const bool write = !alignment->rejected || options.force;
    if (write) {
        if (Status s = save_alignment(options.out, result); !s) return forward_error(s.error());
    }
    const std::string path = write ? absolute_path(options.out).string() : "";
    if (context.options.json) {
        print_result(json_of(*alignment, result, path).dump(1) + "\n");
    } else if (!context.options.quiet) {
        print_result(text_of(*alignment, result));
        if (write) print_result(fmt::format("alignment     {}\n", path));
    }
    if (!alignment->rejected) return kDone;
    say(context, fmt::format("the alignment is over its limit: {}; {}", alignment->reason,
                             write ? "written all the same, as asked by --force"
                                   : "not written (--force writes it all the same)"));
    return kNotTrusted;
}

}  // namespace

void add_calibrate_robot(CLI::App& calibrate, const CommandLine& line) {
    auto options = std::make_shared<RobotOptions>();
    CLI::App* command = calibrate.add_subcommand(
        "robot", "Where the camera stands, from images of a board at known robot poses");
    command
        ->add_option("--poses", options->poses, "Images with robot poses (docs/robot-alignment.md)")
        ->required()
        ->option_text("FILE");
    command->add_option("--out", options->out, "Alignment to write")
        ->required()
        ->option_text("FILE");
    command->add_flag("--force", options->force, "Write an alignment that is over its limit");
    add_common_options(*command, line.common);
    command->footer("Example:\n  gripscan calibrate robot --poses poses.yaml --out alignment.yaml");
    command->callback([options, &action = line.action] {
        action = [options](const Context& context) { return calibrate_robot(*options, context); };
    });
}

}  // namespace gripscan::app
