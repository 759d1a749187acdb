// SPDX-License-Identifier: Apache-2.0
#include "gpu/uploads.h"

#include "base/check.h"

#include <algorithm>
#include <cstring>

namespace ghost::gpu {
namespace {

constexpr std::uint64_t kFirstStaged_bytes = std::uint64_t{1} << 20;
constexpr std::uint64_t kMostStaged_bytes = std::uint64_t{32} << 20; // beyond, a submission more
constexpr std::uint64_t kPartOfMemory = 16; // that is left: it is wanted for what stays
constexpr std::uint64_t kStagedAlign = 16;  // a texel of any format

} // namespace

Uploads::Uploads(const Device& device) : device_(device), commands_(device) {}

void Uploads::add(const Texture& to, std::uint32_t layer, std::uint32_t level, const VkRect2D& part,
                  const void* rows, std::uint64_t row_bytes, std::uint32_t texel_bytes) {
    CHECK(layer < to.shape().layers && level < to.shape().levels);
    const std::uint64_t width_bytes = std::uint64_t{part.extent.width} * texel_bytes;
    const std::uint64_t bytes = width_bytes * part.extent.height;
    if (bytes == 0) return;
    if (used_ + bytes > staging_.bytes()) {
        finish();
        const std::uint64_t most = std::min(kMostStaged_bytes, device_.memory().left_bytes() / kPartOfMemory);
        const std::uint64_t wanted = std::min(std::max(2 * staging_.bytes(), kFirstStaged_bytes), most);
        if (wanted > staging_.bytes() || bytes > staging_.bytes()) {
            staging_ = Buffer();
            staging_ = Buffer(device_, std::max(wanted, bytes), Access::upload);
        }
    }
    auto* to_bytes = static_cast<std::uint8_t*>(staging_.mapped()) + used_;
    const auto* from = static_cast<const std::uint8_t*>(rows);
    for (std::uint32_t y = 0; y < part.extent.height; ++y)
        std::memcpy(to_bytes + y * width_bytes, from + y * row_bytes, width_bytes);
    Copy& copy = copies_.emplace_back();
    copy.to = to.image();
    copy.region.bufferOffset = used_;
    copy.region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level, layer, 1};
    copy.region.imageOffset = {part.offset.x, part.offset.y, 0};
    copy.region.imageExtent = {part.extent.width, part.extent.height, 1};
    used_ += (bytes + kStagedAlign - 1) / kStagedAlign * kStagedAlign;
}

void Uploads::add(const Texture& to, std::uint32_t layer, std::uint32_t level, const void* data,
                  std::uint32_t texel_bytes) {
    const std::uint32_t width = std::max(to.shape().width >> level, 1u),
                        height = std::max(to.shape().height >> level, 1u);
    add(to, layer, level, {{0, 0}, {width, height}}, data, std::uint64_t{width} * texel_bytes, texel_bytes);
}

void Uploads::finish() {
    if (copies_.empty()) return;
    commands_.begin();
    // Neighbours that go to one texture go with one command.
    std::vector<VkBufferImageCopy> regions;
    for (std::size_t k = 0; k < copies_.size(); ++k) {
        regions.push_back(copies_[k].region);
        if (k + 1 < copies_.size() && copies_[k + 1].to == copies_[k].to) continue;
        vkCmdCopyBufferToImage(commands_.handle(), staging_.handle(), copies_[k].to, VK_IMAGE_LAYOUT_GENERAL,
                               static_cast<std::uint32_t>(regions.size()), regions.data());
        regions.clear();
    }
    commands_.submit_and_wait();
    copies_.clear();
    used_ = 0;
}

} // namespace ghost::gpu
