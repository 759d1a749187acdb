#pragma once
// SPDX-License-Identifier: Apache-2.0
// Workers: where the device is a processor, devices beside it whose driver has no threads: what a worker is
// given it does on one core, from its first command to its last. Mesa's driver shares out each dispatch to
// all cores and waits for them, which costs 0.06 ms of processor each time (docs/design/workers.md); two
// workers that draw other lights never wait for each other. They see the memory of the device that they stand
// beside: commands on a worker bind its buffers and textures as they are (VK_EXT_external_memory_host).

#include <span>
#include <vulkan/vulkan.h>

namespace ghost::gpu {

// Makes ready what workers are made from, where nothing but processors draw and there are a few cores. The
// first call alone does, before there are other threads: the driver reads how many threads it may have from
// the environment, which is as it was afterwards. Nothing where somebody has said how many (LP_NUM_THREADS).
// count: of workers; 0: one for each core, where that pays.
void prepare_workers(unsigned count = 0);

// As many workers as there can be; none where prepare_workers() was not called or there is nothing to win.
// They live as long as the program. Any thread.
std::span<const VkInstance> worker_instances();

} // namespace ghost::gpu
