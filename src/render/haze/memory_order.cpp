// SPDX-License-Identifier: Apache-2.0
#include "render/haze/memory_order.h"

#include "base/check.h"
#include "gpu/device_memory.h"

#include <algorithm>
#include <iterator>

namespace ghost::render {

std::uint64_t share_of(Kept kept, const gpu::Device& device) {
    const auto* share = std::find_if(std::begin(kMemoryOrder), std::end(kMemoryOrder),
                                     [&](const MemoryShare& one) { return one.kept == kept; });
    CHECK(share != std::end(kMemoryOrder));
    return device.memory().left_bytes() / 16 * share->sixteenths;
}

std::string sentence_of(std::span<const Shortage> shortages) {
    std::string sentence;
    for (const MemoryShare& share : kMemoryOrder)
        for (const Shortage& shortage : shortages) {
            if (shortage.kept != share.kept || shortage.has >= shortage.wanted) continue;
            sentence += (sentence.empty() ? "" : ", ") + (share.before + std::to_string(shortage.has)) +
                        share.after + " instead of " + std::to_string(shortage.wanted);
        }
    return sentence;
}

} // namespace ghost::render
