// SPDX-License-Identifier: Apache-2.0
// Side views and small pictures, as the server asks for them and gives them out.
#include "server_peer.h"

namespace ghost::web {
namespace {

class WebSides : public WebServer {
protected:
    WebSides() { open({"house", "close", "side"}); }
    void open(const std::vector<std::string>& cameras, const glm::vec3& position_m = glm::vec3(0)) {
        auto show = std::make_shared<scene::Show>();
        for (const std::string& name : cameras) {
            show->cameras.emplace_back();
            show->cameras.back().name = name;
            show->cameras.back().position_m = position_m;
        }
        ui::Opened opened;
        opened.show = show;
        link.opened.put(opened);
        server->news();
    }
    // What the engine is to draw, once there are so many.
    std::vector<ui::SideView> wanted(std::size_t count) {
        std::vector<ui::SideView> views;
        for (int tries = 0; tries < 2000; ++tries) {
            if (auto news = link.side_views.take()) {
                views = *news;
                if (views.size() == count) return views;
            }
            std::this_thread::sleep_for(5ms);
        }
        ADD_FAILURE() << views.size() << " views";
        return views;
    }
    void draw(const ui::SideView& view, std::optional<ui::SideMeasure> measure = {}) {
        const image::Image8 image(64, 36, 4);
        link.side_pictures.put(
            {{view.number, std::make_shared<const image::Image8>(image), 3, true, measure}});
        server->news();
    }
    static std::string watch(const std::string& more) {
        return R"({"type":"watch","width":640,"calm":false)" + more + "}";
    }
};

TEST_F(WebSides, two_are_drawn_and_shared_and_a_third_is_refused) {
    Peer a(server->port()), b(server->port()), c(server->port());
    for (Peer* peer : {&a, &b, &c}) {
        ASSERT_EQ(peer->look_on(server->keys().token), 101);
        ASSERT_FALSE(peer->hear("show").is_null());
    }
    a.say(watch(R"(,"camera":"house")"));
    EXPECT_EQ(wanted(1).front().camera.name, "house");
    b.say(watch(R"(,"camera":"house")"));
    c.say(watch(R"(,"camera":"close","probe":[0.5,0.5])"));
    const auto both = wanted(2);
    draw(both[0]);
    for (Peer* peer : {&a, &b}) {
        const Buffer picture = peer->hear_bytes(1);
        ASSERT_GT(picture.size(), 32u);
        EXPECT_EQ(picture[1] & 16, 16) << "it is a still, and says so";
        EXPECT_EQ(picture[2], 1) << "of a side view";
        peer->paint(number_of(picture));
    }
    draw(both[1], ui::SideMeasure{.place = {0.5f, 0.5f}, .cd_m2 = 4, .hit = true, .lux = 50});
    EXPECT_EQ(c.hear("measure")["lux"], 50);
    b.say(watch(R"(,"camera":"side")"));
    EXPECT_EQ(b.hear("refused")["n"], 0);
    a.say(watch(R"(,"camera":"nowhere")"));
    EXPECT_EQ(a.hear("refused")["why"], "the show has no such camera");
    const auto after = wanted(2);
    EXPECT_EQ(after[0].camera.name, "close");
    EXPECT_EQ(after[1].camera.name, "side") << "nobody watches the house, and who waited has its place";
}

TEST_F(WebSides, who_waits_gets_the_place_that_is_free) {
    auto a = std::make_unique<Peer>(server->port());
    Peer b(server->port()), c(server->port());
    for (Peer* peer : {a.get(), &b, &c}) {
        ASSERT_EQ(peer->look_on(server->keys().token), 101);
        ASSERT_FALSE(peer->hear("show").is_null());
    }
    a->say(watch(R"(,"camera":"house")"));
    wanted(1);
    b.say(watch(R"(,"camera":"close")"));
    wanted(2);
    c.say(watch(R"(,"camera":"side")"));
    EXPECT_EQ(c.hear("refused")["n"], 0);
    a.reset();
    const auto both = wanted(2);
    EXPECT_EQ(both[1].camera.name, "side");
    draw(both[1]);
    const Buffer picture = c.hear_bytes(1);
    ASSERT_GT(picture.size(), 32u);
    EXPECT_EQ(picture[2], 1) << "of a side view";
}

TEST_F(WebSides, an_own_camera_moves_and_goes_with_who_has_it) {
    auto peer = std::make_unique<Peer>(server->port());
    ASSERT_EQ(peer->look_on(server->keys().token), 101);
    ASSERT_FALSE(peer->hear("show").is_null());
    std::uint64_t before = 0;
    for (const char* x : {"1", "2"}) {
        peer->say(watch(std::string(R"(,"own":{"position_m":[)") + x +
                        R"(,0,2],"target_m":[0,0,0],"fov_y_deg":50})"));
        ui::SideView view;
        for (int tries = 0; tries < 50 && view.camera.position_m.x != std::stof(x); ++tries)
            view = wanted(1).front();
        EXPECT_EQ(view.camera.position_m.x, std::stof(x));
        EXPECT_EQ(view.camera.fov_y_deg, 50);
        EXPECT_GT(view.number, before) << "another picture";
        before = view.number;
    }
    peer.reset();
    wanted(0);
}

TEST_F(WebSides, another_show_has_its_cameras_elsewhere_or_not_at_all) {
    Peer peer(server->port());
    ASSERT_EQ(peer.look_on(server->keys().token), 101);
    ASSERT_FALSE(peer.hear("show").is_null());
    peer.say(watch(R"(,"camera":"house")"));
    const ui::SideView before = wanted(1).front();
    open({"house"}, {1, 2, 3});
    const ui::SideView after = wanted(1).front();
    EXPECT_EQ(after.camera.position_m, glm::vec3(1, 2, 3));
    EXPECT_GT(after.number, before.number);
    draw(after);
    for (int i = 0; i < 2; ++i) { // at rest it comes once more, with all its colours
        const Buffer picture = peer.hear_bytes(1);
        ASSERT_GT(picture.size(), 32u);
        peer.paint(number_of(picture));
    }
    EXPECT_TRUE(peer.hear_bytes(1, 200ms).empty()) << "and no more";
    peer.say(watch(R"(,"camera":"house")"));
    EXPECT_FALSE(peer.hear_bytes(1).empty()) << "chosen again it comes again";
    open({"close"});
    EXPECT_EQ(peer.hear("refused")["why"], "the show has no such camera");
    wanted(0);
}

TEST_F(WebSides, who_moves_without_end_has_ten_views_a_second) {
    Peer peer(server->port());
    ASSERT_EQ(peer.look_on(server->keys().token), 101);
    ASSERT_FALSE(peer.hear("show").is_null());
    for (int x = 1; x <= 50; ++x)
        peer.say(watch(R"(,"own":{"position_m":[)" + std::to_string(x) +
                       R"(,0,2],"target_m":[0,0,0],"fov_y_deg":50})"));
    ui::SideView view;
    for (int tries = 0; tries < 50 && view.camera.position_m.x != 50; ++tries) view = wanted(1).front();
    EXPECT_EQ(view.camera.position_m.x, 50) << "the newest";
    EXPECT_LT(view.number, 25u) << "and few of those before";
}

TEST_F(WebServer, small_pictures_come_to_those_who_want_them) {
    Peer peer(server->port());
    ASSERT_EQ(peer.look_on(server->keys().token), 101);
    EXPECT_FALSE(link.wants_small_pictures);
    peer.say(R"({"type":"pictures","on":true})");
    const auto image = std::make_shared<const image::Image8>(32, 18, 4);
    link.camera_pictures.put({{"house", image}});
    link.look_pictures.put({{"Verse", image}});
    server->news();
    std::string names;
    for (int i = 0; i < 2; ++i) {
        const Buffer small = peer.hear_bytes(3);
        ASSERT_GT(small.size(), 4u);
        names +=
            std::to_string(small[1]) + std::string(small.begin() + 4, small.begin() + 4 + small[2]) + " ";
    }
    EXPECT_EQ(names, "0house 1Verse ");
    EXPECT_TRUE(link.wants_small_pictures);
}

} // namespace
} // namespace ghost::web
