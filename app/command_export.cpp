#include <map>
#include <memory>

#include "app/commands.h"
#include "app/console.h"
#include "app/results_of.h"
#include "core/cloud/cloud_file.h"
#include "core/geometry/axis_frame.h"
#include "core/report/report_json.h"
#include "core/report/table1_text.h"

namespace gripscan::app {
namespace {

struct ExportOptions {
    std::string session;
    std::string out;
    PcdEncoding encoding = PcdEncoding::kBinary;
    std::string unit = "m";
    std::string frame = "camera";
};

Result<ExitStatus> export_template(const ExportOptions& options, const Context& context) {
    const auto results = results_of(options.session, context);
    if (!results) return forward_error(results.error());
    if (context.stop.stop_requested()) return cancelled_error();
    Cloud cloud = results->report.merged;
    if (cloud.empty()) {
        return input_error("the template of {} has no points: no view could be merged",
                           options.session);
    }
    if (options.frame == "axis") {
        if (!results->report.axis) {
            return input_error("no axis is known for {}; export with --frame camera",
                               options.session);
        }
        cloud = transformed(cloud, T_axis_camera(results->report.axis->axis, centroid(cloud)));
    }
    CloudFileOptions file;
    file.encoding = options.encoding;
    file.metres_per_unit = options.unit == "mm" ? 0.001 : 1.0;
    std::error_code code;
    const bool replaced = std::filesystem::exists(options.out, code);
    if (Status saved = save_cloud(options.out, cloud, file); !saved) {
        return forward_error(saved.error());
    }
    const std::string path = absolute_path(options.out).string();
    if (context.options.json) {
        print_result(export_json(path, cloud.size(), options.unit, options.frame));
    } else if (!context.options.quiet) {
        print_result(fmt::format("template     {} ({} points, {}, {} frame){}\n", path,
                                 cloud.size(), options.unit, options.frame,
                                 replaced ? "; the file that was there is replaced" : ""));
    }
    const ExitStatus status = trust(results->report);
    if (status != kDone) say(context, "not all trusted: " + summary_sentence(results->report));
    return status;
}

}  // namespace

void add_export(const CommandLine& line) {
    static const std::map<std::string, PcdEncoding> kEncodings{
        {"ascii", PcdEncoding::kAscii},
        {"binary", PcdEncoding::kBinary},
        {"compressed", PcdEncoding::kCompressed}};
    auto options = std::make_shared<ExportOptions>();
    CLI::App* command = line.app.add_subcommand("export", "The template in other forms");
    command->add_option("session", options->session, "Session folder")
        ->required()
        ->option_text("SESSION");
    command->add_option("--out", options->out, "File to write, read back afterwards")
        ->required()
        ->option_text("FILE.pcd|.ply|.xyz");
    command->add_option("--encoding", options->encoding, "Of a PCD, and ascii of a PLY (binary)")
        ->transform(CLI::CheckedTransformer(kEncodings))
        ->option_text("ascii|binary|compressed");
    command->add_option("--unit", options->unit, "Unit of the coordinates (m)")
        ->check(CLI::IsMember({"m", "mm"}))
        ->option_text("m|mm");
    command
        ->add_option("--frame", options->frame,
                     "camera: as in the first capture; axis: z along the turn's axis, origin on it "
                     "nearest the template's centroid, x towards the camera's x, or its y where x "
                     "runs along the axis "
                     "(camera)")
        ->check(CLI::IsMember({"camera", "axis"}))
        ->option_text("camera|axis");
    add_common_options(*command, line.common);
    command->footer(
        "Takes the results of the session; computes them where there are none.\n"
        "Example:\n  gripscan export monday --out gripper.pcd --encoding compressed "
        "--unit mm --frame axis");
    command->callback([options, &action = line.action] {
        action = [options](const Context& context) { return export_template(*options, context); };
    });
}

}  // namespace gripscan::app
