// Everything a panel can ask for, as values: commands of the procedure, and what concerns the
// window. Panels append; the workstation takes them after the frame was drawn.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/cloud/cloud_file.h"
#include "core/procedure/input.h"
#include "core/procedure/turn_plan.h"
#include "core/registration/template_filter.h"
#include "ui/theme/theme.h"
#include "ui/views/page.h"

namespace gripscan::ui {

/// How a new session is to be recorded.
struct SessionWish {
    std::filesystem::path folder;  ///< empty: a new one beside the others
    std::string cell = "sim";      ///< or the path of a cell file
    double step_deg = 10.0;
    double speed_percent = 10.0;
    bool live = false;  ///< motions of a real controller are sent
    bool manual = false;
    std::uint64_t seed = 1;
    std::vector<std::string> faults;  ///< of the simulated cell
    bool object = false;              ///< the turn of an object that a registered gripper holds
    std::filesystem::path gripper;    ///< session or template of that gripper
    std::string sim_object;           ///< what the simulated gripper holds
};

/// What of the template is written, and how.
struct ExportWish {
    std::filesystem::path file;
    PcdEncoding encoding = PcdEncoding::kCompressed;
    bool millimetres = false;
    bool axis_frame = false;  ///< z along joint 6; else the frame of the first capture
    TemplateFilter filter;
    bool normals = true;
    bool intensity = true;
    bool seen = true;
    bool sigma = true;
};

namespace request {
struct Give {  ///< to the procedure
    Command command;
};
struct HoldToMove {  ///< LIVE: the button that allows motion is held, or was let go
    bool held = false;
};
struct GoTo {
    Page page = Page::kProcedure;
};
struct Open {  ///< a session folder, a recording, a cloud file: to look at, never changed
    std::filesystem::path path;
};
struct Resume {  ///< a session that was interrupted
    std::filesystem::path folder;
};
struct Begin {
    SessionWish wish;
};
struct Tour {};  ///< the guided demonstration
struct CloseSession {
    bool stop_first = false;  ///< the user agreed to stop what is going on
};
struct Forget {  ///< a line of the recent sessions; the folder stays
    std::filesystem::path folder;
};
struct Show {
    Dialog dialog = Dialog::kNone;  ///< none: close the one that is open
    bool cell_file = false;         ///< kNewSession: it begins with a cell file, not the simulation
    bool object = false;  ///< kNewSession: of an object, held by the gripper of this session
};
struct SelectStep {
    std::optional<std::size_t> row;  ///< of Table 1; nothing: the last
};
struct Export {
    ExportWish wish;
};
struct SetPlan {  ///< before the first view: limits, step and speed
    TurnPlan plan;
};
struct SetRegion {  ///< the registration area of the next session; nothing: as it is
    std::optional<Box> region;
};
struct KeepRegion {};  ///< that area into the cell file
struct SetFilter {     ///< of the template
    TemplateFilter filter;
};
struct Recognise {  ///< what is in the library, in a view that is taken now or in a capture
    std::optional<int> capture;
};
struct LearnEnvironment {};  ///< what stands still, with the arm out of the picture
struct LibraryAdd {};        ///< the template that is open
struct LibraryRemove {
    std::string name;
};
struct WantResiduals {  ///< of every capture's points, as long as they are shown
    bool on = false;
};
struct CopyText {
    std::string text;
    std::string what;  ///< for the toast: "Table 1"
};
struct SaveTable {};   ///< as CSV, beside the results
struct SaveReport {};  ///< the HTML page
struct Screenshot {
    bool view_only = false;  ///< the 3D view without its tools, else the whole window
};
struct SetTheme {
    ThemeChoice theme = ThemeChoice::kDark;
};
struct SetScale {
    double factor = 1.0;
};
struct SetLargeButtons {
    bool on = false;
};
struct SetKey {  ///< remap: the action's name and the new key; empty: the default
    std::string action;
    std::string key;
};
struct SetNavigation {
    std::string preset;  ///< "gripscan", "CAD", "RViz"
};
struct ResetLayout {};
struct LiveView {  ///< live images while nothing else uses the camera
    bool on = true;
};
struct CancelJob {};
struct CloseToast {
    std::string id;
};
struct Quit {};
}  // namespace request

using Request = std::variant<
    request::Give, request::HoldToMove, request::GoTo, request::Open, request::Resume,
    request::Begin, request::Tour, request::CloseSession, request::Forget, request::Show,
    request::SelectStep, request::Export, request::SetPlan, request::SetRegion, request::KeepRegion,
    request::SetFilter, request::Recognise, request::LearnEnvironment, request::LibraryAdd,
    request::LibraryRemove, request::WantResiduals, request::CopyText, request::SaveTable,
    request::SaveReport, request::Screenshot, request::SetTheme, request::SetScale,
    request::SetLargeButtons, request::SetKey, request::SetNavigation, request::ResetLayout,
    request::LiveView, request::CancelJob, request::CloseToast, request::Quit>;

/// In the order in which they were asked.
using Requests = std::vector<Request>;

}  // namespace gripscan::ui
