#include "app/workstation/environment_desk.h"

#include <fmt/format.h>

#include "app/environment_work.h"
#include "app/workstation/session_files.h"
#include "core/concurrency/worker_pool.h"

namespace gripscan::app {
namespace {
namespace fs = std::filesystem;

constexpr const char* kLearning = "Learning the environment";
constexpr int kCaptures = 8;

/// Records a session of the cell without its arm, and learns from it.
Result<EnvironmentModel> learned(CellOptions options, const fs::path& folder,
                                 const Progress& progress, const ForEach& for_each) {
    options.arm_away = true;
    options.manual = !options.simulated();  // nothing is moved
    options.live = false;
    options.object.clear();
    auto cell = open_cell(options, progress.stop, [&](const std::string& waits) {
        progress.tell(waits, 0, 0);
    });
    if (!cell) return forward_error(cell.error());
    {
        auto store = begin_environment(folder, options, *cell, false);
        if (!store) return forward_error(store.error());
        const auto as_it_stands = [](int, Cell&) { return Status{}; };
        Status done = record_environment(*cell, *store, kCaptures, as_it_stands, progress);
        if (!done) return forward_error(done.error());
    }
    const auto session = open_session(folder);
    if (!session) return forward_error(session.error());
    auto model = learn_environment(*session, progress, for_each);
    if (!model) return model;
    if (Status s = write_environment(*model, folder / "results"); !s) {
        return forward_error(s.error());
    }
    return model;
}

/// Which surroundings a camera sees: those of a cell file, or what a seed makes of the simulated
/// one.
std::string place_of(const CellOptions& cell) {
    if (cell.simulated()) return fmt::format("sim {}", cell.seed);
    std::error_code code;
    const fs::path file = fs::weakly_canonical(cell.cell, code);
    return code ? cell.cell : file.string();
}

}  // namespace

EnvironmentDesk::EnvironmentDesk(fs::path sessions, unsigned threads, JobList& jobs, Fail fail)
    : sessions_(std::move(sessions)), threads_(threads), jobs_(jobs), fail_(std::move(fail)) {}

void EnvironmentDesk::learn(const CellOptions& cell, std::function<void()> done) {
    const fs::path folder = new_session_folder(sessions_, "environment");
    jobs_.start(
        kLearning,
        [this, cell, folder, threads = threads_,
         done = std::move(done)](const Progress& progress) -> JobList::Outcome {
            WorkerPool pool(threads);
            auto model = std::make_shared<Result<EnvironmentModel>>(
                learned(cell, folder, progress, pool.for_each()));
            return [this, model, folder, cell, done] {
                if (!*model) {
                    if (model->error().kind != ErrorKind::kCancelled) {
                        fail_("The environment was not learned", model->error());
                    }
                    return;
                }
                facts_ = ui::EnvironmentFacts{folder, (*model)->captures, (*model)->known()};
                place_ = place_of(cell);
                model_ = std::make_shared<EnvironmentModel>(std::move(**model));
                done();
            };
        });
}

std::shared_ptr<const EnvironmentModel> EnvironmentDesk::model(const CellOptions& cell) const {
    return place_ == place_of(cell) ? model_ : nullptr;
}

void EnvironmentDesk::show_in(ui::Snapshot& snapshot, const CellOptions& cell) const {
    if (place_ == place_of(cell)) snapshot.environment = facts_;
}

}  // namespace gripscan::app
