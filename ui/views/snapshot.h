// What the window shows in one frame: plain data that the workstation puts together and panels
// read. Nothing in it changes while a frame is drawn; heavy parts are shared and never copied.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/geometry/axis.h"
#include "core/geometry/box.h"
#include "core/geometry/stereo_rig.h"
#include "core/procedure/compute_turn.h"
#include "core/procedure/procedure_state.h"
#include "core/registration/template_filter.h"
#include "core/scene/object_split.h"
#include "ui/theme/theme.h"
#include "ui/views/page.h"
#include "ui/views/recognition.h"
#include "ui/views/request.h"

namespace gripscan::ui {

/// Rectified images of one exposure, 8-bit grey, and what was measured in them.
struct StereoPicture {
    cv::Mat left;
    cv::Mat right;
    cv::Mat disparity;  ///< CV_32F of the left image's size, +inf where unknown; empty: not made
    std::optional<StereoHealth> left_health;   ///< inside the registration area
    std::optional<StereoHealth> right_health;  ///< fill and row error are those of the pair
    double t_s = 0.0;
};

/// What only a matched pair tells, inside the registration area.
struct PairFacts {
    std::optional<double> fill;  ///< share of textured pixels that have a depth
    std::string why_no_fill;
    std::optional<double> row_error_px;  ///< median, right row minus left row
    double row_error_sd_px = 0.0;
    std::string why_no_row_error;
};

/// Pairs that were due or came since the camera was opened, and that nobody has seen.
struct LostPairs {
    std::uint64_t not_delivered = 0;  ///< the camera was asked and had trouble
    std::uint64_t late = 0;           ///< due while the pair before was still being taken
    std::uint64_t not_shown = 0;      ///< the next one came before the window drew it
    [[nodiscard]] std::uint64_t all() const { return not_delivered + late + not_shown; }
};

struct LiveStereo {
    std::shared_ptr<const StereoPicture> picture;  ///< the latest; null: none yet
    std::uint64_t number = 0;                      ///< rises with every picture
    double rate_hz = 0.0;
    LostPairs lost;
    /// The latest live pair that was matched, with its disparity; null: none yet.
    std::shared_ptr<const StereoPicture> matched;
    PairFacts matched_facts;
    std::string why_not_matched;  ///< why live pairs are not matched now; empty: they are
    bool on = false;
    std::string why_off;  ///< "the camera is used by the capture"
    std::string trouble;  ///< of the camera; empty: none
};

/// One capture of the turn as it can be shown.
struct ShownCapture {
    int index = 0;
    int attempt = 1;
    std::uint64_t generation = 0;        ///< rises when the capture was taken again
    std::shared_ptr<const Cloud> cloud;  ///< camera frame, cropped to the registration area
    std::shared_ptr<const StereoPicture> picture;  ///< null: it came as a cloud
    /// Of an object's turn: gripper and object told apart; null: not one.
    std::shared_ptr<const ObjectSplit> split;
    /// Distance of every point to the views beside it, m; < 0: none of them saw the place. Null:
    /// not known yet.
    std::shared_ptr<const std::vector<float>> residual_m;
    std::uint64_t residual_generation = 0;  ///< changes with them
};

/// The work that is going on, with its progress.
struct ShownJob {
    std::string name;
    double part = 0.0;  ///< 0 … 1; < 0: unknown
    double elapsed_s = 0.0;
    bool can_cancel = true;
};

enum class LogLevel { kInformation, kWarning, kError };
struct LogLine {
    std::chrono::system_clock::time_point when;
    LogLevel level = LogLevel::kInformation;
    std::string code;  ///< "REG-012"
    std::string text;
};

/// A line of the start page.
struct RecentSession {
    std::filesystem::path folder;
    std::string name;
    std::string kind;  ///< "gripper"
    std::string cell;  ///< "SIM", or the cell file's name
    int steps_done = 0;
    int steps_total = 0;
    std::optional<double> closure_deg;
    std::optional<double> closure_mm;
    enum class End { kComplete, kCheck, kRejected, kInterrupted, kMissing } end = End::kComplete;
    std::string sentence;  ///< "complete", "closed while busy; nothing is lost"
    std::chrono::system_clock::time_point last_used;
};

struct SessionFacts {
    std::filesystem::path folder;
    std::string name;
    std::string cell_name;  ///< "simulated cell"
    bool recorded = false;  ///< opened to look at: no commands
    std::string results;    ///< folder of the results, where there are any
    bool object = false;    ///< of an object in the gripper, not of the gripper
};

/// The cell around the turn, as far as it is known.
struct CellFrame {
    std::optional<RectifiedRig> rig;
    std::optional<Box> region;         ///< registration area, camera frame
    std::optional<Box> wished_region;  ///< as it is to be in the next session; nothing: the same
    std::filesystem::path file;        ///< the cell file; empty: a simulated cell, or a recording
    std::optional<Axis> axis;          ///< joint 6, camera frame
    std::optional<double> axis_sd_rad;
    std::optional<double> axis_sd_m;
    std::optional<Pose> T_robot_camera;
    std::optional<ControllerState> controller;  ///< as it said last
};

/// What is known of everything that stands still.
struct EnvironmentFacts {
    std::filesystem::path folder;
    int captures = 0;
    double known = 0.0;  ///< share of the image
};

struct ToastView {
    std::string id;
    LogLevel level = LogLevel::kInformation;
    std::string title;
    std::string text;
};

/// What the user set; stored between sessions.
struct WindowPreferences {
    ThemeChoice theme = ThemeChoice::kDark;
    double user_scale = 1.0;
    bool large_buttons = false;
    std::string navigation = "gripscan";
    std::vector<std::pair<std::string, std::string>> keys;  ///< action, key: those that differ
};

/// The template as it is filtered now. While a new filter is computed the old result stays.
struct ShownTemplate {
    std::shared_ptr<const Cloud> whole;  ///< frame of the first capture
    std::shared_ptr<const Cloud> kept;
    TemplateFacts whole_facts;
    TemplateFacts kept_facts;
    FilterCounts counts;
    TemplateFilter
        filter;  ///< of these counts; differs from Snapshot::filter while that is computed
};

/// A key of the window.
struct KeyBinding {
    std::string action;    ///< stable: "step.capture"
    std::string label;     ///< "Capture"
    std::string key;       ///< as it is shown: "Ctrl Z"
    std::string group;     ///< "Procedure"
    std::string standard;  ///< the key it has unless the user chose another
};

/// Something that failed, for the dialog that says what to do.
struct ShownError {
    std::string title;
    std::string what;  ///< value, place, reason
    std::string advice;
    std::string action;  ///< words of the one button that does it: "Connect again"; empty: none
    std::vector<Request> does;  ///< what that button asks for
};

struct Snapshot {
    Page page = Page::kStart;
    Dialog dialog = Dialog::kNone;
    WindowPreferences preferences;
    std::vector<RecentSession> recent;  ///< latest first

    std::optional<SessionFacts> session;         ///< nothing: none is open
    const ProcedureState* procedure = nullptr;   ///< with a session
    std::vector<ShownCapture> captures;          ///< those whose data are here
    std::shared_ptr<const ComputedTurn> solved;  ///< poses, template, axis, closure
    CellFrame cell;
    LiveStereo live;
    std::optional<RobotReading> reading;  ///< the latest sign of life, while moving too
    std::optional<ShownJob> job;
    std::optional<double> seconds_left;  ///< of the turn, from real step times
    bool residuals_wanted = false;       ///< of the captures: they are being computed, or are here
    std::size_t selected_row = 0;        ///< of Table 1
    bool follows_last = true;            ///< the selection is the last row

    std::span<const LogLine> log;
    std::vector<ToastView> toasts;
    std::optional<ShownError> error;
    TemplateFilter filter;  ///< of the template page, as the user wants it
    std::optional<ShownTemplate> shown_template;
    std::shared_ptr<const ShownRecognition> recognition;  ///< of the latest view; null: none yet
    std::vector<LibraryEntry> library;                    ///< in order of their names
    std::optional<EnvironmentFacts> environment;          ///< nothing: not learned
    std::vector<std::string> sim_objects;                 ///< what the simulated gripper can hold
    std::vector<KeyBinding> keys;                         ///< all of them, with the user's changes
    std::string last_export;  ///< "read back equal: 369 090 points, …"; empty: none yet
    std::string version;
};

}  // namespace gripscan::ui
