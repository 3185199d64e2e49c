// Recognition beside the window: the library as it is listed, the templates made ready once, and
// what was found in the latest view. On the window's thread; the work itself is done by jobs.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "app/placed_detections.h"
#include "app/workstation/job_list.h"
#include "core/recognition/library_add.h"
#include "core/scene/environment_model.h"
#include "ui/views/snapshot.h"

namespace gripscan::app {

/// A view in which templates are looked for.
struct SearchedView {
    Cloud cloud;                                       ///< camera frame
    std::shared_ptr<const ui::StereoPicture> picture;  ///< null: it came as a cloud
    std::optional<JointAngles> joints_rad;             ///< when it was taken
};

struct SearchRequest {
    std::optional<int> capture;  ///< of the session; nothing: a view taken for this
    /// Takes or loads the view; on the job's thread.
    std::function<Result<SearchedView>(const Progress&, const ForEach&)> view;
    std::optional<Pose> T_robot_camera;
    std::shared_ptr<const EnvironmentModel> environment;  ///< null: not learned
    std::optional<Box> region;                            ///< where nothing strange may be
    /// Joint 6 at the first capture of the open session, and its folder: its gripper template
    /// tells where joint 6 stands.
    std::optional<double> first_joint6_rad;
    std::filesystem::path session;
};

class RecognitionDesk {
  public:
    using Fail = std::function<void(std::string title, const Error& error)>;
    /// `jobs` outlives it; `fail` is called on the window's thread.
    RecognitionDesk(std::filesystem::path library, unsigned threads, JobList& jobs, Fail fail);

    /// Reads the library again.
    void refresh();
    void recognise(SearchRequest request);
    /// The template of a session or its results, under the folder's name.
    void add(const std::filesystem::path& session, const std::optional<Pose>& T_tool_template,
             std::function<void(const std::string& name)> done);
    void remove(const std::string& name);
    /// Waits for what still uses the camera of the session, and forgets what was found.
    void leave_session();

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    void show_in(ui::Snapshot& snapshot) const;

  private:
    /// Templates made ready, by the check sum of their points; shared with the job that runs.
    struct Prepared;
    void listed(const Library& library);

    std::filesystem::path folder_;
    unsigned threads_;
    JobList& jobs_;
    Fail fail_;
    std::vector<ui::LibraryEntry> shown_library_;
    std::shared_ptr<Prepared> prepared_;
    std::shared_ptr<const ui::ShownRecognition> recognition_;
    int views_ = 0;
    std::uint64_t generation_ = 0;
};

}  // namespace gripscan::app
