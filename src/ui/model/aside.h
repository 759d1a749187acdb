#pragma once
// SPDX-License-Identifier: Apache-2.0
// aside: work of seconds (a large file that is read, copied or packed) on a thread of its own, in the middle
// of what a person asked for: the window goes on meanwhile, and who asked has the answer as if it had come at
// once. What was looked up before is to be looked up anew: another show may be open by then. Work that says
// how far it is is a job (ui/model/jobs.h). Window thread.

#include "base/result.h"

#include <QEventLoop>
#include <QMetaObject>

#include <future>
#include <thread>
#include <type_traits>
#include <utility>

namespace ghost::ui {

// work: a function that gives a Result. Error: its own, or the program ended meanwhile, after the work.
template <class Work>
std::invoke_result_t<Work> aside(Work work) {
    constexpr int kIsDone = 1; // 0: the program ends
    QEventLoop loop;
    std::packaged_task<std::invoke_result_t<Work>()> task(std::move(work));
    auto answer = task.get_future();
    std::thread thread([&] {
        task();
        QMetaObject::invokeMethod(
            &loop, [&loop] { loop.exit(kIsDone); }, Qt::QueuedConnection);
    });
    const bool is_done = loop.exec() == kIsDone;
    thread.join();
    if (!is_done) return Error{"the window was closed before it was done", ""};
    return answer.get();
}

} // namespace ghost::ui
