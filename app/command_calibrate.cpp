#include <glob.h>

#include <algorithm>
#include <memory>

#include "app/command_calibrate_robot.h"
#include "app/commands.h"
#include "app/console.h"
#include "app/number_checks.h"
#include "app/progress_bar.h"
#include "app/threads.h"
#include "app/turn_work.h"
#include "core/base/number_text.h"
#include "core/base/units.h"
#include "core/report/calibration_json.h"
#include "core/stereo/rig_file.h"

namespace gripscan::app {
namespace {
namespace fs = std::filesystem;

struct CalibrateOptions {
    std::string left;
    std::string right;
    std::string board;
    std::string charuco;
    double square_mm = 0.0;
    double marker_mm = 0.0;
    std::string dictionary;
    std::string out;
    bool force = false;
};

Result<std::vector<fs::path>> files_of(const std::string& pattern) {
    glob_t found{};
    const int status = ::glob(pattern.c_str(), 0, nullptr, &found);
    std::vector<fs::path> paths;
    for (std::size_t i = 0; i < found.gl_pathc; ++i) paths.emplace_back(found.gl_pathv[i]);
    ::globfree(&found);
    if (status == GLOB_NOMATCH || paths.empty()) {
        return input_error("no file matches '{}'; quote the pattern so that the shell leaves it",
                           pattern);
    }
    if (status != 0) return input_error("cannot list the files of '{}'", pattern);
    std::sort(paths.begin(), paths.end());
    return paths;
}

/// "9x6" as two numbers.
Result<std::pair<int, int>> size_of(const std::string& text, std::string_view option) {
    const auto x = text.find('x');
    const auto whole = [](std::string_view part) -> int {
        const auto number = number_from_text(part);
        return number && *number >= 1 && *number <= 1000 && *number == static_cast<int>(*number)
                   ? static_cast<int>(*number)
                   : 0;
    };
    const int cols = x == std::string::npos ? 0 : whole(std::string_view(text).substr(0, x));
    const int rows = x == std::string::npos ? 0 : whole(std::string_view(text).substr(x + 1));
    if (cols == 0 || rows == 0) {
        return input_error("{} '{}' is no size such as 9x6", option, text);
    }
    return std::pair{cols, rows};
}

Result<CalibrationBoard> board_of(const CalibrateOptions& options) {
    const bool charuco = !options.charuco.empty();
    if (charuco == !options.board.empty()) {
        return input_error("give one board: --board CxR or --charuco SXxSY");
    }
    const auto size =
        charuco ? size_of(options.charuco, "--charuco") : size_of(options.board, "--board");
    if (!size) return forward_error(size.error());
    if (!charuco) return Chessboard{size->first, size->second, options.square_mm / kMmPerM};
    if (options.marker_mm <= 0.0 || options.dictionary.empty()) {
        return input_error("a ChArUco board needs --marker-mm and --dict");
    }
    return CharucoBoard{size->first, size->second, options.square_mm / kMmPerM,
                        options.marker_mm / kMmPerM, options.dictionary};
}

Result<CalibrationResult> calibrate(const CalibrateOptions& options, const Context& context) {
    const auto board = board_of(options);
    if (!board) return forward_error(board.error());
    if (Status valid = validate(*board); !valid) return forward_error(valid.error());
    const auto lefts = files_of(options.left);
    if (!lefts) return forward_error(lefts.error());
    const auto rights = files_of(options.right);
    if (!rights) return forward_error(rights.error());
    WorkerPool pool(thread_count(context));
    ProgressBar bar(context);
    return calibrate_stereo(*lefts, *rights, *board, CalibrationSettings{}, bar.progress(),
                            pool.for_each());
}

std::string calibration_text(const CalibrationResult& result) {
    std::string text = "image pairs, reprojection left and right (px)\n";
    for (const auto& view : result.views) {
        text += fmt::format("  {:<32} {:>7.3f} {:>7.3f}  {}\n", view.left.filename().string(),
                            view.rms_left_px, view.rms_right_px,
                            view.used ? "used" : "not used: " + view.problem);
    }
    const StereoRig& rig = result.rig;
    text += fmt::format("f            left {:.2f} {:.2f}, right {:.2f} {:.2f} px\n",
                        rig.K_left(0, 0), rig.K_left(1, 1), rig.K_right(0, 0), rig.K_right(1, 1));
    text += fmt::format("baseline     {:.3f} mm\ndistortion   {}\n", rig.baseline_m() * kMmPerM,
                        result.distortion_model);
    text += fmt::format(
        "reprojection {:.3f} px rms\nrows         {:.3f} px rms, {:.3f} px at most "
        "after rectification\n",
        result.rms_px, result.row_rms_px, result.row_max_px);
    return text + fmt::format("board sides  mean error {:+.3f} mm, sd {:.3f} mm\n",
                              result.length_mean_error_m * kMmPerM, result.length_sd_m * kMmPerM);
}

Result<ExitStatus> calibrate_command(const CalibrateOptions& options, const Context& context) {
    const auto result = calibrate(options, context);
    if (!result) return forward_error(result.error());
    if (context.stop.stop_requested()) return cancelled_error();
    const bool write = !result->rejected || options.force;
    if (write) {
        if (Status saved = save_rig(options.out, result->rig); !saved) {
            return forward_error(saved.error());
        }
    }
    const std::string path = write ? absolute_path(options.out).string() : "";
    if (context.options.json) {
        print_result(calibration_json(*result, path));
    } else if (!context.options.quiet) {
        print_result(calibration_text(*result));
        if (write) print_result(fmt::format("rig          {}\n", path));
    }
    if (!result->rejected) return kDone;
    say(context, fmt::format("the rig is over its limit: {}; {}", result->reason,
                             write ? "written all the same, as asked by --force"
                                   : "not written (--force writes it all the same)"));
    return kNotTrusted;
}

}  // namespace

void add_calibrate(const CommandLine& line) {
    auto options = std::make_shared<CalibrateOptions>();
    CLI::App* calibrate = line.app.add_subcommand(
        "calibrate", "Calibrate the stereo camera, or align it to the robot");
    CLI::App* command = calibrate->add_subcommand("stereo", "A stereo rig from images of a board");
    command->add_option("--left", options->left, "Images of the left camera, sorted by name")
        ->required()
        ->option_text("'GLOB'");
    command->add_option("--right", options->right, "Images of the right camera, as many")
        ->required()
        ->option_text("'GLOB'");
    command->add_option("--board", options->board, "Chessboard by its inner corners")
        ->option_text("CxR");
    command->add_option("--charuco", options->charuco, "ChArUco board by its squares")
        ->option_text("SXxSY");
    command->add_option("--square-mm", options->square_mm, "Side of a square, mm")
        ->required()
        ->check(finite_number())
        ->check(CLI::PositiveNumber)
        ->option_text("S");
    command->add_option("--marker-mm", options->marker_mm, "Side of a ChArUco marker, mm")
        ->check(finite_number())
        ->check(CLI::PositiveNumber)
        ->option_text("M");
    command
        ->add_option("--dict", options->dictionary,
                     "Dictionary of the markers, such as DICT_5X5_100")
        ->option_text("NAME");
    command->add_option("--out", options->out, "Rig to write")->required()->option_text("RIG.yaml");
    command->add_flag("--force", options->force, "Write a rig that is over its limit");
    add_common_options(*command, line.common);
    command->footer(
        "Example:\n  gripscan calibrate stereo --left 'l*.png' --right 'r*.png' "
        "--board 9x6 --square-mm 25 --out rig.yaml");
    command->callback([options, &action = line.action] {
        action = [options](const Context& context) { return calibrate_command(*options, context); };
    });
    add_calibrate_robot(*calibrate, line);
    need_subcommand(*calibrate);
}

}  // namespace gripscan::app
