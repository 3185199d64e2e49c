#include "app/workstation/view_residuals.h"

#include <algorithm>

#include "core/concurrency/worker_pool.h"
#include "core/registration/view_distance.h"
#include "ui/views/scene_parts.h"

namespace gripscan::app {
namespace {

constexpr const char* kJob = "Comparing the views";
/// Views so many steps before and after see the same surface, in steps as they are usual.
constexpr std::size_t kAround = 2;

const ui::ShownCapture* shown_of(const ui::Snapshot& snapshot, int index) {
    const auto at = std::ranges::find(snapshot.captures, index, &ui::ShownCapture::index);
    return at == snapshot.captures.end() ? nullptr : &*at;
}

}  // namespace

void ViewResiduals::refresh(const ui::Snapshot& snapshot, JobList& jobs, unsigned threads) {
    if (!wanted_ || snapshot.procedure == nullptr || jobs.running(kJob)) return;
    const TurnData& data = snapshot.procedure->data;
    const auto poses = ui::capture_poses(snapshot);
    std::vector<Placed> placed;
    auto clouds = std::make_shared<std::vector<std::shared_ptr<const Cloud>>>();
    for (const std::size_t at : data.used()) {
        const ui::ShownCapture* shown = shown_of(snapshot, data.captures[at].index);
        if (shown == nullptr || !poses[at] || !shown->cloud->has_normals()) continue;
        placed.push_back({shown->index, shown->generation, poses[at]->matrix()});
        clouds->push_back(shown->cloud);
    }
    if (placed == placed_ || placed.size() < 2) return;
    jobs.start(kJob, [this, placed, clouds, threads](const Progress&) -> JobList::Outcome {
        std::vector<PosedView> views;
        for (std::size_t k = 0; k < placed.size(); ++k) {
            views.push_back({(*clouds)[k].get(), Pose(placed[k].T_first_capture)});
        }
        WorkerPool pool(threads);
        auto found = std::make_shared<std::vector<std::vector<float>>>(
            distances_to_other_views(views, kAround, pool.for_each()));
        return [this, placed, found] {
            known_.clear();
            ++number_;
            for (std::size_t k = 0; k < placed.size(); ++k) {
                known_[placed[k].index] = {
                    placed[k].generation, number_,
                    std::make_shared<std::vector<float>>(std::move((*found)[k]))};
            }
            placed_ = placed;
        };
    });
}

void ViewResiduals::attach(std::vector<ui::ShownCapture>& captures) const {
    for (ui::ShownCapture& capture : captures) {
        const auto known = known_.find(capture.index);
        if (known == known_.end() || known->second.of_generation != capture.generation) continue;
        capture.residual_m = known->second.distance_m;
        capture.residual_generation = known->second.number;
    }
}

void ViewResiduals::forget() {
    placed_.clear();
    known_.clear();
}

}  // namespace gripscan::app
