#include "core/concurrency/worker_pool.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

#include "core/base/number_text.h"

namespace gripscan {
namespace {

thread_local bool inside_a_body = false;

}  // namespace

struct WorkerPool::State {
    struct Loop {
        std::size_t size = 0;
        const std::function<void(std::size_t)>* body = nullptr;
        std::atomic<std::size_t> next{0};
        std::size_t helpers = 0;  ///< threads inside work(); guarded by mutex
        std::exception_ptr failure;
        std::mutex failure_mutex;

        void work() {
            inside_a_body = true;
            for (std::size_t i = next.fetch_add(1); i < size; i = next.fetch_add(1)) {
                try {
                    (*body)(i);
                } catch (...) {
                    const std::scoped_lock lock(failure_mutex);
                    if (!failure) failure = std::current_exception();
                }
            }
            inside_a_body = false;
        }
    };

    std::mutex mutex;
    std::condition_variable_any wake;
    std::condition_variable_any done;
    Loop* current = nullptr;
    std::mutex one_loop_at_a_time;
    std::vector<std::jthread> threads;

    void serve(const std::stop_token& stop) {
        std::unique_lock lock(mutex);
        while (wake.wait(lock, stop, [&] { return current && current->next < current->size; })) {
            Loop& loop = *current;
            ++loop.helpers;
            lock.unlock();
            loop.work();
            lock.lock();
            if (--loop.helpers == 0) done.notify_all();
        }
    }

    void run(std::size_t n, const std::function<void(std::size_t)>& body) {
        if (inside_a_body || threads.empty() || n < 2) {
            for_each_in_order(n, body);
            return;
        }
        const std::scoped_lock exclusive(one_loop_at_a_time);
        Loop loop;
        loop.size = n;
        loop.body = &body;
        {
            const std::scoped_lock lock(mutex);
            current = &loop;
        }
        wake.notify_all();
        loop.work();
        {
            std::unique_lock lock(mutex);
            current = nullptr;
            done.wait(lock, [&] { return loop.helpers == 0; });
        }
        if (loop.failure) std::rethrow_exception(loop.failure);
    }
};

WorkerPool::WorkerPool(unsigned threads) : state_(std::make_unique<State>()) {
    for (unsigned i = 1; i < std::max(threads, 1u); ++i) {
        state_->threads.emplace_back([state = state_.get()](const std::stop_token& stop) {
            state->serve(stop);
        });
    }
}

WorkerPool::~WorkerPool() = default;

unsigned WorkerPool::threads() const { return static_cast<unsigned>(state_->threads.size()) + 1; }

ForEach WorkerPool::for_each() {
    return [state = state_.get()](std::size_t n, const std::function<void(std::size_t)>& body) {
        state->run(n, body);
    };
}

unsigned threads_wanted() {
    if (const char* text = std::getenv("GRIPSCAN_THREADS")) {
        const auto number = number_from_text(text);
        if (number && *number >= 1 && *number <= 1024) return static_cast<unsigned>(*number);
    }
    return std::max(1u, std::thread::hardware_concurrency());
}

}  // namespace gripscan
