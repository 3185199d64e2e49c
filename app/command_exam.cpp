#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

#include "app/commands.h"
#include "app/console.h"
#include "app/exam_views.h"
#include "app/number_checks.h"
#include "app/progress_bar.h"
#include "app/results_of.h"
#include "app/threads.h"
#include "core/base/units.h"
#include "core/recognition/exam.h"
#include "core/recognition/recognise.h"
#include "core/report/exam_json.h"

namespace gripscan::app {
namespace {

struct ExamOptions {
    std::string session;
    std::vector<int> captures;
    ExamDrive drive;
    bool drives = false;
    double limit_deg = 1.0;
    double limit_mm = 3.0;
};

/// Where the template would stand: turned about the axis by what the joint has turned since the
/// capture whose frame the template has.
Result<std::vector<ExamAnswer>> answers_of(const ResultsOf& results,
                                           const std::vector<ExamView>& views,
                                           const std::shared_ptr<const TemplateModel>& model,
                                           const Progress& progress, const ForEach& for_each) {
    const auto& rows = results.session.table.rows;
    const auto first = std::find_if(rows.begin(), rows.end(), [](const CaptureRow& row) {
        return row.status == CaptureStatus::kUsed;
    });
    const auto frame_rad = first == rows.end() ? std::nullopt : joint6_rad(*first);
    if (!frame_rad) return input_error("the first capture in use has no reading of joint 6");
    std::vector<ExamAnswer> answers;
    for (const ExamView& view : views) {
        ExamAnswer answer;
        answer.capture = view.capture;
        answer.joint_rad = view.joint6_rad - *frame_rad;
        answer.T_expected = turn_about(results.report.axis->axis, answer.joint_rad);
        const std::array models{model};
        const auto found = recognise(models, view.cloud, {}, progress, for_each);
        if (!found) return forward_error(found.error());
        if (!found->empty()) {
            answer.T_estimated = found->front().T_camera_template;
            answer.score = found->front().score;
        }
        answers.push_back(std::move(answer));
    }
    return answers;
}

std::string exam_text(const ExamResult& exam) {
    std::string text = fmt::format("{:>7} {:>9} {:>8} {:>8} {:>8} {:>8} {:>6}\n", "capture",
                                   "joint deg", "off deg", "ADD mm", "ADD-S mm", "MSSD mm", "");
    for (const ExamAnswer& a : exam.answers) {
        if (!a.measures) {
            text += fmt::format("{:>7} {:>9.2f} {:>44}\n", a.capture, deg_from_rad(a.joint_rad),
                                "not found    no");
            continue;
        }
        text += fmt::format("{:>7} {:>9.2f} {:>8.3f} {:>8.3f} {:>8.3f} {:>8.3f} {:>6}\n", a.capture,
                            deg_from_rad(a.joint_rad), deg_from_rad(a.measures->turn_rad),
                            kMmPerM * a.measures->add_m, kMmPerM * a.measures->add_s_m,
                            kMmPerM * a.measures->mssd_m, a.passed ? "yes" : "no");
    }
    return text + exam.sentence + "\n";
}

Result<ExitStatus> exam_command(const ExamOptions& options, const Context& context) {
    const auto results = results_of(options.session, context);
    if (!results) return forward_error(results.error());
    if (!results->report.axis) {
        return input_error("no axis is known for {}; the joint has nothing to be compared with",
                           options.session);
    }
    WorkerPool pool(thread_count(context));
    ProgressBar bar(context);
    const Progress progress = bar.progress();
    const auto model =
        make_template_model("template", results->report.merged, {}, progress, pool.for_each());
    if (!model) return forward_error(model.error());
    const auto views =
        options.drives
            ? driven_exam(results->session, options.drive, context, progress, pool.for_each())
            : recorded_exam(results->session, options.captures, progress, pool.for_each());
    if (!views) return forward_error(views.error());
    auto answers = answers_of(*results, *views, *model, progress, pool.for_each());
    if (!answers) return forward_error(answers.error());
    const ExamResult exam =
        judge_exam(**model, std::move(*answers),
                   {rad_from_deg(options.limit_deg), options.limit_mm / kMmPerM}, pool.for_each());
    if (context.options.json) {
        print_result(exam_json(exam));
    } else if (!context.options.quiet) {
        print_result(exam_text(exam));
    }
    return exam.passed ? kDone : kNotTrusted;
}

}  // namespace

void add_exam(const CommandLine& line) {
    auto options = std::make_shared<ExamOptions>();
    CLI::App* command = line.app.add_subcommand(
        "exam", "Recognise a template at held-out angles and compare with the joint");
    command->add_option("session", options->session, "Session whose template is examined")
        ->required()
        ->option_text("SESSION");
    command
        ->add_option("--captures", options->captures,
                     "Captures of the session to be examined by (those it excludes)")
        ->delimiter(',')
        ->option_text("I,J,...");
    command->add_flag("--drive", options->drives,
                      "Drive the cell to random angles instead, none of them the template's");
    command->add_option("--angles", options->drive.angles, "With --drive: so many (8)")
        ->check(CLI::Range(1, 360))
        ->option_text("N");
    command->add_option("--angle-seed", options->drive.seed, "With --drive: of the angles (1)")
        ->transform(unsigned_number())
        ->option_text("N");
    command->add_option("--limit-deg", options->limit_deg, "Largest error in rotation (1)")
        ->check(finite_number())
        ->option_text("DEG");
    command->add_option("--limit-mm", options->limit_mm, "Largest error of any point, MSSD (3)")
        ->check(finite_number())
        ->option_text("MM");
    add_cell_options(*command, options->drive.cell);
    add_common_options(*command, line.common);
    command->footer(
        "Example:\n  gripscan exam monday --drive --cell sim --seed 1\n"
        "\n"
        "Exit status: 0 yes, every angle was recognised within the limits; 1 no.");
    command->callback([options, &action = line.action] {
        action = [options](const Context& context) { return exam_command(*options, context); };
    });
}

}  // namespace gripscan::app
