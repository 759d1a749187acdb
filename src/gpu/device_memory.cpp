// SPDX-License-Identifier: Apache-2.0
#include "gpu/device_memory.h"

#include "base/check.h"
#include "base/log.h"
#include "base/memory.h"
#include "gpu/device.h"

#include <algorithm>
#include <string>

namespace ghost::gpu {
namespace {

constexpr double kOfFreeMemory = 0.8; // of a processor's: the rest of the program and others need some, too
constexpr double kOfLocalMemory = 0.9;
constexpr std::uint64_t kPageBytes = 4096; // that a processor's driver allocates in

constexpr std::uint64_t kMostBlockBytes = std::uint64_t{64} << 20;
constexpr std::uint64_t kLeastBlockBytes = std::uint64_t{256} << 10;
constexpr std::uint64_t kBlocksOfLimit = 64; // blocks are no larger than that part of what there is
// So much of a block the first one of its kind has, and so much may lie in one.
constexpr std::uint64_t kPartsOfBlock = 8;
constexpr std::uint64_t kLeastAlign = 64; // a line of the cache: we read and write what is mapped

std::string megabytes(std::uint64_t bytes) {
    return std::to_string(bytes >> 20) + " MB";
}

} // namespace

DeviceMemory::DeviceMemory(const Device& device, std::uint64_t limit_bytes, bool has_budget)
    : device_(device), enforced_(limit_bytes > 0),
      has_budget_(has_budget && limit_bytes == 0 && !device.is_cpu()) {
    vkGetPhysicalDeviceMemoryProperties(device.physical(), &properties_);
    for (std::uint32_t i = 0; i < properties_.memoryHeapCount; ++i)
        if (properties_.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT)
            local_bytes_ = std::max<std::uint64_t>(local_bytes_, properties_.memoryHeaps[i].size);
    // What a processor's driver calls its heap is a number of its own (lavapipe: 2 GB) that it does not keep
    // to.
    const std::uint64_t free_bytes = device.is_cpu() ? free_memory_bytes() : 0;
    limit_bytes_ = enforced_ ? limit_bytes
                   : free_bytes > 0
                       ? static_cast<std::uint64_t>(kOfFreeMemory * static_cast<double>(free_bytes))
                       : static_cast<std::uint64_t>(kOfLocalMemory * static_cast<double>(local_bytes_));
    block_bytes_ = kMostBlockBytes;
    while (block_bytes_ > kLeastBlockBytes && block_bytes_ > limit_bytes_ / kBlocksOfLimit) block_bytes_ /= 2;
}

DeviceMemory::~DeviceMemory() {
    for (const auto& block : blocks_) give_back(block->piece);
}

std::uint32_t DeviceMemory::type_of(std::uint32_t allowed, VkMemoryPropertyFlags wanted) const {
    std::uint32_t best = 0;
    int best_score = -1;
    for (std::uint32_t i = 0; i < properties_.memoryTypeCount; ++i) {
        if (!(allowed & (1u << i))) continue;
        const VkMemoryPropertyFlags has = properties_.memoryTypes[i].propertyFlags;
        int score = 0;
        for (std::uint32_t bit = 0; bit < 32; ++bit)
            if ((wanted & (1u << bit)) && (has & (1u << bit))) ++score;
        if (score > best_score) {
            best_score = score;
            best = i;
        }
    }
    return best;
}

// Of whom, and what the driver says of it.
struct DeviceMemory::Needs {
    VkMemoryRequirements of{};
    bool alone = false;
    bool of_images = false;
    VkMemoryDedicatedAllocateInfo owner{VK_STRUCTURE_TYPE_MEMORY_DEDICATED_ALLOCATE_INFO, nullptr,
                                        VK_NULL_HANDLE, VK_NULL_HANDLE};

    // ask: fills the requirements.
    template <class Ask>
    void fill(const Ask& ask) {
        VkMemoryDedicatedRequirements dedicated{};
        dedicated.sType = VK_STRUCTURE_TYPE_MEMORY_DEDICATED_REQUIREMENTS;
        VkMemoryRequirements2 asked{};
        asked.sType = VK_STRUCTURE_TYPE_MEMORY_REQUIREMENTS_2;
        asked.pNext = &dedicated;
        ask(asked);
        of = asked.memoryRequirements;
        alone = dedicated.prefersDedicatedAllocation || dedicated.requiresDedicatedAllocation;
    }
};

MemoryRange DeviceMemory::bind(VkBuffer buffer, VkMemoryPropertyFlags wanted) {
    Needs needs;
    needs.owner.buffer = buffer;
    const VkBufferMemoryRequirementsInfo2 about{VK_STRUCTURE_TYPE_BUFFER_MEMORY_REQUIREMENTS_INFO_2, nullptr,
                                                buffer};
    needs.fill([&](VkMemoryRequirements2& asked) {
        vkGetBufferMemoryRequirements2(device_.handle(), &about, &asked);
    });
    const MemoryRange range = allocate(needs, wanted);
    const VkResult result = vkBindBufferMemory(device_.handle(), buffer, range.memory, range.offset);
    if (result != VK_SUCCESS) release(range);
    VK_CALL(result);
    return range;
}

MemoryRange DeviceMemory::bind(VkImage image, VkImageTiling tiling, VkMemoryPropertyFlags wanted) {
    Needs needs;
    needs.of_images = tiling == VK_IMAGE_TILING_OPTIMAL;
    needs.owner.image = image;
    const VkImageMemoryRequirementsInfo2 about{VK_STRUCTURE_TYPE_IMAGE_MEMORY_REQUIREMENTS_INFO_2, nullptr,
                                               image};
    needs.fill([&](VkMemoryRequirements2& asked) {
        vkGetImageMemoryRequirements2(device_.handle(), &about, &asked);
    });
    const MemoryRange range = allocate(needs, wanted);
    const VkResult result = vkBindImageMemory(device_.handle(), image, range.memory, range.offset);
    if (result != VK_SUCCESS) release(range);
    VK_CALL(result);
    return range;
}

MemoryRange DeviceMemory::allocate(const Needs& needs, VkMemoryPropertyFlags wanted) {
    const std::uint32_t type = type_of(needs.of.memoryTypeBits, wanted);
    const bool is_alone =
        needs.alone || !device_.workers().empty() || needs.of.size > block_bytes_ / kPartsOfBlock;
    if (!is_alone) {
        if (const auto range = range_in_block(needs, type)) return *range;
    }
    MemoryPiece piece;
    const VkResult result = ask(needs.of.size, type, &needs.owner, piece);
    if (result != VK_SUCCESS)
        log_error("asked for " + megabytes(needs.of.size) + " of memory of " + device_.name() + ", " +
                  megabytes(used_bytes_) + " were in use");
    VK_CALL(result);
    used_bytes_ += needs.of.size;
    return {piece.memory, 0, needs.of.size, piece.mapped, nullptr};
}

// Nothing where no block has room and the driver has none for another one.
std::optional<MemoryRange> DeviceMemory::range_in_block(const Needs& needs, std::uint32_t type) {
    const auto range_in = [&](MemoryBlock& block) -> std::optional<MemoryRange> {
        const std::optional<std::uint64_t> at =
            block.free.take(needs.of.size, std::max<std::uint64_t>(needs.of.alignment, kLeastAlign));
        if (!at) return std::nullopt;
        used_bytes_ += needs.of.size;
        return MemoryRange{block.piece.memory, *at, needs.of.size,
                           block.piece.mapped ? block.piece.mapped + *at : nullptr, &block};
    };
    std::uint64_t there_bytes = 0;
    for (const auto& block : blocks_) {
        if (block->type != type || block->of_images != needs.of_images) continue;
        if (const auto range = range_in(*block)) return range;
        there_bytes += block->piece.bytes;
    }
    MemoryPiece piece;
    const std::uint64_t bytes = std::clamp(there_bytes, block_bytes_ / kPartsOfBlock, block_bytes_);
    if (ask(bytes, type, nullptr, piece) != VK_SUCCESS) return std::nullopt;
    blocks_.push_back(
        std::make_unique<MemoryBlock>(MemoryBlock{piece, type, needs.of_images, FreeRanges(bytes)}));
    return range_in(*blocks_.back());
}

VkResult DeviceMemory::ask(std::uint64_t bytes, std::uint32_t type, const void* next, MemoryPiece& piece) {
    VkMemoryAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    info.pNext = next;
    info.allocationSize = bytes;
    info.memoryTypeIndex = type;
    const auto try_it = [&] {
        const bool beyond = enforced_ && held_bytes_ + bytes > limit_bytes_;
        if (beyond || pieces_ >= device_.limits().memory_pieces) return VK_ERROR_OUT_OF_DEVICE_MEMORY;
        const VkResult result = vkAllocateMemory(device_.handle(), &info, nullptr, &piece.memory);
        return result == VK_ERROR_TOO_MANY_OBJECTS ? VK_ERROR_OUT_OF_DEVICE_MEMORY : result;
    };
    VkResult result = try_it();
    if (result != VK_SUCCESS && give_back_empty_blocks()) result = try_it();
    if (result != VK_SUCCESS) return result;
    held_bytes_ += bytes;
    ++pieces_;
    piece.bytes = bytes;
    constexpr VkMemoryPropertyFlags kSeen =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    if ((properties_.memoryTypes[type].propertyFlags & kSeen) != kSeen) return VK_SUCCESS;
    void* mapped = nullptr;
    result = vkMapMemory(device_.handle(), piece.memory, 0, VK_WHOLE_SIZE, 0, &mapped);
    if (result != VK_SUCCESS) give_back(piece);
    piece.mapped = static_cast<std::uint8_t*>(mapped);
    return result;
}

void DeviceMemory::release(const MemoryRange& range) {
    if (range.memory == VK_NULL_HANDLE) return;
    used_bytes_ -= range.bytes;
    if (!range.block) {
        give_back({range.memory, range.bytes, nullptr});
        return;
    }
    // One empty block of a kind stays, or whoever fills textures one after the other would wait for the
    // driver each time.
    MemoryBlock& block = *range.block;
    block.free.give_back(range.offset, range.bytes);
    if (!block.free.is_whole()) return;
    const auto other = std::find_if(blocks_.begin(), blocks_.end(), [&](const auto& one) {
        return one.get() != &block && one->type == block.type && one->of_images == block.of_images &&
               one->free.is_whole();
    });
    if (other == blocks_.end()) return;
    const MemoryBlock* goes = (*other)->piece.bytes <= block.piece.bytes ? other->get() : &block;
    give_back(goes->piece);
    std::erase_if(blocks_, [&](const auto& one) { return one.get() == goes; });
}

void DeviceMemory::give_back(const MemoryPiece& piece) {
    vkFreeMemory(device_.handle(), piece.memory, nullptr);
    held_bytes_ -= piece.bytes;
    --pieces_;
}

bool DeviceMemory::give_back_empty_blocks() {
    const auto empty = [](const auto& block) { return block->free.is_whole(); };
    for (const auto& block : blocks_)
        if (empty(block)) give_back(block->piece);
    return std::erase_if(blocks_, empty) > 0;
}

std::uint64_t DeviceMemory::empty_bytes() const {
    std::uint64_t bytes = 0;
    for (const auto& block : blocks_)
        if (block->free.is_whole()) bytes += block->piece.bytes;
    return bytes;
}

namespace {

VkResult import_memory(const Device& worker, void* memory, std::uint64_t bytes, VkDeviceMemory& shared) {
    VkImportMemoryHostPointerInfoEXT import{};
    import.sType = VK_STRUCTURE_TYPE_IMPORT_MEMORY_HOST_POINTER_INFO_EXT;
    import.handleType = VK_EXTERNAL_MEMORY_HANDLE_TYPE_HOST_ALLOCATION_BIT_EXT;
    import.pHostPointer = memory;
    VkMemoryAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    info.pNext = &import;
    info.allocationSize = (bytes + kPageBytes - 1) / kPageBytes * kPageBytes;
    return vkAllocateMemory(worker.handle(), &info, nullptr, &shared);
}

bool is_on_pages(const void* memory) {
    return memory && reinterpret_cast<std::uintptr_t>(memory) % kPageBytes == 0;
}

} // namespace

bool DeviceMemory::can_share_with(const Device& worker) const {
    VkMemoryAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    info.allocationSize = kPageBytes;
    VkDeviceMemory memory = VK_NULL_HANDLE, shared = VK_NULL_HANDLE;
    if (vkAllocateMemory(device_.handle(), &info, nullptr, &memory) != VK_SUCCESS) return false;
    void* mapped = nullptr;
    const bool can = vkMapMemory(device_.handle(), memory, 0, VK_WHOLE_SIZE, 0, &mapped) == VK_SUCCESS &&
                     is_on_pages(mapped) && import_memory(worker, mapped, kPageBytes, shared) == VK_SUCCESS;
    vkFreeMemory(worker.handle(), shared, nullptr);
    vkFreeMemory(device_.handle(), memory, nullptr);
    return can;
}

VkDeviceMemory DeviceMemory::share(void* memory, std::uint64_t bytes) const {
    CHECK(is_on_pages(memory));
    VkDeviceMemory shared = VK_NULL_HANDLE;
    VK_CALL(import_memory(device_, memory, bytes, shared));
    return shared;
}

std::uint64_t DeviceMemory::left_bytes() const {
    const std::uint64_t held = held_bytes_ - empty_bytes(); // what is empty goes before anything is refused
    std::uint64_t left = limit_bytes_ > held ? limit_bytes_ - held : 0;
    // Others may have taken some meanwhile.
    if (const std::uint64_t free_bytes = device_.is_cpu() && !enforced_ ? free_memory_bytes() : 0;
        free_bytes > 0)
        left = std::min(left, static_cast<std::uint64_t>(kOfFreeMemory * static_cast<double>(free_bytes)));
    if (!has_budget_) return left;
    VkPhysicalDeviceMemoryBudgetPropertiesEXT budget{};
    budget.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_BUDGET_PROPERTIES_EXT;
    VkPhysicalDeviceMemoryProperties2 asked{};
    asked.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_PROPERTIES_2;
    asked.pNext = &budget;
    vkGetPhysicalDeviceMemoryProperties2(device_.physical(), &asked);
    std::uint64_t largest = 0;
    for (std::uint32_t i = 0; i < properties_.memoryHeapCount; ++i) {
        const bool local = properties_.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT;
        if (!local || budget.heapBudget[i] <= budget.heapUsage[i]) continue;
        largest = std::max<std::uint64_t>(largest, budget.heapBudget[i] - budget.heapUsage[i]);
    }
    return std::min(left, largest);
}

} // namespace ghost::gpu
