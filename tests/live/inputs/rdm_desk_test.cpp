// SPDX-License-Identifier: Apache-2.0
// A desk beside a show, without a network: what it may, what it reads until the show has its edits, who is
// who under another name.
#include "live/inputs/rdm_desk.h"

#include "live/inputs/rdm_heads.h"
#include "rdm/artnet.h"
#include "show/show.h"

#include <gtest/gtest.h>

namespace ghost::app {
namespace {

using Data = std::vector<std::uint8_t>;

scene::Show lamps() {
    auto type = std::make_shared<fixture::Type>();
    for (const int footprint : {4, 8}) {
        type->modes.emplace_back();
        type->modes.back().name = footprint == 4 ? "Short" : "Long";
        type->modes.back().footprint = {footprint};
    }
    scene::Show show;
    for (int i = 0; i < 3; ++i) {
        scene::PatchedFixture fixture;
        fixture.name = "Lamp " + std::to_string(i + 1);
        fixture.type = type;
        fixture.universe = 1;
        fixture.address = 1 + 10 * i;
        show.fixtures.push_back(fixture);
    }
    return show;
}

// The receiver's end, as a desk meets it.
struct Wire {
    explicit Wire(RdmDesk& desk) { desk.listen(options); }
    static std::optional<dmx::PollAnswers::Place> first_port(std::uint16_t port_address) {
        if (port_address > 0) return std::nullopt;
        return dmx::PollAnswers::Place{};
    }
    static constexpr std::uint32_t kDesk = 0x0A000001;
    rdm::Node::Packets send(const Data& bytes) const {
        dmx::Datagram datagram;
        datagram.bytes = bytes;
        datagram.from = dmx::IpAddress(kDesk);
        return options.answer_artnet(datagram, first_port);
    }
    // How many a table tells that comes unasked; nothing: none does. The rest between two is over each time.
    std::optional<int> told() {
        now += rdm::kTableRest;
        const auto unasked = options.unasked(now, first_port);
        if (!unasked) return std::nullopt;
        EXPECT_EQ(unasked->to_ipv4, kDesk);
        const rdm::ArtPacket parsed = rdm::parse_artnet(unasked->packets.at(0));
        return std::get<rdm::TodData>(parsed).total;
    }

    std::vector<rdm::Uid> find() const {
        std::vector<rdm::Uid> uids;
        for (const Data& packet : send(rdm::build_tod_request({{0}}))) {
            const rdm::ArtPacket parsed = rdm::parse_artnet(packet);
            const auto& table = std::get<rdm::TodData>(parsed);
            uids.insert(uids.end(), table.uids.begin(), table.uids.end());
        }
        return uids;
    }
    // The answer's data; of a refusal its reason, from 1000 on. Empty: none came.
    std::vector<int> say(rdm::Command command, const rdm::Uid& to, rdm::Pid pid, Data data = {}) const {
        rdm::Message message;
        message.to = to;
        message.from = {0x7A70, 1};
        message.command = command;
        message.pid = static_cast<std::uint16_t>(pid);
        message.data = std::move(data);
        const auto packets = send(rdm::build_art_rdm(0, message));
        if (packets.empty()) return {};
        const rdm::ArtPacket parsed = rdm::parse_artnet(packets[0]);
        const auto& answer = std::get<rdm::Message>(std::get<rdm::ArtRdm>(parsed).message);
        if (answer.port_or_answer == static_cast<int>(rdm::Answer::nack)) return {1000 + answer.data.at(1)};
        return {answer.data.begin(), answer.data.end()};
    }
    std::vector<int> get(const rdm::Uid& to, rdm::Pid pid) const { return say(rdm::Command::get, to, pid); }
    std::vector<int> set(const rdm::Uid& to, rdm::Pid pid, Data data) const {
        return say(rdm::Command::set, to, pid, std::move(data));
    }
    std::string label(const rdm::Uid& to) const {
        const std::vector<int> data = get(to, rdm::Pid::device_label);
        return {data.begin(), data.end()};
    }
    rdm::Uid of(const std::string& name) const {
        for (const rdm::Uid& uid : find())
            if (label(uid) == name) return uid;
        ADD_FAILURE() << "nobody is " << name;
        return {};
    }
    dmx::ReceiverOptions options;
    std::chrono::nanoseconds now{0};
};

Data text(const std::string& words) {
    return {words.begin(), words.end()};
}

int refusal(rdm::Nack why) {
    return 1000 + static_cast<int>(why);
}

TEST(RdmDesk, off_nobody_is_there_and_the_port_says_so) {
    RdmDesk desk(1);
    const Wire wire(desk);
    desk.update(lamps());
    EXPECT_TRUE(wire.find().empty());
    EXPECT_FALSE(wire.options.knows_rdm());
    EXPECT_TRUE(desk.now().heads.empty());
    desk.set_access(ui::RdmAccess::read);
    EXPECT_EQ(wire.find().size(), 3u);
    EXPECT_TRUE(wire.options.knows_rdm());
    const ui::RdmNow now = desk.now();
    ASSERT_EQ(now.heads.size(), 3u);
    EXPECT_TRUE(now.heads[0].is_found);
    EXPECT_EQ(now.heads[0].fixture, 0u);
}

TEST(RdmDesk, a_desk_is_told_unasked_who_came_and_went) {
    RdmDesk desk(1, ui::RdmAccess::read);
    Wire wire(desk);
    scene::Show show = lamps();
    desk.update(show);
    EXPECT_FALSE(wire.told()) << "nobody asked";
    EXPECT_EQ(wire.find().size(), 3u);
    show.fixtures[0].universe = 2;
    desk.update(show);
    EXPECT_EQ(wire.told(), 2);
    show.fixtures[1].address = 200;
    desk.update(show);
    EXPECT_FALSE(wire.told()) << "it is who it was";
    desk.set_access(ui::RdmAccess::off);
    EXPECT_EQ(wire.told(), 0);
    EXPECT_TRUE(wire.send(rdm::build_tod_request({{0}})).empty()) << "off, the port says that it has no RDM";
    desk.set_access(ui::RdmAccess::read);
    desk.update(show);
    EXPECT_EQ(wire.told(), 2);
    show.fixtures.clear();
    desk.update(show);
    EXPECT_EQ(wire.told(), 0);
    EXPECT_EQ(wire.send(rdm::build_tod_request({{0}})).size(), 1u) << "and who asks hears it";
}

TEST(RdmDesk, who_only_reads_may_identify_and_set_nothing) {
    RdmDesk desk(1, ui::RdmAccess::read);
    const Wire wire(desk);
    desk.update(lamps());
    const rdm::Uid first = wire.of("Lamp 1");
    EXPECT_EQ(wire.set(first, rdm::Pid::dmx_start_address, {0, 100}).at(0),
              refusal(rdm::Nack::write_protect));
    EXPECT_EQ(wire.set(first, rdm::Pid::device_label, text("FOH")).at(0), refusal(rdm::Nack::write_protect));
    EXPECT_TRUE(wire.set(first, rdm::Pid::identify_device, {1}).empty()) << "done, without data";
    EXPECT_EQ(desk.identified(), std::set<std::size_t>{0});
    EXPECT_EQ(desk.now().refused, 2u);
    desk.set_access(ui::RdmAccess::off);
    EXPECT_TRUE(desk.identified().empty());
}

TEST(RdmDesk, a_desk_reads_what_it_set_until_the_show_says_what_became_of_it) {
    RdmDesk desk(1, ui::RdmAccess::edit);
    const Wire wire(desk);
    scene::Show show = lamps();
    desk.update(show);
    const rdm::Uid second = wire.of("Lamp 2");
    EXPECT_TRUE(wire.set(second, rdm::Pid::dmx_start_address, {0, 100}).empty());
    EXPECT_TRUE(wire.set(second, rdm::Pid::dmx_personality, {2}).empty());
    EXPECT_TRUE(wire.set(second, rdm::Pid::dmx_personality, {2}).empty()) << "is so, no edit";
    const std::vector<RdmDesk::Wanted> wanted = desk.take();
    ASSERT_EQ(wanted.size(), 2u);
    EXPECT_EQ(wanted[0].fixture, 1u);
    EXPECT_EQ(wanted[1].number, wanted[0].number + 1);
    desk.update(show); // for another reason: the edits are on their way
    EXPECT_EQ(wire.get(second, rdm::Pid::dmx_start_address), (std::vector<int>{0, 100}));
    show.fixtures[1].address = 100; // the address is an edit, the mode was refused
    desk.update(show, {}, wanted[1].number);
    EXPECT_EQ(wire.get(second, rdm::Pid::dmx_start_address), (std::vector<int>{0, 100}));
    EXPECT_EQ(wire.get(second, rdm::Pid::dmx_personality), (std::vector<int>{1, 2}));
}

TEST(RdmDesk, more_edits_than_may_be_on_their_way_are_refused) {
    RdmDesk desk(1, ui::RdmAccess::edit);
    const Wire wire(desk);
    desk.update(lamps());
    const rdm::Uid first = wire.of("Lamp 1");
    const auto place = [&](std::size_t k) {
        return wire.set(first, rdm::Pid::dmx_start_address, {0, static_cast<std::uint8_t>(100 + k % 2)});
    };
    for (std::size_t k = 0; k < ui::kMostRdmEdits; ++k) ASSERT_TRUE(place(k).empty()) << k;
    EXPECT_EQ(place(ui::kMostRdmEdits).at(0), refusal(rdm::Nack::buffer_full));
    EXPECT_EQ(desk.take().size(), ui::kMostRdmEdits);
}

TEST(RdmDesk, names_are_ones_that_the_show_can_have_and_no_other_fixture_has) {
    RdmDesk desk(1, ui::RdmAccess::edit);
    const Wire wire(desk);
    desk.update(lamps());
    const rdm::Uid first = wire.of("Lamp 1"), second = wire.of("Lamp 2");
    for (const std::string& name : {std::string("Lamp 3"), std::string("a/b"), std::string(),
                                    std::string("\xC3\xA9"), std::string("a\nb")})
        EXPECT_EQ(wire.set(first, rdm::Pid::device_label, text(name)).at(0),
                  refusal(rdm::Nack::data_out_of_range))
            << name;
    EXPECT_TRUE(wire.set(first, rdm::Pid::device_label, text("FOH")).empty());
    EXPECT_EQ(wire.set(second, rdm::Pid::device_label, text("FOH")).at(0),
              refusal(rdm::Nack::data_out_of_range));
    const auto wanted = desk.take();
    ASSERT_EQ(wanted.size(), 1u);
    EXPECT_EQ(wanted[0].change.label, "FOH");
    EXPECT_TRUE(wire.set(first, rdm::Pid::dmx_start_address, {0, 50}).empty());
    EXPECT_EQ(desk.take().at(0).name, "FOH") << "under which the window has it by then";
}

TEST(RdmDesk, a_fixture_stays_who_it_is_under_another_name) {
    RdmDesk desk(1, ui::RdmAccess::edit);
    const Wire wire(desk);
    scene::Show show = lamps();
    desk.update(show);
    const rdm::Uid first = wire.of("Lamp 1");
    for (const char* const name : {"FOH", "Front", "Lamp 1"}) {
        show.fixtures[0].name = name;
        desk.update(show);
        EXPECT_EQ(wire.label(first), name);
    }
    show.fixtures[0].name = "FOH";
    show.fixtures.pop_back(); // somebody went as well: who has the name is not known
    desk.update(show);
    EXPECT_EQ(wire.label(first), "FOH") << "it had that name before";
    desk.forget();
    desk.update(show);
    EXPECT_NE(wire.of("FOH"), first) << "in another show it is somebody else";
}

TEST(RdmHeads, edits_go_to_the_window_and_bodies_flash) {
    ui::Link link;
    link.on_news = [] {};
    RdmHeads heads(link, 1);
    dmx::ReceiverOptions options;
    heads.listen(options);
    const scene::Show show = lamps();
    ui::ViewRequest request;
    heads.step(request, true, show, {}, 10);
    EXPECT_FALSE(options.knows_rdm());
    request.rdm = ui::RdmAccess::edit;
    heads.step(request, true, show, {}, 11);
    RdmDesk unused(1);
    Wire wire(unused);
    wire.options = options;
    const rdm::Uid third = wire.of("Lamp 3");
    EXPECT_TRUE(wire.set(third, rdm::Pid::identify_device, {1}).empty());
    EXPECT_TRUE(wire.set(third, rdm::Pid::device_label, text("Side")).empty());
    heads.step(request, true, show, {}, 12);
    const std::vector<ui::RdmEdit> edits = link.rdm_edits.take();
    ASSERT_EQ(edits.size(), 1u) << "the window need not know of identify";
    EXPECT_EQ(edits[0].fixture, 2u);
    EXPECT_EQ(edits[0].label, "Side");
    EXPECT_TRUE(heads.identifies());
    EXPECT_EQ(heads.flash(12.1), (std::set<std::size_t>{2}));
    EXPECT_FALSE(heads.flash(12.3).has_value()) << "as it was";
    EXPECT_EQ(heads.flash(12.6), (std::set<std::size_t>{}));
    const auto now = link.rdm.take();
    ASSERT_TRUE(now);
    EXPECT_TRUE(now->heads.at(2).identifies);
    request.rdm_answered = edits[0].number; // refused: the show is as it was
    heads.step(request, true, show, {}, 13);
    EXPECT_EQ(wire.label(third), "Lamp 3");
    request.rdm = ui::RdmAccess::off;
    heads.step(request, true, show, {}, 14);
    EXPECT_FALSE(heads.identifies());
    EXPECT_TRUE(wire.find().empty());
}

} // namespace
} // namespace ghost::app
