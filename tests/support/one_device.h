#pragma once
// SPDX-License-Identifier: Apache-2.0
// The device of a test binary, with validation; made when it is first asked for. It ends with the tests and
// not with the process: by then the objects of the validation layer are gone.
#include "gpu/device.h"
#include "support/must.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

namespace ghost {

class OneDevice : public testing::Environment {
public:
    const gpu::Device& get() {
        if (!device_) device_ = must(gpu::Device::create({"", true}));
        return *device_;
    }
    // What is made of it once for all tests.
    template <class T>
    const T& keep(T made) {
        auto one = std::make_shared<const T>(std::move(made));
        kept_.push_back(one);
        return *one;
    }
    void TearDown() override {
        kept_.clear();
        device_.reset();
    }

private:
    std::vector<std::shared_ptr<const void>> kept_;
    std::unique_ptr<gpu::Device> device_;
};
inline auto* const kOneDevice = static_cast<OneDevice*>(testing::AddGlobalTestEnvironment(new OneDevice));

inline const gpu::Device& device() {
    return kOneDevice->get();
}

} // namespace ghost
