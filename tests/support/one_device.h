#pragma once
// SPDX-License-Identifier: Apache-2.0
// The device of a test binary, with validation; made when it is first asked for. It ends with the tests and
// not with the process: by then the objects of the validation layer are gone.
#include "gpu/device.h"
#include "support/must.h"

#include <gtest/gtest.h>

#include <memory>

namespace ghost {

class OneDevice : public testing::Environment {
public:
    const gpu::Device& get() {
        if (!device_) device_ = must(gpu::Device::create({"", true}));
        return *device_;
    }
    void TearDown() override { device_.reset(); }

private:
    std::unique_ptr<gpu::Device> device_;
};
inline auto* const kOneDevice = static_cast<OneDevice*>(testing::AddGlobalTestEnvironment(new OneDevice));

inline const gpu::Device& device() {
    return kOneDevice->get();
}

} // namespace ghost
