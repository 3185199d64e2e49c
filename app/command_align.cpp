#include <cmath>
#include <memory>

#include "app/commands.h"
#include "app/console.h"
#include "app/number_checks.h"
#include "app/progress_bar.h"
#include "app/threads.h"
#include "app/turn_options.h"
#include "core/base/units.h"
#include "core/cloud/cloud_file.h"
#include "core/registration/turn_check.h"
#include "core/report/alignment_json.h"

namespace gripscan::app {
namespace {

struct AlignOptions {
    std::string source;
    std::string target;
    std::optional<double> rotation_deg;
    std::uint64_t seed = 1;
    TurnMethod method = TurnMethod::kTurn;
    PaperIcpOptions icp;
};

Result<Alignment> align_clouds(const AlignOptions& options, const Context& context) {
    const auto source = load_cloud(options.source);
    if (!source) return forward_error(source.error());
    const auto target = load_cloud(options.target);
    if (!target) return forward_error(target.error());
    if (options.method == TurnMethod::kPaperIcp) {
        return align_paper_icp(*source, *target, options.icp.settings());
    }
    AlignSettings settings;
    settings.all_rotations = true;
    settings.seed = options.seed;
    WorkerPool pool(thread_count(context));
    ProgressBar bar(context);
    return align(*source, *target, settings, bar.progress(), pool.for_each());
}

/// The verdict against a turn that is known, by the rules of a step. What already speaks against
/// the alignment itself stays.
void judge_rotation(double rotation_rad, Alignment& alignment) {
    if (!alignment.found || alignment.verdict == Verdict::kReject) return;
    TurnStep step;
    step.icp_rad = alignment.angle_rad;
    step.error_rad = alignment.angle_rad - std::abs(rotation_rad);
    step.sigma_rad = alignment.sigma_angle_rad;
    step.overlap = alignment.overlap;
    StepEvidence evidence;
    evidence.found = true;
    evidence.starts_agree = alignment.starts_agree;
    evidence.paper_icp = true;  // observability was judged with the alignment
    judge_step(step, evidence, TurnLimits{});
    const bool worse = step.verdict == Verdict::kReject ||
                       (step.verdict == Verdict::kCheck && alignment.verdict != Verdict::kCheck);
    if (!worse && alignment.verdict != Verdict::kAccept) return;
    alignment.verdict = step.verdict;
    alignment.cause = step.cause;
    alignment.sentence = step.sentence;
}

std::string alignment_text(const Alignment& a) {
    if (!a.found) return fmt::format("{} ({}): {}\n", word(a.verdict), word(a.cause), a.sentence);
    const EulerAngles angles = euler_from_rotation(a.T_target_source.linear());
    const Eigen::Vector3d& t = a.T_target_source.translation();
    std::string text =
        fmt::format("angle        {:.4f} deg, sigma {:.4f} deg, about ({:.4f}, {:.4f}, {:.4f})\n",
                    deg_from_rad(a.angle_rad), deg_from_rad(a.sigma_angle_rad), a.axis.x(),
                    a.axis.y(), a.axis.z());
    text += fmt::format("roll pitch yaw  {:.3f} {:.3f} {:.3f} deg, X Y Z  {:.4f} {:.4f} {:.4f} m\n",
                        deg_from_rad(angles.roll_rad), deg_from_rad(angles.pitch_rad),
                        deg_from_rad(angles.yaw_rad), t.x(), t.y(), t.z());
    text += fmt::format("overlap      {:.0f} %, rms {:.3f} mm, observability {:.2f}, starts {}\n",
                        100.0 * a.overlap, a.rms_m * kMmPerM, a.observability,
                        a.starts_agree ? "agree" : "disagree");
    return text +
           fmt::format("verdict      {} ({}): {}\n", word(a.verdict), word(a.cause), a.sentence);
}

Result<ExitStatus> align_command(const AlignOptions& options, const Context& context) {
    auto alignment = align_clouds(options, context);
    if (!alignment) return forward_error(alignment.error());
    std::optional<double> rotation_rad;
    if (options.rotation_deg) {
        rotation_rad = rad_from_deg(*options.rotation_deg);
        judge_rotation(*rotation_rad, *alignment);
    }
    if (context.options.json) {
        print_result(alignment_json(*alignment, rotation_rad));
    } else if (!context.options.quiet) {
        print_result(alignment_text(*alignment));
    }
    return alignment->verdict == Verdict::kAccept ? kDone : kNotTrusted;
}

}  // namespace

void add_align(const CommandLine& line) {
    auto options = std::make_shared<AlignOptions>();
    CLI::App* command = line.app.add_subcommand("align", "Register two clouds");
    command->add_option("source", options->source, "Cloud that is moved")
        ->required()
        ->option_text("SOURCE");
    command->add_option("target", options->target, "Cloud that stays")
        ->required()
        ->option_text("TARGET");
    command
        ->add_option("--rotation-deg", options->rotation_deg,
                     "What the rotation angle should be; only compared with, never used")
        ->check(finite_number())
        ->check(CLI::Range(-180.0, 180.0))
        ->option_text("A");
    command->add_option("--seed", options->seed, "Of the perturbed starts (1)")
        ->transform(unsigned_number())
        ->option_text("N");
    add_method_options(*command, options->method, options->icp);
    add_common_options(*command, line.common);
    command->footer("Example:\n  gripscan align scan0.pcd scan1.pcd --rotation-deg 10 --json");
    command->callback([options, &action = line.action] {
        action = [options](const Context& context) { return align_command(*options, context); };
    });
}

}  // namespace gripscan::app
