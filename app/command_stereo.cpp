#include <memory>

#include "app/commands.h"
#include "app/console.h"
#include "app/progress_bar.h"
#include "app/threads.h"
#include "app/turn_work.h"
#include "core/camera/image_file.h"
#include "core/camera/pfm_file.h"
#include "core/cloud/cloud_file.h"
#include "core/report/stereo_json.h"
#include "core/stereo/rectifier.h"
#include "core/stereo/rig_file.h"
#include "core/stereo/stereo_cloud.h"

namespace gripscan::app {
namespace {

struct StereoOptions {
    std::string left;
    std::string right;
    std::string rig;
    std::string out;
    std::string disparity;
    StereoSettings settings;
};

Result<cv::Mat> load_for(const StereoRig& rig, const std::string& path) {
    auto image = load_grey_image(path);
    if (image && ImageSize{image->cols, image->rows} != rig.image) {
        return input_error("{} is {} x {} px, but the rig is for {} x {} px", path, image->cols,
                           image->rows, rig.image.width, rig.image.height);
    }
    return image;
}

Result<StereoCloud> make_cloud(const StereoOptions& options, const Context& context) {
    const auto rig = load_rig(options.rig);
    if (!rig) return forward_error(rig.error());
    auto left = load_for(*rig, options.left);
    if (!left) return forward_error(left.error());
    auto right = load_for(*rig, options.right);
    if (!right) return forward_error(right.error());
    const auto rectifier = Rectifier::create(*rig);
    if (!rectifier) return forward_error(rectifier.error());
    const auto rectified = rectifier->rectify({*left, *right, 0.0});
    if (!rectified) return forward_error(rectified.error());
    WorkerPool pool(thread_count(context));
    ProgressBar bar(context);
    return stereo_cloud(*rectified, rectifier->rig(), std::nullopt, options.settings,
                        bar.progress(), pool.for_each());
}

Result<ExitStatus> stereo(const StereoOptions& options, const Context& context) {
    const auto made = make_cloud(options, context);
    if (!made) return forward_error(made.error());
    if (context.stop.stop_requested()) return cancelled_error();
    if (Status s = save_cloud(options.out, made->cloud); !s) return forward_error(s.error());
    if (!options.disparity.empty()) {
        if (Status s = save_pfm(options.disparity, made->disparity); !s) {
            return forward_error(s.error());
        }
    }
    const std::string cloud = absolute_path(options.out).string();
    if (context.options.json) {
        const std::string disparity =
            options.disparity.empty() ? "" : absolute_path(options.disparity).string();
        print_result(stereo_json(*made, cloud, disparity));
    } else if (!context.options.quiet) {
        const StereoHealth& health = made->health;
        print_result(fmt::format(
            "cloud        {} ({} points)\nimages       fill {:.0f} %, brightness {:.0f}, saturated "
            "{:.1f} %, texture {:.1f} levels, row error {:.2f} px\n",
            cloud, made->cloud.size(), 100.0 * health.fill, health.mean_intensity,
            100.0 * health.saturated, health.texture, health.row_error_px));
    }
    if (made->cloud.empty()) {
        say(context,
            "no point was found: are left and right exchanged, is the rig another one, or the "
            "range "
            "of disparities too small?");
        return kNotTrusted;
    }
    return kDone;
}

}  // namespace

void add_stereo(const CommandLine& line) {
    auto options = std::make_shared<StereoOptions>();
    CLI::App* command = line.app.add_subcommand("stereo", "One stereo pair to a cloud");
    command->add_option("left", options->left, "Image of the left camera")
        ->required()
        ->option_text("LEFT");
    command->add_option("right", options->right, "Image of the right camera")
        ->required()
        ->option_text("RIGHT");
    command->add_option("--rig", options->rig, "Stereo rig")->required()->option_text("RIG.yaml");
    command->add_option("--out", options->out, "Cloud to write: .pcd, .ply or .xyz")
        ->required()
        ->option_text("CLOUD.pcd");
    command
        ->add_option("--disparity", options->disparity, "Disparities of the rectified left image")
        ->option_text("OUT.pfm");
    command
        ->add_option("--min-disparity", options->settings.min_disparity, "Smallest disparity, px")
        ->check(CLI::Range(-16384, 16384))
        ->option_text("N");
    command
        ->add_option("--num-disparities", options->settings.num_disparities,
                     "Number of disparities, px")
        ->check(CLI::Range(1, 16384))
        ->option_text("N");
    add_common_options(*command, line.common);
    command->footer("Example:\n  gripscan stereo l.png r.png --rig rig.yaml --out cloud.pcd");
    command->callback([options, &action = line.action] {
        action = [options](const Context& context) { return stereo(*options, context); };
    });
}

}  // namespace gripscan::app
