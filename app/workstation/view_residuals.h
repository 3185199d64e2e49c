// How far the points of each capture lie from the captures beside it, for the 3D view: computed
// beside the window while that is what colours the points.
#pragma once

#include <map>
#include <vector>

#include "app/workstation/job_list.h"
#include "core/geometry/pose.h"
#include "ui/views/snapshot.h"

namespace gripscan::app {

/// On the window's thread. Must outlive the jobs that it starts.
class ViewResiduals {
  public:
    void want(bool on) { wanted_ = on; }
    [[nodiscard]] bool wanted() const { return wanted_; }

    /// Begins anew where captures or their poses are not those of the last time.
    void refresh(const ui::Snapshot& snapshot, JobList& jobs, unsigned threads);
    /// What is known of them.
    void attach(std::vector<ui::ShownCapture>& captures) const;
    void forget();

  private:
    struct Placed {
        int index;
        std::uint64_t generation;
        Eigen::Matrix4d T_first_capture;
        friend bool operator==(const Placed&, const Placed&) = default;
    };
    struct Known {
        std::uint64_t of_generation;
        std::uint64_t number;
        std::shared_ptr<const std::vector<float>> distance_m;
    };
    bool wanted_ = false;
    std::vector<Placed> placed_;  ///< what `known_` is of
    std::map<int, Known> known_;  ///< by index
    std::uint64_t number_ = 0;
};

}  // namespace gripscan::app
