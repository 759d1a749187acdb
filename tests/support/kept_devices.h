#pragma once
// SPDX-License-Identifier: Apache-2.0
// Sessions of a test binary have their pipelines from those that were closed before.
#include "gpu/kept_devices.h"

#include <gtest/gtest.h>

#include <optional>

namespace ghost {

class KeepDevices : public testing::Environment {
public:
    void SetUp() override { keeper_.emplace(kAtOnce); }
    void TearDown() override { keeper_.reset(); } // before the validation layer goes

private:
    static constexpr std::size_t kAtOnce = 4; // sessions in a test

    std::optional<gpu::KeptDevices> keeper_;
};
inline auto* const kKeepDevices = testing::AddGlobalTestEnvironment(new KeepDevices);

} // namespace ghost
