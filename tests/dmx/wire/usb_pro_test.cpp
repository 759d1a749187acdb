// SPDX-License-Identifier: Apache-2.0
// The protocol of the DMX USB Pro, by bytes.
#include "dmx/merge/merge.h"
#include "dmx/wire/usb_pro.h"

#include <gtest/gtest.h>

#include <numeric>

namespace ghost::dmx {
namespace {

using Buffer = std::vector<std::uint8_t>;

Buffer operator+(Buffer a, const Buffer& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

Buffer usb_frame(const Buffer& slots, std::uint8_t status = 0, std::uint8_t start_code = 0) {
    return build_usb_pro(5, Buffer{status, start_code} + slots);
}

std::vector<Packet> feed(UsbProWidget& widget, const Buffer& bytes) {
    std::vector<Packet> result;
    widget.feed(bytes, [&](const Packet& packet) { result.push_back(packet); });
    return result;
}

std::vector<Packet> read(const Buffer& bytes) {
    UsbProWidget widget(3, "/dev/ttyUSB0");
    return feed(widget, bytes);
}

Buffer first(const Packet& packet, std::size_t count) {
    return {packet.slots.begin(), packet.slots.begin() + static_cast<std::ptrdiff_t>(count)};
}

TEST(UsbPro, the_hello_asks_for_parameters_serial_number_and_every_frame) {
    EXPECT_EQ(UsbProWidget::hello(),
              (Buffer{0x7E, 3, 2, 0, 0, 0, 0xE7, 0x7E, 10, 0, 0, 0xE7, 0x7E, 8, 1, 0, 0, 0xE7}));
}

TEST(UsbPro, a_frame_has_status_start_code_and_slots) {
    const auto packets = read({0x7E, 5, 5, 0, 0, 0, 10, 20, 255, 0xE7});
    ASSERT_EQ(packets.size(), 1u);
    EXPECT_EQ(packets[0].protocol, Protocol::usb);
    EXPECT_EQ(packets[0].universe, 3);
    EXPECT_EQ(packets[0].slot_count, 3);
    EXPECT_EQ(first(packets[0], 4), (Buffer{10, 20, 255, 0}));
    EXPECT_EQ(packets[0].source_name, "/dev/ttyUSB0");
    EXPECT_STREQ(protocol_name(packets[0].protocol), "USB");
}

TEST(UsbPro, slot_512_is_there) {
    Buffer slots(512);
    std::iota(slots.begin(), slots.end(), std::uint8_t{1});
    slots[511] = 77;
    const auto packets = read(usb_frame(slots));
    ASSERT_EQ(packets.size(), 1u);
    EXPECT_EQ(packets[0].slot_count, 512);
    EXPECT_EQ(packets[0].slots[511], 77);
    slots.push_back(1);
    EXPECT_TRUE(read(usb_frame(slots)).empty()) << "more than a universe";
}

TEST(UsbPro, a_shorter_frame_leaves_nothing_of_a_longer_one) {
    const auto packets = read(usb_frame({1, 2, 3, 4}) + usb_frame({9}));
    ASSERT_EQ(packets.size(), 2u);
    EXPECT_EQ(packets[1].slot_count, 1);
    EXPECT_EQ(first(packets[1], 4), (Buffer{9, 0, 0, 0}));
}

TEST(UsbPro, what_is_no_level_is_counted_and_dropped) {
    UsbProWidget widget(1, "x");
    EXPECT_TRUE(
        feed(widget, usb_frame({1, 2}, 1) + usb_frame({1, 2}, 2) + usb_frame({1, 2}, 0, 0x17)).empty());
    EXPECT_TRUE(feed(widget, build_usb_pro(5, Buffer{0}) + build_usb_pro(12, Buffer{1, 2, 3})).empty());
    EXPECT_EQ(widget.counters().overruns, 2u);
    EXPECT_EQ(widget.counters().not_levels, 1u);
    EXPECT_EQ(widget.counters().malformed, 1u);
    EXPECT_EQ(widget.counters().other_labels, 1u);
    EXPECT_EQ(widget.counters().frames, 0u);
}

// first / 8, forty bits, one byte a bit; byte 0 is the start code.
TEST(UsbPro, changes_count_from_the_start_code) {
    UsbProWidget widget(1, "x");
    auto packets = feed(widget, build_usb_pro(9, Buffer{0, 0x06, 0, 0, 0, 0x80, 11, 22, 39}));
    ASSERT_EQ(packets.size(), 1u);
    EXPECT_EQ(first(packets[0], 3), (Buffer{11, 22, 0}));
    EXPECT_EQ(packets[0].slots[38], 39);
    EXPECT_EQ(packets[0].slot_count, 39);
    // 64 * 8: address 512 alone; the other addresses stay.
    packets = feed(widget, build_usb_pro(9, Buffer{64, 0x01, 0, 0, 0, 0, 200}));
    ASSERT_EQ(packets.size(), 1u);
    EXPECT_EQ(packets[0].slots[511], 200);
    EXPECT_EQ(packets[0].slots[0], 11);
    // The start code's own byte is taken, so that what follows stands where it belongs.
    packets = feed(widget, build_usb_pro(9, Buffer{0, 0x03, 0, 0, 0, 0, 0, 55}));
    ASSERT_EQ(packets.size(), 1u);
    EXPECT_EQ(packets[0].slots[0], 55);
}

TEST(UsbPro, changes_of_another_start_code_are_no_levels) {
    UsbProWidget widget(1, "x");
    EXPECT_TRUE(feed(widget, build_usb_pro(9, Buffer{0, 0x03, 0, 0, 0, 0, 0x17, 99})).empty());
    EXPECT_TRUE(feed(widget, build_usb_pro(9, Buffer{0, 0x02, 0, 0, 0, 0, 98})).empty());
    EXPECT_EQ(widget.counters().not_levels, 2u);
    const auto packets = feed(widget, build_usb_pro(9, Buffer{0, 0x05, 0, 0, 0, 0, 0, 7}));
    ASSERT_EQ(packets.size(), 1u);
    EXPECT_EQ(first(packets[0], 2), (Buffer{0, 7}));
}

TEST(UsbPro, changes_that_are_cut_or_beyond_the_universe_change_nothing) {
    UsbProWidget widget(1, "x");
    EXPECT_TRUE(feed(widget, build_usb_pro(9, Buffer{0, 0x06, 0, 0, 0, 0, 11})).empty());
    EXPECT_TRUE(feed(widget, build_usb_pro(9, Buffer{65, 0x01, 0, 0, 0, 0, 11})).empty());
    EXPECT_EQ(widget.counters().malformed, 2u);
}

TEST(UsbPro, serial_number_and_firmware) {
    UsbProWidget widget(1, "/dev/ttyUSB0");
    EXPECT_FALSE(widget.answered());
    (void)feed(widget,
               build_usb_pro(3, Buffer{44, 1, 9, 1, 40}) + build_usb_pro(10, Buffer{0x78, 0x56, 0x34, 0x12}));
    EXPECT_TRUE(widget.answered());
    EXPECT_EQ(widget.firmware(), "1.44");
    EXPECT_EQ(widget.serial(), "12345678");
    const auto packets = feed(widget, usb_frame({1}));
    ASSERT_EQ(packets.size(), 1u);
    EXPECT_EQ(packets[0].source_name, "DMX USB Pro 12345678 at /dev/ttyUSB0");
    // The name changes when the answer comes; the source does not.
    EXPECT_EQ(packets[0].source, read(usb_frame({1}))[0].source);
    EXPECT_TRUE(widget.goodbye().terminated);
    EXPECT_EQ(widget.goodbye().source, packets[0].source);
}

TEST(UsbPro, the_stream_is_found_again_after_anything) {
    const Buffer good = usb_frame({1, 2, 3});
    for (const Buffer& noise :
         {Buffer{0xE7}, Buffer{0x7E}, Buffer{0x7E, 5, 0xFF, 0xFF}, Buffer{0x7E, 5, 1, 0, 0},
          Buffer{0x7E, 0x7E, 0x7E, 0x7E}, Buffer(1000, 0x55), Buffer{0x7E, 5, 4, 0, 0, 0, 1, 2, 0}}) {
        UsbProWidget widget(1, "x");
        // What looks like the start of a message may swallow frames, as many as its length says at most.
        const auto packets = feed(widget, noise + good + good + Buffer(kMostUsbProData, 0) + good);
        ASSERT_GE(packets.size(), 1u);
        EXPECT_EQ(first(packets.back(), 3), (Buffer{1, 2, 3}));
        EXPECT_GE(widget.counters().skipped_bytes, noise.size());
    }
}

TEST(UsbPro, bytes_may_come_one_by_one) {
    UsbProWidget widget(1, "x");
    std::size_t packets = 0;
    for (const std::uint8_t byte : usb_frame({1, 0x7E, 0xE7, 0x7E}) + usb_frame({5}))
        packets += feed(widget, {byte}).size();
    EXPECT_EQ(packets, 2u);
    EXPECT_EQ(widget.counters().skipped_bytes, 0u);
}

// Every message that is understood, cut everywhere and with every bit turned over: no crash, no level from a
// cut one, and the next whole frame arrives.
TEST(UsbPro, cut_and_damaged_messages) {
    Buffer slots(512, 3);
    const std::vector<Buffer> valid{
        usb_frame({1, 2, 3}), usb_frame(slots), build_usb_pro(9, Buffer{0, 0x06, 0, 0, 0, 0, 11, 22}),
        build_usb_pro(3, Buffer{44, 1, 9, 1, 40}), build_usb_pro(10, Buffer{1, 2, 3, 4})};
    const Buffer after = Buffer(kMostUsbProData + 5, 0) + usb_frame({42});
    for (const Buffer& message : valid) {
        for (std::size_t length = 0; length < message.size(); ++length) {
            UsbProWidget widget(1, "x");
            EXPECT_TRUE(feed(widget, {message.begin(), message.begin() + static_cast<std::ptrdiff_t>(length)})
                            .empty());
            const auto packets = feed(widget, after);
            ASSERT_FALSE(packets.empty());
            EXPECT_EQ(packets.back().slots[0], 42);
        }
        for (std::size_t bit = 0; bit < 8 * message.size(); ++bit) {
            Buffer damaged = message;
            damaged[bit / 8] ^= static_cast<std::uint8_t>(1u << (bit % 8));
            UsbProWidget widget(1, "x");
            const auto packets = feed(widget, damaged + after);
            ASSERT_FALSE(packets.empty());
            EXPECT_EQ(packets.back().slots[0], 42);
            for (const Packet& packet : packets) EXPECT_LE(packet.slot_count, 512);
        }
    }
}

TEST(UsbPro, merged_like_any_source) {
    using namespace std::chrono_literals;
    UsbProWidget widget(1, "/dev/ttyUSB0");
    Merge merge;
    const auto to_merge = [&](std::chrono::nanoseconds now) {
        return [&merge, now](const Packet& packet) { merge.feed(packet, now); };
    };
    widget.feed(usb_frame({50}), to_merge(1s));
    widget.feed(usb_frame({60}), to_merge(1s)); // not numbered, none is late
    EXPECT_EQ(merge.universes().level(1, 1), 60);
    ASSERT_EQ(merge.sources(1s).size(), 1u);
    EXPECT_EQ(merge.sources(1s)[0].id, "/dev/ttyUSB0");
    merge.tick(3400ms);
    EXPECT_FALSE(merge.universes().find(1)->lost);
    merge.tick(3600ms); // nobody drives the widget's input
    EXPECT_TRUE(merge.universes().find(1)->lost);
    EXPECT_EQ(merge.universes().level(1, 1), 60) << "the last look is held";
    widget.feed(usb_frame({70}), to_merge(4s));
    EXPECT_FALSE(merge.universes().find(1)->lost);
    merge.feed(widget.goodbye(), 4s);
    EXPECT_TRUE(merge.universes().find(1)->lost);
    EXPECT_EQ(merge.universes().level(1, 1), 70);
}

} // namespace
} // namespace ghost::dmx
