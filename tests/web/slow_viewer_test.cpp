// SPDX-License-Identifier: Apache-2.0
// Whoever reads slowly sees fewer pictures and none that is old, and nobody else notices.
#include "server_peer.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <iostream>
#include <random>

namespace ghost::web {
namespace {

constexpr double kSlow_bytes_per_s = 50'000;
constexpr double kBehind_s = 0.5;    // beside what the transfer of a picture takes
constexpr std::size_t kLamps = 1000; // whose levels alone are 80 kB/s

// Some 30 kB as a JPEG, which is .6 s of a slow line.
ui::Picture busy_picture(std::mt19937& random) {
    constexpr int kBlock = 6;
    image::Image8 image(360, 210, 4);
    for (int y = 0; y < image.height; y += kBlock)
        for (int x = 0; x < image.width; x += kBlock) {
            const auto colour = static_cast<std::uint32_t>(random());
            for (int row = y; row < y + kBlock; ++row)
                for (int column = x; column < x + kBlock; ++column)
                    std::memcpy(image.at(column, row), &colour, 4);
        }
    ui::Picture picture;
    picture.image = std::make_shared<const image::Image8>(std::move(image));
    return picture;
}

struct Seen {
    double end_s; // when its last byte was read
    double age_s; // then
    std::size_t bytes;

    double behind_s() const { return age_s - static_cast<double>(bytes) / kSlow_bytes_per_s; }
};

double seconds_now() {
    return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

// Reads, and acknowledges what it has read, until the end; stops from one time to the other.
std::vector<Seen> look(Peer& peer, const std::atomic<double>& end_s, double stop_s = 0, double go_on_s = 0) {
    std::vector<Seen> seen;
    for (double begin_s = seconds_now(); begin_s < end_s; begin_s = seconds_now()) {
        if (begin_s > stop_s && begin_s < go_on_s) {
            std::this_thread::sleep_for(std::chrono::duration<double>(go_on_s - begin_s));
            continue;
        }
        const Buffer picture = peer.hear_bytes(1, std::chrono::milliseconds(1500));
        if (picture.size() < 32) continue;
        double drawn_ms = 0;
        std::memcpy(&drawn_ms, picture.data() + 8, sizeof drawn_ms);
        peer.paint(number_of(picture));
        const double now_s = seconds_now();
        seen.push_back({now_s, now_s - 1e-3 * drawn_ms, picture.size()});
    }
    return seen;
}

double median_age_s(const std::vector<Seen>& seen, double from_s, double to_s) {
    std::vector<double> ages_s;
    for (const Seen& one : seen)
        if (one.end_s >= from_s && one.end_s < to_s) ages_s.push_back(one.age_s);
    if (ages_s.empty()) return 1e9;
    const auto middle = ages_s.begin() + static_cast<std::ptrdiff_t>(ages_s.size() / 2);
    std::nth_element(ages_s.begin(), middle, ages_s.end());
    return *middle;
}

TEST_F(WebServer, a_slow_viewer_is_never_far_behind_and_a_quick_one_does_not_notice) {
    open_show(kLamps);
    Peer quick(server->port());
    std::vector<std::unique_ptr<Peer>> slow;
    for (int i = 0; i < 3; ++i) slow.push_back(std::make_unique<Peer>(server->port()));
    ASSERT_EQ(quick.look_on(server->keys().token), 101);
    for (auto& peer : slow) {
        ASSERT_EQ(peer->look_on(server->keys().token), 101);
        ASSERT_FALSE(peer->hear("show").is_null());
        peer->read_at(kSlow_bytes_per_s);
    }
    slow[1]->say(R"({"type":"levels","on":true})");

    std::atomic<bool> ends = false;
    std::thread engine([&] { // 25 pictures a second, each with the levels of all lamps
        std::mt19937 random(1);
        while (!ends) {
            ui::RigNow rig;
            rig.fixtures.resize(kLamps);
            link.rig.put(rig);
            link.picture.put(busy_picture(random));
            server->news();
            std::this_thread::sleep_for(40ms);
        }
    });
    constexpr double kReads_s = 1.2, kStops_s = 3, kGoesOn_s = 1.8, kAlone_s = 0.8;
    const double stop_s = seconds_now() + kReads_s, go_on_s = stop_s + kStops_s;
    const std::atomic<double> leave_s = go_on_s + kGoesOn_s;
    std::atomic<double> quick_end_s = 1e12;
    std::vector<Seen> quick_saw, slow_saw, with_levels_saw, stopping_saw;
    std::thread quick_thread([&] { quick_saw = look(quick, quick_end_s); });
    std::thread slow_thread([&] { slow_saw = look(*slow[0], leave_s); });
    std::thread levels_thread([&] { with_levels_saw = look(*slow[1], leave_s); });
    stopping_saw = look(*slow[2], leave_s, stop_s, go_on_s);
    slow_thread.join();
    levels_thread.join();
    slow.clear();
    const double left_s = seconds_now();
    quick_end_s = left_s + kAlone_s;
    quick_thread.join();
    ends = true;
    engine.join();

    const auto most_behind_s = [&](const std::vector<Seen>& seen) {
        double most_s = 0;
        for (const Seen& one : seen) most_s = std::max(most_s, one.behind_s());
        return most_s;
    };
    EXPECT_GE(slow_saw.size(), 4u);
    EXPECT_LT(most_behind_s(slow_saw), kBehind_s);
    EXPECT_GE(with_levels_saw.size(), 4u);
    EXPECT_LT(most_behind_s(with_levels_saw), kBehind_s);
    // The one that was on the way when he stopped is old, whatever anybody does.
    const auto old = std::find_if(stopping_saw.begin(), stopping_saw.end(),
                                  [&](const Seen& one) { return one.end_s > go_on_s; });
    ASSERT_NE(old, stopping_saw.end());
    stopping_saw.erase(old);
    EXPECT_GE(stopping_saw.size(), 3u);
    EXPECT_LT(most_behind_s(stopping_saw), kBehind_s);
    const double beside_s = median_age_s(quick_saw, 0, leave_s);
    const double alone_s = median_age_s(quick_saw, left_s, 1e12);
    EXPECT_GT(quick_saw.size(), 80u);
    EXPECT_LT(beside_s, alone_s + 0.02);
    ASSERT_LT(alone_s, 1);
    for (const auto& [name, seen] :
         {std::pair("reads 50 kB/s", &slow_saw), std::pair("and gets levels", &with_levels_saw),
          std::pair("stops for 3 s", &stopping_saw)})
        std::cout << name << ": " << seen->size() << " pictures, behind by " << most_behind_s(*seen)
                  << " s at most beside the transfer of one\n";
    std::cout << "quick: " << quick_saw.size() << " pictures, " << 1e3 * beside_s << " ms old, "
              << 1e3 * alone_s << " ms without the others\n";
}

TEST_F(WebServer, who_has_too_much_on_the_way_is_sent_away) {
    open_show(1);
    Peer peer(server->port());
    ASSERT_EQ(peer.look_on(server->keys().token), 101);
    ASSERT_FALSE(peer.hear("show").is_null());
    const auto put = [&](std::size_t bytes) {
        link.messages.put({Message{Severity::note, "a", std::string(bytes, 'x')}});
        server->news();
        std::this_thread::sleep_for(300ms); // in which nothing is read
    };
    put(3u << 20);
    EXPECT_FALSE(peer.hear("messages").is_null()) << "below the limit it comes, however late";
    put(40u << 20); // what the system does not hold is more than 4 MiB
    for (int k = 0; k < 10; ++k) put(1); // until a busy machine has come so far
    EXPECT_EQ(peer.close_code(), kCloseTryLater);
}

} // namespace
} // namespace ghost::web
