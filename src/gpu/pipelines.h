#pragma once
// SPDX-License-Identifier: Apache-2.0
// Pipelines: those of a device, each made once and kept as long as the device, for what is drawn with them
// comes and goes with every size of the picture, and drivers compile a shader only when it is first used.
// Known by the words of their shaders and all else that they are made from. They are made side by side, on
// threads of their own, from when they are asked for until they are used: a driver takes a tenth of a second
// for a long shader, and a show begins with fifty. Those that may never be used are made when there is time,
// where somebody says so (make_late), else when they are. Any thread.

#include "gpu/push_layout.h"
#include "gpu/shader.h"

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace ghost::gpu {

struct Pipeline {
    PushLayout layout;
    VkPipeline handle = VK_NULL_HANDLE;
};

// What a pipeline is made from, as numbers.
class PipelineKey {
public:
    void add(std::uint64_t number) { numbers_.push_back(number); }
    void add(std::span<const std::uint32_t> words);
    bool operator<(const PipelineKey& other) const { return numbers_ < other.numbers_; }

private:
    std::vector<std::uint64_t> numbers_;
};

// How a pipeline came to be, for those who look at shaders.
struct PipelineMade {
    Shader shader; // of the fragment, where there are two
    std::vector<std::uint32_t> constants;
    bool is_raster = false;
    double ms = 0; // that the driver took
    // What the driver says, by its own names ("Registers", "VGPRs", "Spilled VGPRs"); see
    // DeviceOptions::pipeline_statistics.
    std::vector<std::pair<std::string, double>> statistics;
};

class Pipelines {
public:
    // One that is made, or will be; lives as long as the device.
    struct Entry;

    // cache: lives as long as this, or is none.
    Pipelines(VkDevice device, VkPipelineCache cache, bool keeps_statistics);
    ~Pipelines();
    Pipelines(const Pipelines&) = delete;
    Pipelines& operator=(const Pipelines&) = delete;

    // The one of that key. `make` is called once, on a thread of its own or by finish(): what it refers to
    // must outlive the device.
    Entry& begin(PipelineKey key, PipelineMade what, std::function<Pipeline()> make);
    // The same for one that may never be used: only noted.
    void begin_late(PipelineKey key, PipelineMade what, std::function<Pipeline()> make);
    // From now on those are made, too, one after the other, with what processor time others leave.
    void make_late();
    // Waits for it, or makes it where nobody has begun to. Throws what `make` threw.
    const Pipeline& finish(Entry& entry);
    // Those that nobody has begun to make are not made. Before the device goes, of which `make` may ask
    // anything.
    void stop();
    std::vector<PipelineMade> made(); // in the order of begin(), after all are finished
    std::size_t count() const;        // that were begun, late ones too
    std::size_t late_count() const;   // that are noted, and not made yet
    // Of those that were asked for by finish() so far: how many were not there yet. What draws a frame and
    // waits here is late.
    std::uint64_t waited_for() const;
    // For a pipeline that `make` makes: where the driver looks first, and its `flags`.
    VkPipelineCache cache() const { return cache_; }
    VkPipelineCreateFlags flags() const {
        return keeps_statistics_ ? VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR : 0;
    }

private:
    Entry& enter(std::unique_ptr<Entry>& entry, PipelineMade what, std::function<Pipeline()> make);
    void run();
    void run_late();
    void make(Entry& entry);
    std::vector<std::pair<std::string, double>> statistics_of(VkPipeline pipeline) const;

    VkDevice device_;
    VkPipelineCache cache_;
    bool keeps_statistics_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    bool stop_ = false;
    std::uint64_t waited_for_ = 0;
    std::map<PipelineKey, std::unique_ptr<Entry>> all_;
    std::vector<Entry*> in_order_;
    std::deque<Entry*> waiting_, late_;
    std::vector<std::thread> threads_; // begun when there is something to do
    std::thread late_thread_;          // likewise
};

} // namespace ghost::gpu
