// SPDX-License-Identifier: Apache-2.0
#include "gpu/pipelines.h"

#include "base/give_way.h"
#include "base/steady_time.h"
#include "gpu/device.h"

#include <algorithm>
#include <exception>
#include <string_view>
#include <utility>

namespace ghost::gpu {
namespace {

constexpr unsigned kMostThreads = 8;

} // namespace

void PipelineKey::add(std::span<const std::uint32_t> words) {
    add(words.size());
    add(std::hash<std::string_view>{}({reinterpret_cast<const char*>(words.data()), words.size_bytes()}));
}

struct Pipelines::Entry {
    enum class State { waits, runs, done };
    PipelineMade what;
    std::function<Pipeline()> make;
    State state = State::waits;
    Pipeline pipeline;
    std::exception_ptr failure;
};

Pipelines::Pipelines(VkDevice device, VkPipelineCache cache, bool keeps_statistics)
    : device_(device), cache_(cache), keeps_statistics_(keeps_statistics) {}

void Pipelines::stop() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_) thread.join();
    threads_.clear();
    if (late_thread_.joinable()) late_thread_.join();
}

Pipelines::~Pipelines() {
    stop();
    for (const auto& [key, entry] : all_) {
        vkDestroyPipeline(device_, entry->pipeline.handle, nullptr);
        vkDestroyPipelineLayout(device_, entry->pipeline.layout.pipeline, nullptr);
        vkDestroyDescriptorSetLayout(device_, entry->pipeline.layout.set, nullptr);
    }
}

Pipelines::Entry& Pipelines::begin(PipelineKey key, PipelineMade what, std::function<Pipeline()> make) {
    const std::lock_guard lock(mutex_);
    std::unique_ptr<Entry>& entry = all_[std::move(key)];
    if (!entry)
        enter(entry, std::move(what), std::move(make));
    else if (const auto late = std::find(late_.begin(), late_.end(), entry.get()); late != late_.end())
        late_.erase(late);
    else
        return *entry;
    in_order_.push_back(entry.get());
    waiting_.push_back(entry.get());
    const std::size_t most = std::clamp(std::thread::hardware_concurrency(), 1u, kMostThreads);
    if (threads_.size() < std::min(most, waiting_.size())) threads_.emplace_back([this] { run(); });
    changed_.notify_all();
    return *entry;
}

void Pipelines::begin_late(PipelineKey key, PipelineMade what, std::function<Pipeline()> make) {
    const std::lock_guard lock(mutex_);
    std::unique_ptr<Entry>& entry = all_[std::move(key)];
    if (entry) return;
    late_.push_back(&enter(entry, std::move(what), std::move(make)));
    changed_.notify_all();
}

void Pipelines::make_late() {
    const std::lock_guard lock(mutex_);
    if (!late_thread_.joinable()) late_thread_ = std::thread([this] { run_late(); });
}

Pipelines::Entry& Pipelines::enter(std::unique_ptr<Entry>& entry, PipelineMade what,
                                   std::function<Pipeline()> make) {
    entry = std::make_unique<Entry>();
    entry->what = std::move(what);
    entry->make = std::move(make);
    return *entry;
}

const Pipeline& Pipelines::finish(Entry& entry) {
    std::unique_lock lock(mutex_);
    if (entry.state != Entry::State::done) ++waited_for_;
    if (entry.state == Entry::State::waits) {
        waiting_.erase(std::find(waiting_.begin(), waiting_.end(), &entry));
        entry.state = Entry::State::runs;
        lock.unlock();
        make(entry);
        lock.lock();
    }
    changed_.wait(lock, [&] { return entry.state == Entry::State::done; });
    if (entry.failure) std::rethrow_exception(entry.failure);
    return entry.pipeline;
}

void Pipelines::run() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [&] { return stop_ || !waiting_.empty(); });
        if (stop_) return;
        Entry& entry = *waiting_.front();
        waiting_.pop_front();
        entry.state = Entry::State::runs;
        lock.unlock();
        make(entry);
        lock.lock();
    }
}

void Pipelines::run_late() {
    give_way();
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [&] { return stop_ || (waiting_.empty() && !late_.empty()); });
        if (stop_) return;
        Entry& entry = *late_.front();
        late_.pop_front();
        in_order_.push_back(&entry);
        entry.state = Entry::State::runs;
        lock.unlock();
        make(entry);
        lock.lock();
    }
}

// Of an entry that nobody else makes.
void Pipelines::make(Entry& entry) {
    const double begin_s = steady_now_s();
    Pipeline pipeline;
    std::exception_ptr failure;
    std::vector<std::pair<std::string, double>> statistics;
    try {
        pipeline = entry.make();
        if (keeps_statistics_) statistics = statistics_of(pipeline.handle);
    } catch (...) {
        failure = std::current_exception();
    }
    {
        const std::lock_guard lock(mutex_);
        entry.pipeline = pipeline;
        entry.failure = failure;
        entry.what.ms = 1e3 * (steady_now_s() - begin_s);
        entry.what.statistics = std::move(statistics);
        entry.make = {};
        entry.state = Entry::State::done;
    }
    changed_.notify_all();
}

std::vector<PipelineMade> Pipelines::made() {
    std::vector<Entry*> entries;
    {
        const std::lock_guard lock(mutex_);
        entries = in_order_;
    }
    std::vector<PipelineMade> all;
    for (Entry* entry : entries) {
        (void)finish(*entry);
        all.push_back(entry->what);
    }
    return all;
}

std::size_t Pipelines::count() const {
    const std::lock_guard lock(mutex_);
    return all_.size();
}

std::size_t Pipelines::late_count() const {
    const std::lock_guard lock(mutex_);
    return late_.size();
}

std::uint64_t Pipelines::waited_for() const {
    const std::lock_guard lock(mutex_);
    return waited_for_;
}

std::vector<std::pair<std::string, double>> Pipelines::statistics_of(VkPipeline pipeline) const {
    const auto properties = reinterpret_cast<PFN_vkGetPipelineExecutablePropertiesKHR>(
        vkGetDeviceProcAddr(device_, "vkGetPipelineExecutablePropertiesKHR"));
    const auto statistics = reinterpret_cast<PFN_vkGetPipelineExecutableStatisticsKHR>(
        vkGetDeviceProcAddr(device_, "vkGetPipelineExecutableStatisticsKHR"));
    VkPipelineInfoKHR info{VK_STRUCTURE_TYPE_PIPELINE_INFO_KHR, nullptr, pipeline};
    std::uint32_t executables = 0;
    VK_CALL(properties(device_, &info, &executables, nullptr));
    std::vector<std::pair<std::string, double>> all;
    for (std::uint32_t k = 0; k < executables; ++k) {
        VkPipelineExecutableInfoKHR executable{VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR, nullptr,
                                               pipeline, k};
        std::uint32_t count = 0;
        VK_CALL(statistics(device_, &executable, &count, nullptr));
        std::vector<VkPipelineExecutableStatisticKHR> found(
            count, {VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR, nullptr, {}, {}, {}, {}});
        VK_CALL(statistics(device_, &executable, &count, found.data()));
        for (const VkPipelineExecutableStatisticKHR& statistic : found) {
            double value = 0;
            switch (statistic.format) {
            case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_BOOL32_KHR:
                value = statistic.value.b32;
                break;
            case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_INT64_KHR:
                value = static_cast<double>(statistic.value.i64);
                break;
            case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_UINT64_KHR:
                value = static_cast<double>(statistic.value.u64);
                break;
            default:
                value = statistic.value.f64;
                break;
            }
            all.emplace_back(statistic.name, value);
        }
    }
    return all;
}

} // namespace ghost::gpu
