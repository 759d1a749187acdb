// SPDX-License-Identifier: Apache-2.0
#include "image/image_pool.h"

#include <gtest/gtest.h>

#include <set>
#include <thread>

namespace ghost::image {
namespace {

TEST(ImagePool, memory_is_used_again_once_everybody_let_go) {
    ImagePool pool;
    std::shared_ptr<Image8> first = pool.take(64, 32, 4);
    EXPECT_EQ(first->samples, std::vector<std::uint8_t>(64 * 32 * 4));
    std::shared_ptr<const Image8> shown = first;
    const std::uint8_t* memory = first->samples.data();
    first.reset();
    EXPECT_NE(pool.take(64, 32, 4)->samples.data(), memory) << "it is shown still";
    const std::shared_ptr<Image8> second = pool.take(64, 32, 4);
    std::set<const std::uint8_t*> had{memory, second->samples.data()};
    shown.reset();
    EXPECT_TRUE(had.contains(pool.take(64, 32, 4)->samples.data()));
}

TEST(ImagePool, another_size_gets_other_memory) {
    ImagePool pool;
    pool.take(64, 32, 4).reset();
    for (const auto& [width, height] : {std::pair{32, 64}, std::pair{128, 16}, std::pair{64, 32}}) {
        const std::shared_ptr<Image8> picture = pool.take(width, height, 4);
        EXPECT_EQ(picture->width, width);
        EXPECT_EQ(picture->height, height);
        EXPECT_EQ(picture->samples.size(), 64u * 32u * 4u);
    }
}

TEST(ImagePool, pictures_outlive_it_and_end_in_any_thread) {
    auto pool = std::make_unique<ImagePool>();
    std::vector<std::shared_ptr<Image8>> pictures;
    for (int k = 0; k < 8; ++k) pictures.push_back(pool->take(16, 16, 4));
    std::thread away([&pictures] { pictures.erase(pictures.begin(), pictures.begin() + 6); });
    std::vector<std::shared_ptr<Image8>> taken;
    for (int k = 0; k < 8; ++k) taken.push_back(pool->take(16, 16, 4));
    away.join();
    std::set<const Image8*> all;
    for (const auto& picture : taken) all.insert(picture.get());
    for (const auto& picture : pictures) all.insert(picture.get());
    EXPECT_EQ(all.size(), 10u) << "nobody has what somebody else has";
    pool.reset();
    pictures.front()->samples.assign(pictures.front()->samples.size(), 7);
}

} // namespace
} // namespace ghost::image
