// The static environment beside the window: learned by a job, then held for looks at the cell. On
// the window's thread.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "app/cell_options.h"
#include "app/workstation/job_list.h"
#include "core/scene/environment_model.h"
#include "ui/views/snapshot.h"

namespace gripscan::app {

class EnvironmentDesk {
  public:
    using Fail = std::function<void(std::string title, const Error& error)>;
    /// Environments are kept as sessions in `sessions`.
    EnvironmentDesk(std::filesystem::path sessions, unsigned threads, JobList& jobs, Fail fail);

    /// Takes pictures of that cell with the arm out of the picture and learns from them. The camera
    /// of a real cell must not be in use.
    void learn(const CellOptions& cell, std::function<void()> done);

    /// Null: not learned.
    [[nodiscard]] std::shared_ptr<const EnvironmentModel> model() const { return model_; }
    void show_in(ui::Snapshot& snapshot) const { snapshot.environment = facts_; }

  private:
    std::filesystem::path sessions_;
    unsigned threads_;
    JobList& jobs_;
    Fail fail_;
    std::shared_ptr<const EnvironmentModel> model_;
    std::optional<ui::EnvironmentFacts> facts_;
};

}  // namespace gripscan::app
