// SPDX-License-Identifier: Apache-2.0
#include "web/private/worker.h"

#include "base/give_way.h"
#include "net/socket.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace ghost::web {

struct Worker::Shared {
    std::mutex mutex; // of all below but the wake
    std::condition_variable more;
    std::deque<Work> works;
    std::vector<Done> done;
    bool ends = false;
    double cpu_s = 0;
    std::shared_ptr<dmx::StreamWake> wake;
};

Worker::Worker(std::shared_ptr<dmx::StreamWake> wake) : shared_(std::make_shared<Shared>()) {
    shared_->wake = std::move(wake);
    std::thread([shared = shared_] { run(shared); }).detach();
}

Worker::~Worker() {
    {
        const std::lock_guard lock(shared_->mutex);
        shared_->ends = true;
    }
    shared_->more.notify_one();
}

void Worker::put(Work work) {
    {
        const std::lock_guard lock(shared_->mutex);
        shared_->works.push_back(std::move(work));
    }
    shared_->more.notify_one();
}

void Worker::finish() {
    std::vector<Done> done;
    {
        const std::lock_guard lock(shared_->mutex);
        done.swap(shared_->done);
    }
    for (const Done& one : done) one();
}

double Worker::cpu_s() const {
    const std::lock_guard lock(shared_->mutex);
    return shared_->cpu_s;
}

void Worker::run(const std::shared_ptr<Shared>& shared) {
    give_way();
    std::unique_lock lock(shared->mutex);
    for (;;) {
        shared->more.wait(lock, [&] { return shared->ends || !shared->works.empty(); });
        if (shared->ends) return;
        Work work = std::exchange(shared->works.front(), nullptr);
        shared->works.pop_front();
        lock.unlock();
        Done done;
        try {
            done = work();
        } catch (...) { // no memory, as a rule
            done = [problem = std::current_exception()] { std::rethrow_exception(problem); };
        }
        work = nullptr;
        const double cpu_s = std::chrono::duration<double>(dmx::thread_cpu_time()).count();
        lock.lock();
        shared->done.push_back(std::move(done));
        shared->cpu_s = cpu_s;
        lock.unlock();
        shared->wake->raise();
        lock.lock();
    }
}

} // namespace ghost::web
