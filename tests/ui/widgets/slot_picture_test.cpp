// SPDX-License-Identifier: Apache-2.0
// Pictures of what a wheel holds: a gobo whose left half passes, a red filter, an open slot, a prism.
#include "support/test_window.h"
#include "ui/widgets/slot_picture.h"

#undef slots // a word of Qt's, and of wheels

namespace ghost::ui {
namespace {

constexpr int kSide_px = 32;

std::shared_ptr<const fixture::Type> wheel_type() {
    auto type = std::make_shared<fixture::Type>();
    fixture::Media half;
    half.width = half.height = 64;
    for (int i = 0; i < half.width * half.height; ++i) {
        const std::uint8_t value = i % half.width < half.width / 2 ? 255 : 0;
        half.rgba.insert(half.rgba.end(), {value, value, value, 255});
    }
    type->media.push_back(half);
    type->media.push_back({}); // could not be decoded
    type->wheels.emplace_back();
    std::vector<fixture::Slot>& slots = type->wheels[0].slots;
    slots.resize(5);
    slots[1].media = 0;
    slots[2].color = {0.64f, 0.33f, 5}; // a dark one
    slots[3].facets.resize(3);
    slots[4].media = 1;
    return type;
}

QColor at(const QImage& picture, double x, double y) {
    return picture.pixelColor(static_cast<int>(x * kSide_px), static_cast<int>(y * kSide_px));
}

TEST(SlotPicture, shows_what_the_slot_lets_through) {
    const auto type = wheel_type();
    const std::vector<fixture::Slot>& slots = type->wheels[0].slots;
    const QImage open = slot_picture(*type, slots[0], kSide_px);
    EXPECT_GT(at(open, 0.5, 0.5).lightness(), 240);
    EXPECT_EQ(at(open, 0, 0).alpha(), 0) << "it is round";
    const QImage half = slot_picture(*type, slots[1], kSide_px);
    EXPECT_GT(at(half, 0.25, 0.5).lightness(), 240);
    EXPECT_LT(at(half, 0.75, 0.5).lightness(), 15);
    const QColor red = at(slot_picture(*type, slots[2], kSide_px), 0.5, 0.5);
    EXPECT_GT(red.red(), 240) << "as bright as others, to be told from them";
    EXPECT_LT(red.green(), 60);
    EXPECT_TRUE(slot_picture(*type, slots[3], kSide_px).isNull()) << "a prism has none";
    EXPECT_FALSE(slot_picture(*type, slots[4], kSide_px).isNull());
}

TEST(SlotPicture, what_is_not_there_has_none) {
    SlotPictures pictures;
    const auto type = wheel_type();
    EXPECT_FALSE(pictures.of(type, 0, 1, kSide_px).isNull());
    EXPECT_EQ(pictures.of(type, 0, 1, kSide_px).cacheKey(), pictures.of(type, 0, 1, kSide_px).cacheKey());
    EXPECT_TRUE(pictures.of(type, 0, 3, kSide_px).isNull());
    EXPECT_TRUE(pictures.of(type, 0, 5, kSide_px).isNull());
    EXPECT_TRUE(pictures.of(type, 1, 0, kSide_px).isNull());
    EXPECT_TRUE(pictures.of(type, -1, -1, kSide_px).isNull());
    EXPECT_TRUE(pictures.of(nullptr, 0, 0, kSide_px).isNull());
}

} // namespace
} // namespace ghost::ui
