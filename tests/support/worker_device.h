#pragma once
// SPDX-License-Identifier: Apache-2.0
// A device with two workers (gpu/workers.h), whatever the number of cores, made when it is first asked for;
// ends with the tests. Null where there can be none: a graphics card draws, or LP_NUM_THREADS is said.
#include "gpu/device.h"
#include "gpu/workers.h"
#include "support/must.h"

#include <gtest/gtest.h>

#include <memory>

namespace ghost {

class WorkerDevice : public testing::Environment {
public:
    const gpu::Device* get() {
        if (!device_) {
            gpu::prepare_workers(2);
            device_ = must(gpu::Device::create({.validation = true, .workers = true}));
        }
        return device_->workers().empty() ? nullptr : device_.get();
    }
    void TearDown() override { device_.reset(); }

private:
    std::unique_ptr<gpu::Device> device_;
};
inline auto* const kWorkerDevice =
    static_cast<WorkerDevice*>(testing::AddGlobalTestEnvironment(new WorkerDevice));

} // namespace ghost
