// SPDX-License-Identifier: Apache-2.0
#include "live/inputs/running_recording.h"

#include "base/log.h"

#include <algorithm>
#include <utility>

namespace ghost::app {
namespace {

using namespace std::chrono_literals;
using std::chrono::microseconds;
using std::chrono::nanoseconds;

constexpr std::size_t kMaxWaiting = 1'000'000; // frames: 0.6 GB, 45 s of 512 universes
constexpr microseconds kFlushEvery = 100ms;    // what a crash costs at most

} // namespace

Result<std::unique_ptr<RunningRecording>> RunningRecording::create(const std::filesystem::path& path,
                                                                   std::vector<std::uint16_t> asked) {
    TRY(dmx::Recorder recorder, dmx::Recorder::create(path));
    return std::unique_ptr<RunningRecording>(
        new RunningRecording(std::move(recorder), path, std::move(asked)));
}

RunningRecording::RunningRecording(dmx::Recorder recorder, std::filesystem::path path,
                                   std::vector<std::uint16_t> asked)
    : recorder_(std::move(recorder)), path_(std::move(path)), asked_(std::move(asked)) {
    asked_.resize(std::min(asked_.size(), dmx::kMaxRecordedUniverses));
    free_ = dmx::kMaxRecordedUniverses - asked_.size();
}

void RunningRecording::put(const dmx::Universes& universes, nanoseconds now) {
    const std::lock_guard lock(mutex_);
    const std::size_t before = waiting_.size();
    changes_.find(universes, now, waiting_);
    if (waiting_.size() <= kMaxWaiting) return;
    const std::size_t kept = std::max(before, kMaxWaiting);
    lost_ += waiting_.size() - kept;
    waiting_.resize(kept);
}

std::uint64_t RunningRecording::lost() {
    const std::lock_guard lock(mutex_);
    return lost_;
}

double RunningRecording::seconds(nanoseconds now) const {
    return first_ ? std::chrono::duration<double>(now - *first_).count() : 0.0;
}

bool RunningRecording::has_place(std::uint16_t universe) {
    if (std::binary_search(asked_.begin(), asked_.end(), universe) || others_.contains(universe)) return true;
    if (others_.size() < free_) return others_.insert(universe).second;
    if (left_out_.empty())
        log_warning("more than " + std::to_string(dmx::kMaxRecordedUniverses) +
                    " universes arrive, as many as a recording holds; those that come now are left out. "
                    "--universes says which are to be recorded");
    left_out_.insert(universe);
    return false;
}

Result<void> RunningRecording::append_waiting(nanoseconds now) {
    std::vector<dmx::RecordedFrame> frames;
    {
        const std::lock_guard lock(mutex_);
        frames = std::exchange(waiting_, {});
    }
    for (dmx::RecordedFrame& frame : frames) {
        if (!has_place(frame.universe)) continue;
        if (!first_) {
            first_ = frame.time;
            recorder_.began(std::chrono::floor<microseconds>(
                std::chrono::system_clock::now().time_since_epoch() - (now - frame.time)));
        }
        frame.time = last_ = frame.time - *first_;
        TRY_VOID(recorder_.append(frame));
    }
    return {};
}

Result<void> RunningRecording::write(nanoseconds now) {
    TRY_VOID(append_waiting(now));
    if (!first_) return {};
    // Frames up to this moment may still be on their way; those of a tenth of a second ago are not.
    const microseconds safe = std::chrono::floor<microseconds>(now) - *first_ - kFlushEvery;
    if (safe - flushed_ < kFlushEvery) return {};
    TRY_VOID(recorder_.flush(std::max(safe, last_)));
    flushed_ = safe;
    return {};
}

Result<void> RunningRecording::finish(nanoseconds now) {
    TRY_VOID(append_waiting(now));
    if (!first_) return Error{"nothing was recorded: no DMX arrived", path_.string()};
    return recorder_.finish(std::max(last_, std::chrono::floor<microseconds>(now) - *first_));
}

} // namespace ghost::app
