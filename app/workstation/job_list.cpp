#include "app/workstation/job_list.h"

#include <algorithm>

#include "core/concurrency/thread_priority.h"

namespace gripscan::app {

void JobList::start(const std::string& name, Work work) {
    for (const auto& job : jobs_) {
        if (job->name != name) continue;
        job->thread.request_stop();
        job->unwanted = true;
    }
    jobs_.push_back(std::make_unique<Job>());
    Job& job = *jobs_.back();
    job.name = name;
    job.thread = std::jthread([&job, wake = wake_, work = std::move(work)](std::stop_token stop) {
        // What a job starts (a run's computing, the simulated cell) inherits it: the window's own
        // thread comes first.
        work_in_background();
        const Progress progress{
            std::move(stop), [&](std::string_view, std::size_t done, std::size_t total) {
                if (total == 0) return;
                job.part = static_cast<double>(done) / static_cast<double>(total);
                wake();
            }};
        Outcome outcome = work(progress);
        {
            const std::lock_guard lock(job.mutex);
            job.outcome = std::move(outcome);
        }
        job.done = true;
        wake();
    });
}

void JobList::pump() {
    // An outcome may start another job: those that have ended leave the list first.
    std::vector<std::unique_ptr<Job>> ended;
    for (auto& job : jobs_) {
        if (job->done) ended.push_back(std::move(job));
    }
    std::erase(jobs_, nullptr);
    for (const auto& job : ended) {
        job->thread.join();
        if (!job->unwanted && job->outcome) job->outcome();
    }
}

void JobList::cancel_all() {
    for (const auto& job : jobs_) job->thread.request_stop();
}

void JobList::stop(const std::string& name) {
    for (const auto& job : jobs_) {
        if (job->name == name) job->thread.request_stop();
    }
    // The thread is joined with its job.
    std::erase_if(jobs_, [&](const auto& job) { return job->name == name; });
}

bool JobList::running(const std::string& name) const {
    return std::ranges::any_of(
        jobs_, [&](const auto& job) { return job->name == name && !job->unwanted; });
}

std::optional<JobList::Shown> JobList::shown() const {
    for (const auto& job : jobs_) {
        if (job->unwanted) continue;
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - job->begun;
        return Shown{job->name, job->part, elapsed.count(),
                     job->thread.get_stop_token().stop_requested()};
    }
    return std::nullopt;
}

}  // namespace gripscan::app
