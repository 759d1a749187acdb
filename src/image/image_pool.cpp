// SPDX-License-Identifier: Apache-2.0
#include "image/image_pool.h"

#include <utility>

namespace ghost::image {
namespace {

constexpr std::size_t kMostSpare = 4; // one is made, one waits, one is shown, one is compared with

bool same_shape(const Image8& a, const Image8& b) {
    return a.width == b.width && a.height == b.height && a.channels == b.channels;
}

} // namespace

std::shared_ptr<Image8> ImagePool::take(int width_px, int height_px, int channel_count) {
    Image8 shape;
    shape.width = width_px;
    shape.height = height_px;
    shape.channels = channel_count;
    std::unique_ptr<Image8> picture;
    {
        const std::lock_guard lock(shelf_->mutex);
        shelf_->spare.reserve(kMostSpare); // put_back() must not fail
        if (!same_shape(shelf_->shape, shape)) shelf_->spare.clear();
        shelf_->shape = std::move(shape);
        if (!shelf_->spare.empty()) {
            picture = std::move(shelf_->spare.back());
            shelf_->spare.pop_back();
        }
    }
    if (!picture) picture = std::make_unique<Image8>(width_px, height_px, channel_count);
    return {picture.release(),
            [shelf = shelf_](Image8* done) { put_back(*shelf, std::unique_ptr<Image8>(done)); }};
}

void ImagePool::put_back(Shelf& shelf, std::unique_ptr<Image8> picture) {
    const std::lock_guard lock(shelf.mutex);
    if (same_shape(shelf.shape, *picture) && shelf.spare.size() < kMostSpare)
        shelf.spare.push_back(std::move(picture));
}

} // namespace ghost::image
