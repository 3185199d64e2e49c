#include "ui/views/actions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "core/base/units.h"
#include "core/procedure/step.h"
#include "ui/views/table_text.h"

namespace gripscan::ui {
namespace {

using Why = std::optional<std::string>;
constexpr double kZoom = 1.1;

Why not_commanded(const Snapshot& s, const Command& command) {
    if (!s.session || s.procedure == nullptr) return "no session is open";
    if (s.session->recorded) return "a recording is shown: nothing is moved or captured";
    return refusal(*s.procedure, command);
}

template <typename C>
Request give(const Snapshot&) {
    return request::Give{C{}};
}
template <typename C>
Why refuse(const Snapshot& s) {
    return not_commanded(s, C{});
}
Request ask_for_note(const Snapshot&) {
    return request::Show{Dialog::kNote};
}
/// Never for what the procedure is doing: a hand that wants to stop finds no grey button.
Why refuse_stop(const Snapshot& s) {
    return s.session && s.session->recorded ? not_commanded(s, command::Stop{})
           : s.session                      ? std::nullopt
                                            : Why("no session is open");
}
/// The note is asked for afterwards.
Why refuse_accept(const Snapshot& s) {
    return not_commanded(s, command::Accept{"note"});
}

template <Page kPage>
Request go_to(const Snapshot&) {
    return request::GoTo{kPage};
}
template <Dialog kDialog>
Request show(const Snapshot&) {
    return request::Show{kDialog};
}
template <typename R>
Request plain(const Snapshot&) {
    return R{};
}
Request other_theme(const Snapshot& s) {
    return request::SetTheme{s.preferences.theme == ThemeChoice::kDark ? ThemeChoice::kLight
                                                                       : ThemeChoice::kDark};
}
Request larger(const Snapshot& s) {
    return request::SetScale{s.preferences.user_scale * kZoom};
}
Request smaller(const Snapshot& s) {
    return request::SetScale{s.preferences.user_scale / kZoom};
}
Request natural_size(const Snapshot&) {
    return request::SetScale{1.0};
}
Request copy_table(const Snapshot& s) {
    return request::CopyText{table_for_clipboard(s), "Table 1"};
}

Why always(const Snapshot&) {
    return std::nullopt;
}
Why without_session(const Snapshot& s) {
    if (!s.session || s.procedure == nullptr) return "no session is open";
    return std::nullopt;
}
Why without_steps(const Snapshot& s) {
    if (auto why = without_session(s)) return why;
    if (table_of(*s.procedure).empty()) return "there is no step yet";
    return std::nullopt;
}
Why without_template(const Snapshot& s) {
    if (auto why = without_session(s)) return why;
    if (!s.solved) return "there is no template yet: finish the turn first";
    return std::nullopt;
}

Why without_library(const Snapshot& s) {
    if (auto why = without_session(s)) return why;
    if (s.library.empty()) return "the library is empty: add a template first";
    if (s.job) return "something else is going on: " + s.job->name;
    return std::nullopt;
}
Why refuse_recognise(const Snapshot& s) {
    if (auto why = without_library(s)) return why;
    if (s.session->recorded) return "a recording has no camera; recognise one of its captures";
    return std::nullopt;
}
/// The capture at the end of the selected step; nothing: there is none.
std::optional<int> selected_capture(const Snapshot& s) {
    if (s.procedure == nullptr) return std::nullopt;
    const auto table = table_of(*s.procedure);
    if (s.selected_row < table.size()) return table[s.selected_row].row.to;
    const CaptureRecord* last = s.procedure->data.last_used();
    return last != nullptr ? std::optional(last->index) : std::nullopt;
}
Request recognise_capture(const Snapshot& s) {
    return request::Recognise{selected_capture(s)};
}
Why refuse_recognise_capture(const Snapshot& s) {
    if (auto why = without_library(s)) return why;
    if (!selected_capture(s)) return "there is no capture yet";
    return std::nullopt;
}

Why refuse_environment(const Snapshot& s) {
    if (auto why = without_session(s)) return why;
    if (s.session->recorded) return "a recording has no camera";
    if (s.job) return "something else is going on: " + s.job->name;
    return std::nullopt;
}
Request register_object(const Snapshot&) {
    return request::Show{Dialog::kNewSession, false, true};
}
Why refuse_object(const Snapshot& s) {
    if (auto why = without_template(s)) return why;
    if (s.session->object) return "this is an object's turn: begin at the gripper's";
    return std::nullopt;
}

using enum ActionGroup;

const std::array kActions{
    Action{"step.connect", "Connect", "F2", "Open the link to robot and camera", kProcedure,
           give<command::Connect>, refuse<command::Connect>},
    Action{"step.check_cell", "Check the cell", "F3", "Measure every prerequisite of a turn",
           kProcedure, give<command::CheckCell>, refuse<command::CheckCell>},
    Action{"step.warm_up", "Find the axis", "F4",
           "Three small turns show where the axis of joint 6 lies", kProcedure,
           give<command::WarmUp>, refuse<command::WarmUp>},
    Action{"step.capture", "Capture", "C",
           "Take the view here and now: the first one, or the one you have turned to", kProcedure,
           give<command::Capture>, refuse<command::Capture>},
    Action{"step.step", "Step", "S", "Turn joint 6 by the step, capture, compare", kProcedure,
           give<command::Step>, refuse<command::Step>},
    Action{"step.retry", "Retry", "R", "Take the last view again at the same angle", kProcedure,
           give<command::Retry>, refuse<command::Retry>},
    Action{"step.halve", "Halve", "H",
           "Back by half the last step, capture, compare; later steps are halved too", kProcedure,
           give<command::Halve>, refuse<command::Halve>},
    Action{"step.accept", "Accept", "A", "Accept the last step on your word, with a note",
           kProcedure, ask_for_note, refuse_accept},
    Action{"step.back", "Back", "B", "Give up the last view and turn back to the one before",
           kProcedure, give<command::Back>, refuse<command::Back>},
    Action{"step.lock_axis", "Lock axis", "L",
           "From here on the robot tells the angle and the scans only the axis", kProcedure,
           give<command::LockAxis>, refuse<command::LockAxis>},
    Action{"step.run", "Run to 360°", "F5",
           "Go on by itself, as the advisor says, until the turn is complete", kProcedure,
           give<command::Run>, refuse<command::Run>},
    Action{"step.pause", "Pause", "F6", "Stop running after what is going on", kProcedure,
           give<command::Pause>, refuse<command::Pause>},
    Action{"step.stop", "Stop", "Esc", "Stop at once, the arm too. This is not a safety function",
           kProcedure, give<command::Stop>, refuse_stop},
    Action{"step.resume", "Resume", "F7", "Go on with what was interrupted", kProcedure,
           give<command::Resume>, refuse<command::Resume>},
    Action{"step.finish", "Finish", "F8", "Close the turn and make the template of what there is",
           kProcedure, give<command::Finish>, refuse<command::Finish>},
    Action{"step.undo", "Undo", "Ctrl+Z", "Take back the last change of the captures", kProcedure,
           give<command::Undo>, refuse<command::Undo>},
    Action{"step.redo", "Redo", "Ctrl+Y", "Do again what was taken back", kProcedure,
           give<command::Redo>, refuse<command::Redo>},
    Action{"table.copy", "Copy Table 1", "Ctrl+C", "Every column in full precision", kResults,
           copy_table, without_steps},
    Action{"table.csv", "Save Table 1", "Ctrl+S", "As CSV, beside the results", kResults,
           plain<request::SaveTable>, without_steps},
    Action{"window.export", "Export the template", "Ctrl+E", "As point cloud, read back after it",
           kResults, show<Dialog::kExport>, without_template},
    Action{"window.report", "Report", "Ctrl+R", "One page for the hand-over", kResults,
           plain<request::SaveReport>, without_steps},
    Action{"recognise.now", "Capture and recognise", "Ctrl+Enter",
           "Take one view here and now and find the library's templates in it", kResults,
           plain<request::Recognise>, refuse_recognise},
    Action{"recognise.capture", "This capture", "",
           "Find the library's templates in the capture that is selected in Table 1", kResults,
           recognise_capture, refuse_recognise_capture},
    Action{"environment.learn", "Learn the environment", "",
           "Eight pictures without the arm: what stands still is told from what comes later",
           kProcedure, plain<request::LearnEnvironment>, refuse_environment},
    Action{"object.register", "Register an object", "",
           "A new turn, with an object in the registered gripper", kResults, register_object,
           refuse_object},
    Action{"library.add", "Add the template", "",
           "Keep the template of this turn in the library, with what it rests on", kResults,
           plain<request::LibraryAdd>, without_template},
    Action{"page.procedure", "Procedure", "F9", "Turn, compare, decide", kWindow,
           go_to<Page::kProcedure>, without_session},
    Action{"page.template", "Template", "F10", "Crop, filter and export the point cloud", kWindow,
           go_to<Page::kTemplate>, without_session},
    Action{"page.recognise", "Recognise", "Ctrl+F", "Find templates of the library in one view",
           kWindow, go_to<Page::kRecognise>, without_session},
    Action{"page.cell", "Cell", "F11", "Robot, camera and the cell check", kWindow,
           go_to<Page::kCell>, without_session},
    Action{"page.start", "Start page", "Ctrl+O", "Other sessions", kWindow, go_to<Page::kStart>,
           always},
    Action{"window.new", "New session", "Ctrl+N", "Begin a turn", kWindow,
           show<Dialog::kNewSession>, always},
    Action{"window.close", "Close session", "Ctrl+W", "Back to the start page; nothing is lost",
           kWindow, show<Dialog::kClose>, without_session},
    Action{"window.screenshot", "Screenshot", "F12", "The window as a picture", kWindow,
           plain<request::Screenshot>, always},
    Action{"window.larger", "Larger", "Ctrl++", "Everything larger", kWindow, larger, always},
    Action{"window.smaller", "Smaller", "Ctrl+-", "Everything smaller", kWindow, smaller, always},
    Action{"window.natural_size", "Natural size", "Ctrl+0", "As the monitor asks for it", kWindow,
           natural_size, always},
    Action{"window.theme", "Light or dark", "Ctrl+T", "The other theme", kWindow, other_theme,
           always},
    Action{"window.settings", "Settings", "Ctrl+,", "Scale, keys, navigation", kWindow,
           show<Dialog::kSettings>, always},
    Action{"window.keys", "Keys", "F1", "All keys at a glance", kWindow, show<Dialog::kKeys>,
           always},
};

const Action* find(std::string_view name) {
    const auto found = std::find_if(kActions.begin(), kActions.end(),
                                    [&](const Action& a) { return a.name == name; });
    return found == kActions.end() ? nullptr : &*found;
}

std::string degrees(double rad) {
    const double deg = deg_from_rad(rad);
    const bool whole = std::abs(deg - std::round(deg)) < 0.005;
    return fmt::format("{:.{}f}°", deg, whole ? 0 : 2);
}

/// Of the next step: no further than the end of the turn.
double next_step_rad(const ProcedureState& state) {
    const CaptureRecord* last = state.data.last_used();
    const double left_rad = state.plan.total_rad - (last != nullptr ? last->commanded_rad : 0.0);
    return std::min(state.data.step_rad, std::max(0.0, left_rad));
}

double half_of_last_step_rad(const ProcedureState& state) {
    const auto used = state.data.used();
    if (used.size() < 2) return 0.5 * state.data.step_rad;
    return 0.5 * (state.data.captures[used.back()].commanded_rad -
                  state.data.captures[used[used.size() - 2]].commanded_rad);
}

}  // namespace

std::string_view word(ActionGroup group) {
    constexpr std::array<std::string_view, 3> kWords{"Procedure", "Results", "Window"};
    return kWords[static_cast<std::size_t>(group)];
}

std::span<const Action> actions() {
    return kActions;
}

const Action& action(std::string_view name) {
    if (const Action* found = find(name)) return *found;
    throw std::out_of_range(fmt::format("there is no action {}", name));
}

const Action* action_of(const Command& command) {
    return find(fmt::format("step.{}", gripscan::word(command)));
}

const Action* next_action(const Snapshot& s) {
    if (s.page == Page::kRecognise && s.session) {
        return find(s.session->recorded ? "recognise.capture" : "recognise.now");
    }
    if (!s.session || s.session->recorded || s.procedure == nullptr) return nullptr;
    if (std::holds_alternative<phase::Finished>(s.procedure->phase)) {
        return s.solved ? find("window.export") : nullptr;
    }
    const auto command = gripscan::next_action(*s.procedure);
    return command ? action_of(*command) : nullptr;
}

std::string next_label(const Action& a, const Snapshot& s) {
    if (s.procedure == nullptr) return std::string(a.label);
    const ProcedureState& state = *s.procedure;
    if (a.name == "step.step") {
        const char* then = state.plan.mode == MotionMode::kDry ? "write down" : "capture";
        return fmt::format("Step +{} and {}", degrees(next_step_rad(state)), then);
    }
    if (a.name == "step.halve") {
        return fmt::format("Halve to {} and capture", degrees(half_of_last_step_rad(state)));
    }
    if (a.name == "step.capture") {
        return state.data.last_used() == nullptr ? "Capture the first view" : "Turned, capture";
    }
    if (a.name == "step.retry") return "Retry at the same angle";
    if (a.name == "step.finish") return "Finish the turn";
    return std::string(a.label);
}

const Action* second_advice(const Snapshot& s) {
    if (!s.session || s.session->recorded || s.procedure == nullptr) return nullptr;
    const auto* deciding = std::get_if<phase::Deciding>(&s.procedure->phase);
    if (deciding == nullptr) return nullptr;
    const Action* second = nullptr;
    switch (deciding->advice.action) {
        case AdvisedAction::kHalve:
        case AdvisedAction::kLockAxis:
        case AdvisedAction::kStop:
            second = find("step.retry");
            break;
        case AdvisedAction::kRetake:
            second = find("step.halve");
            break;
        case AdvisedAction::kGoOn:
            break;
    }
    return second != nullptr && !second->refusal(s) ? second : nullptr;
}

std::string_view chosen_key(std::string_view name, std::string_view standard,
                            const WindowPreferences& preferences) {
    for (const auto& [action, key] : preferences.keys) {
        if (action == name && !key.empty()) return key;
    }
    return standard;
}

std::string_view key_of(const Action& a, const WindowPreferences& preferences) {
    return chosen_key(a.name, a.key, preferences);
}

const Action* owner_of(std::string_view key, const WindowPreferences& preferences) {
    if (key.empty() || key == "Space") return nullptr;
    for (const Action& a : kActions) {
        if (key_of(a, preferences) == key) return &a;
    }
    return nullptr;
}

Requests requests_for_key(std::string_view key, const Snapshot& s) {
    const Action* wanted = key == "Space" ? next_action(s) : owner_of(key, s.preferences);
    if (wanted == nullptr || wanted->refusal(s)) return {};
    return {wanted->request(s)};
}

}  // namespace gripscan::ui
