#pragma once
// SPDX-License-Identifier: Apache-2.0
// ImagePool: memory of pictures of one size, for who makes one after the other and gives each to somebody who
// keeps it for a while: blocks as large go back to the system when they are freed (base/memory.h), and fresh
// ones cost a fault for each page. Pictures may outlive the pool, and be let go of in any thread; the pool
// itself belongs to one.

#include "image/image.h"

#include <memory>
#include <mutex>
#include <vector>

namespace ghost::image {

class ImagePool {
public:
    // Its samples are those of any picture before, or 0.
    std::shared_ptr<Image8> take(int width_px, int height_px, int channel_count);

private:
    struct Shelf {
        std::mutex mutex;
        Image8 shape; // without samples: only such are kept
        std::vector<std::unique_ptr<Image8>> spare;
    };
    static void put_back(Shelf& shelf, std::unique_ptr<Image8> picture);

    std::shared_ptr<Shelf> shelf_ = std::make_shared<Shelf>();
};

} // namespace ghost::image
