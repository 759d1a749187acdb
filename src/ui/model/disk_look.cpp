// SPDX-License-Identifier: Apache-2.0
#include "ui/model/disk_look.h"

#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

namespace ghost::ui {
namespace {

constexpr int kLookForAnswer_ms = 20;

} // namespace

struct DiskLook::Asked {
    std::mutex mutex;
    Then then; // empty: not answered
};

DiskLook::DiskLook() {
    QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] { look(); });
}

bool DiskLook::ask(std::function<Then()> question) {
    if (asked_) return false;
    auto asked = std::make_shared<Asked>();
    try {
        std::thread([asked, question = std::move(question)] {
            Then then = question();
            const std::lock_guard lock(asked->mutex);
            asked->then = std::move(then);
        }).detach();
    } catch (const std::system_error&) { // no thread: as one that does not answer
        return false;
    }
    asked_ = std::move(asked);
    timer_.start(kLookForAnswer_ms);
    return true;
}

void DiskLook::forget() {
    asked_.reset();
    timer_.stop();
}

void DiskLook::look() {
    Then then;
    {
        const std::lock_guard lock(asked_->mutex);
        then = std::exchange(asked_->then, nullptr);
    }
    if (!then) return;
    forget();
    then();
}

} // namespace ghost::ui
