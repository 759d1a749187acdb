// SPDX-License-Identifier: Apache-2.0
// The conformance list after ANSI E1.20-2010 and E1.11: for every parameter get, set, wrong length,
// broadcast, sub-device, and the reasons of refusals; queued messages, discovery, mutes and collisions. One
// test a row, so that what does not pass is named.
#include "support/a_device.h"

#include <functional>
#include <set>

namespace ghost::rdm {
namespace {

using Data = std::vector<std::uint8_t>;

struct Row {
    const char* name;
    Pid pid;
    std::optional<Data> get;        // data of a GET that is right; none: not allowed
    std::optional<Data> expected;   // its answer
    std::optional<Data> set;        // data of a SET that is right; none: not allowed
    std::vector<Data> out_of_range; // of the SET, or of the GET where there is no SET
    bool required = false;          // of every device (table A-3)
};

Data label(const std::string& text, Data before = {}) {
    before.insert(before.end(), text.begin(), text.end());
    return before;
}

const std::vector<Row>& rows() {
    static const std::vector<Row> kRows = {
        {"QUEUED_MESSAGE", Pid::queued_message, Data{4}, Data{}, {}, {{0}, {5}, {255}}},
        {"STATUS_MESSAGES", Pid::status_messages, Data{4}, Data{}, {}, {{5}}},
        {"SUPPORTED_PARAMETERS", Pid::supported_parameters, Data{}, {}, {}, {}, true},
        {"DEVICE_INFO",
         Pid::device_info,
         Data{},
         Data{1, 0, 0x12, 0x34, 0x01, 0x02, 0, 1, 2, 3, 0, 22, 1, 2, 0, 23, 0, 0, 2},
         {},
         {},
         true},
        {"DEVICE_MODEL_DESCRIPTION", Pid::device_model_description, Data{}, label("VL2500 Spot"), {}, {}},
        {"MANUFACTURER_LABEL", Pid::manufacturer_label, Data{}, label("Vari-Lite"), {}, {}},
        {"DEVICE_LABEL", Pid::device_label, Data{}, label("Spot 1"), label("FOH left"), {}},
        {"SOFTWARE_VERSION_LABEL", Pid::software_version_label, Data{}, label("Ghostlight"), {}, {}, true},
        {"DMX_PERSONALITY", Pid::dmx_personality, Data{}, Data{1, 2}, Data{2}, {{0}, {3}, {255}}},
        {"DMX_PERSONALITY_DESCRIPTION",
         Pid::dmx_personality_description,
         Data{2},
         label("Long", {2, 0, 60}),
         {},
         {{0}, {3}}},
        {"DMX_START_ADDRESS",
         Pid::dmx_start_address,
         Data{},
         Data{0, 23},
         Data{0, 100},
         {{0, 0}, {2, 1}, {1, 0xEC}, {0xFF, 0xFF}},
         true}, // 0, 513, 492 (22 slots end at 513), 65535
        {"SLOT_INFO", Pid::slot_info, Data{}, Data{0, 0, 0, 0, 1, 0, 1, 0, 1, 1, 0, 2, 1, 0, 1}, {}, {}},
        {"SLOT_DESCRIPTION",
         Pid::slot_description,
         Data{0, 2},
         label("Pan fine", {0, 2}),
         {},
         {{0, 3}, {2, 0}}},
        {"SENSOR_DEFINITION",
         Pid::sensor_definition,
         Data{0},
         label("Pan", {0, 0x11, 0x16, 1, 0xF5, 0x74, 0x0A, 0x8C, 0xF5, 0x74, 0x0A, 0x8C, 2}),
         {},
         {{2}, {255}}},
        {"SENSOR_VALUE",
         Pid::sensor_value,
         Data{1},
         Data{1, 2, 0x35, 2, 0x35, 2, 0x35, 0, 0},
         Data{1},
         {{2}, {254}}},
        {"IDENTIFY_DEVICE", Pid::identify_device, Data{}, Data{0}, Data{1}, {{2}, {255}}, true},
    };
    return kRows;
}

class Conformance : public testing::TestWithParam<Row> {
protected:
    Responder responder{head()};
    Leave leave;

    Message answer(const Message& to) {
        const Responder::Reply reply = responder.take(to, leave.wants(), kNow);
        EXPECT_TRUE(reply.message.has_value());
        return reply.message.value_or(Message{});
    }
    void expect_nack(const Message& to, Nack why) {
        const Message response = answer(to);
        EXPECT_EQ(response.port_or_answer, static_cast<int>(Answer::nack));
        EXPECT_EQ(response.data, (Data{0, static_cast<std::uint8_t>(why)}));
        expect_addressed(response, to);
    }
    // Such a message says nothing of this parameter; tools/rdm_conformance.py counts it as not run.
    static void not_run(const char* why) { RecordProperty("not_run", why); }
    void expect_addressed(const Message& response, const Message& to) {
        EXPECT_EQ(response.to, to.from);
        EXPECT_EQ(response.from, responder.device().uid);
        EXPECT_EQ(response.transaction, to.transaction);
        EXPECT_EQ(response.sub_device, to.sub_device);
        EXPECT_EQ(response.pid, to.pid);
        EXPECT_TRUE(response.is_response);
    }
};

TEST_P(Conformance, get) {
    const Row& row = GetParam();
    if (!row.get) return expect_nack(ask(Command::get, row.pid), Nack::unsupported_command);
    const Message to = ask(Command::get, row.pid, *row.get), response = answer(to);
    EXPECT_EQ(response.port_or_answer, static_cast<int>(Answer::ack));
    EXPECT_EQ(response.command, Command::get);
    if (row.expected) {
        EXPECT_EQ(response.data, *row.expected);
    }
    if (row.pid != Pid::queued_message) expect_addressed(response, to);
}

TEST_P(Conformance, get_of_a_wrong_length) {
    const Row& row = GetParam();
    Data more = row.get.value_or(Data{});
    more.push_back(0);
    expect_nack(ask(Command::get, row.pid, more), Nack::format_error);
    if (row.get && !row.get->empty()) expect_nack(ask(Command::get, row.pid), Nack::format_error);
}

TEST_P(Conformance, get_to_everybody_is_not_answered) {
    const Row& row = GetParam();
    for (const Uid& to : {kAll, kAllOfOurs}) {
        const auto reply =
            responder.take(ask(Command::get, row.pid, row.get.value_or(Data{}), to), leave.wants(), kNow);
        EXPECT_FALSE(reply.message.has_value());
    }
}

TEST_P(Conformance, get_of_a_sub_device) {
    const Row& row = GetParam();
    for (const std::uint16_t sub : std::vector<std::uint16_t>{1, 512, kAllSubDevices}) {
        Message to = ask(Command::get, row.pid, row.get.value_or(Data{}));
        to.sub_device = sub;
        expect_nack(to, Nack::sub_device_out_of_range);
    }
}

TEST_P(Conformance, set) {
    const Row& row = GetParam();
    if (!row.set) return expect_nack(ask(Command::set, row.pid, {1}), Nack::unsupported_command);
    const Message to = ask(Command::set, row.pid, *row.set), response = answer(to);
    EXPECT_EQ(response.port_or_answer, static_cast<int>(Answer::ack));
    EXPECT_EQ(response.command, Command::set);
    expect_addressed(response, to);
    if (row.pid == Pid::sensor_value) return;
    EXPECT_TRUE(response.data.empty());
    EXPECT_EQ(leave.changes.size(), 1u) << "the show was asked";
    const Data now = answer(ask(Command::get, row.pid)).data;
    EXPECT_TRUE(std::equal(row.set->begin(), row.set->end(), now.begin())) << "a get brings what was set";
}

TEST_P(Conformance, set_without_leave) {
    const Row& row = GetParam();
    if (!row.set) return not_run("nothing sets it");
    if (row.pid == Pid::sensor_value) return not_run("a reset needs no leave");
    const Message before = answer(ask(Command::get, row.pid));
    const auto reply = responder.take(ask(Command::set, row.pid, *row.set), nobody_may, kNow);
    ASSERT_TRUE(reply.message.has_value());
    EXPECT_EQ(reply.message->data, (Data{0, static_cast<std::uint8_t>(Nack::write_protect)}));
    EXPECT_EQ(answer(ask(Command::get, row.pid)).data, before.data);
}

TEST_P(Conformance, set_of_a_wrong_length) {
    const Row& row = GetParam();
    if (!row.set) return not_run("nothing sets it");
    expect_nack(ask(Command::set, row.pid, Data(kMaxLabelBytes + 1, 1)), Nack::format_error);
    if (row.pid != Pid::device_label) expect_nack(ask(Command::set, row.pid), Nack::format_error);
}

TEST_P(Conformance, out_of_range) {
    const Row& row = GetParam();
    if (row.out_of_range.empty()) return not_run("it has no range");
    for (const Data& data : row.out_of_range)
        expect_nack(ask(row.set ? Command::set : Command::get, row.pid, data), Nack::data_out_of_range);
    EXPECT_TRUE(leave.changes.empty());
}

TEST_P(Conformance, set_to_everybody_is_done_and_not_answered) {
    const Row& row = GetParam();
    if (!row.set) return not_run("nothing sets it");
    for (const Uid& to : {kAll, kAllOfOurs})
        EXPECT_FALSE(responder.take(ask(Command::set, row.pid, *row.set, to), leave.wants(), kNow)
                         .message.has_value());
    EXPECT_EQ(leave.changes.size(), row.pid == Pid::sensor_value ? 0u : 2u);
}

TEST_P(Conformance, set_of_a_sub_device) {
    const Row& row = GetParam();
    for (const std::uint16_t sub : std::vector<std::uint16_t>{1, kAllSubDevices}) {
        Message to = ask(Command::set, row.pid, row.set.value_or(Data{1}));
        to.sub_device = sub;
        expect_nack(to, Nack::sub_device_out_of_range);
    }
}

TEST_P(Conformance, what_is_not_required_is_listed) {
    const Row& row = GetParam();
    const Data list = answer(ask(Command::get, Pid::supported_parameters)).data;
    bool listed = false;
    for (std::size_t i = 0; i + 1 < list.size(); i += 2)
        listed |= (list[i] << 8 | list[i + 1]) == static_cast<int>(row.pid);
    EXPECT_EQ(listed, !row.required);
}

INSTANTIATE_TEST_SUITE_P(Rdm, Conformance, testing::ValuesIn(rows()),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(RdmConformance, unknown_parameters_and_messages_for_others) {
    Responder responder(head());
    Leave leave;
    for (const int pid : {0x0000, 0x0051, 0x0100, 0x7FE0, 0x8000, 0xFFFF}) {
        const auto reply = responder.take(ask(Command::get, static_cast<Pid>(pid)), leave.wants(), kNow);
        ASSERT_TRUE(reply.message.has_value()) << pid;
        EXPECT_EQ(reply.message->data, (Data{0, static_cast<std::uint8_t>(Nack::unknown_pid)})) << pid;
    }
    EXPECT_FALSE(
        responder.take(ask(Command::get, Pid::device_info, {}, {kMaker, 2}), leave.wants(), kNow).message);
    EXPECT_FALSE(
        responder.take(ask(Command::get, Pid::device_info, {}, {0x7FF1, 0xFFFFFFFF}), leave.wants(), kNow)
            .message);
    Message response = ask(Command::get, Pid::device_info);
    response.is_response = true;
    EXPECT_FALSE(responder.take(response, leave.wants(), kNow).message) << "a response is no command";
}

TEST(RdmConformance, without_slots_there_is_no_address) {
    Device device = head();
    device.personalities = {{"Nothing", 0}};
    Responder responder(device);
    Leave leave;
    EXPECT_EQ(responder.take(ask(Command::get, Pid::dmx_start_address), leave.wants(), kNow).message->data,
              (Data{0xFF, 0xFF}));
    EXPECT_EQ(responder.take(ask(Command::set, Pid::dmx_start_address, {0, 1}), leave.wants(), kNow)
                  .message->port_or_answer,
              static_cast<int>(Answer::nack));
}

TEST(RdmConformance, a_personality_ends_within_the_universe) {
    Device device = head();
    device.personalities = {{"Small", 3}, {"Large", 30}};
    device.personality = 1;
    device.start_address = 510;
    Responder responder(device);
    Leave leave;
    const auto large = responder.take(ask(Command::set, Pid::dmx_personality, {2}), leave.wants(), kNow);
    EXPECT_EQ(large.message->port_or_answer, static_cast<int>(Answer::nack));
    EXPECT_EQ(large.message->data, (Data{0, static_cast<std::uint8_t>(Nack::data_out_of_range)}));
    device.start_address = 483;
    Responder there(device);
    EXPECT_EQ(
        there.take(ask(Command::set, Pid::dmx_personality, {2}), leave.wants(), kNow).message->port_or_answer,
        static_cast<int>(Answer::ack));
}

TEST(RdmConformance, labels_end_at_32_bytes) {
    Device device = head();
    device.label = device.model_name = std::string(100, 'x');
    Responder responder(device);
    Leave leave;
    for (const Pid pid : {Pid::device_label, Pid::device_model_description})
        EXPECT_EQ(responder.take(ask(Command::get, pid), leave.wants(), kNow).message->data.size(), 32u);
    EXPECT_EQ(responder.take(ask(Command::set, Pid::device_label, Data(32, 'y')), leave.wants(), kNow)
                  .message->port_or_answer,
              0);
    EXPECT_EQ(
        responder.take(ask(Command::set, Pid::device_label), leave.wants(), kNow).message->port_or_answer, 0)
        << "an empty one is one";
    device.label = std::string(31, 'x') + "\xC3\xBC"; // a letter of two bytes
    Responder cut(device);
    EXPECT_EQ(cut.take(ask(Command::get, Pid::device_label), leave.wants(), kNow).message->data,
              Data(31, 'x'));
}

// More than one message holds: the rest comes with the next GET (6.3.2).
TEST(RdmConformance, an_answer_that_does_not_fit_comes_in_parts) {
    Device device = head();
    device.slots.assign(120, {0x0001, false, "Dimmer"});
    Responder responder(device);
    Leave leave;
    Data all;
    int parts = 0;
    for (bool more = true; more && parts < 10; ++parts) {
        const auto reply = responder.take(ask(Command::get, Pid::slot_info), leave.wants(), kNow);
        ASSERT_TRUE(reply.message.has_value());
        all.insert(all.end(), reply.message->data.begin(), reply.message->data.end());
        more = reply.message->port_or_answer == static_cast<int>(Answer::ack_overflow);
    }
    EXPECT_EQ(parts, 3);
    ASSERT_EQ(all.size(), 600u);
    EXPECT_EQ((Data{all.end() - 5, all.end()}), (Data{0, 119, 0, 0, 1}));
    EXPECT_EQ(responder.take(ask(Command::get, Pid::slot_info), leave.wants(), kNow).message->port_or_answer,
              static_cast<int>(Answer::ack_overflow))
        << "and begins anew";
}

// Two controllers and a device whose slots need three messages.
struct LongAnswer {
    Device device = head();
    std::optional<Responder> responder;
    std::chrono::nanoseconds now = kNow;
    Leave leave;

    LongAnswer() {
        device.slots.assign(120, {0x0001, false, "Dimmer"});
        responder.emplace(device);
    }
    Message get(std::uint32_t controller, Pid pid = Pid::slot_info) {
        Message message = ask(Command::get, pid);
        message.from.device = controller;
        return responder->take(message, leave.wants(), now).message.value_or(Message{});
    }
    // The first slot that the answer tells.
    int slot(std::uint32_t controller) {
        const Data data = get(controller).data;
        return data.size() > 1 ? data[0] << 8 | data[1] : -1;
    }
};

TEST(RdmConformance, the_parts_of_an_answer_are_each_controllers_own) {
    LongAnswer of;
    const Message first = of.get(1), other = of.get(2);
    EXPECT_EQ(other.port_or_answer, static_cast<int>(Answer::ack_overflow));
    EXPECT_EQ(other.data, first.data) << "from the beginning";
    Data one = first.data, two = other.data;
    for (int part = 0; part < 2; ++part)
        for (const std::uint32_t controller : {1u, 2u}) {
            const Data more = of.get(controller).data;
            Data& all = controller == 1 ? one : two;
            all.insert(all.end(), more.begin(), more.end());
        }
    EXPECT_EQ(one.size(), 600u);
    EXPECT_EQ(two, one);
}

TEST(RdmConformance, who_repeats_what_was_lost_gets_it_from_the_beginning) {
    LongAnswer of;
    EXPECT_EQ(of.slot(1), 0);
    of.now += kPartsWait - std::chrono::milliseconds(1);
    EXPECT_NE(of.slot(1), 0);
    of.now += kPartsWait;
    EXPECT_EQ(of.slot(1), 0);
    (void)of.get(1, Pid::device_label);
    EXPECT_EQ(of.slot(1), 0) << "another question ended it";
}

TEST(RdmConformance, of_another_mode_no_rest_is_told) {
    LongAnswer of;
    EXPECT_EQ(of.slot(1), 0);
    of.responder->update(of.device);
    EXPECT_NE(of.slot(1), 0) << "it is as it was";
    EXPECT_EQ(of.get(1).port_or_answer, static_cast<int>(Answer::ack)) << "the last part";
    EXPECT_EQ(of.slot(1), 0);
    of.device.slots.resize(100);
    of.responder->update(of.device);
    EXPECT_EQ(of.slot(1), 0);
    (void)of.responder->take(ask(Command::set, Pid::dmx_personality, {2}), of.leave.wants(), of.now);
    EXPECT_EQ(of.slot(1), 0);
}

TEST(RdmConformance, so_many_controllers_read_in_parts_and_no_more) {
    LongAnswer of;
    for (std::uint32_t controller = 0; controller <= kMostInParts; ++controller)
        EXPECT_EQ(of.slot(controller), 0);
    for (std::uint32_t controller = 1; controller <= kMostInParts; ++controller)
        EXPECT_NE(of.slot(controller), 0) << controller;
    EXPECT_EQ(of.slot(0), 0) << "the oldest gave way";
}

TEST(RdmConformance, what_somebody_else_changed_is_queued) {
    Responder responder(head());
    Leave leave;
    const auto get = [&](std::uint8_t kind) {
        return *responder.take(ask(Command::get, Pid::queued_message, {kind}), leave.wants(), kNow).message;
    };
    Device changed = head();
    changed.start_address = 101;
    responder.update(changed);
    changed.start_address = 102;
    changed.label = "Moved";
    responder.update(changed);
    EXPECT_EQ(responder.take(ask(Command::get, Pid::device_info), leave.wants(), kNow).message->queued, 2);
    const Message first = get(4), again = get(1), second = get(4), last = get(4);
    EXPECT_EQ(first.pid, static_cast<int>(Pid::dmx_start_address));
    EXPECT_EQ(first.data, (Data{0, 102})) << "the newest of it, once";
    EXPECT_EQ(first.queued, 1);
    EXPECT_EQ(again.data, first.data) << "the last message again";
    EXPECT_EQ(second.data, label("Moved"));
    EXPECT_EQ(last.pid, static_cast<int>(Pid::status_messages));
    EXPECT_TRUE(last.data.empty());
    // Who sets it is not told.
    (void)responder.take(ask(Command::set, Pid::dmx_start_address, {0, 7}), leave.wants(), kNow);
    changed.start_address = 7;
    responder.update(changed);
    EXPECT_EQ(get(4).pid, static_cast<int>(Pid::status_messages));
    // What somebody else had set before is no news any more.
    changed.start_address = 200;
    responder.update(changed);
    (void)responder.take(ask(Command::set, Pid::dmx_start_address, {0, 77}), leave.wants(), kNow);
    EXPECT_EQ(get(4).pid, static_cast<int>(Pid::status_messages));
}

TEST(RdmConformance, sensors_remember_their_extremes_until_they_are_reset) {
    Responder responder(head());
    Leave leave;
    Device device = head();
    for (const int value : {-500, 900, 100}) {
        device.sensors[0].value = static_cast<std::int16_t>(value);
        responder.update(device);
    }
    const auto value = [&] {
        return responder.take(ask(Command::get, Pid::sensor_value, {0}), leave.wants(), kNow).message->data;
    };
    EXPECT_EQ(value(), (Data{0, 0, 100, 0xFE, 0x0C, 3, 0x84, 0, 0}));
    EXPECT_EQ(responder.take(ask(Command::set, Pid::sensor_value, {0xFF}), leave.wants(), kNow).message->data,
              (Data{0xFF, 0, 0, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(value(), (Data{0, 0, 100, 0, 100, 0, 100, 0, 0}));
}

Data between(const Uid& low, const Uid& high) {
    Data data;
    for (const Uid& uid : {low, high})
        for (int shift = 40; shift >= 0; shift -= 8)
            data.push_back(static_cast<std::uint8_t>(uid.number() >> shift));
    return data;
}

TEST(RdmConformance, mute_and_unmute) {
    Responder responder(head());
    Leave leave;
    const Message branch =
        ask(Command::discovery, Pid::disc_unique_branch, between({0, 0}, {0xFFFF, 0xFFFFFFFE}), kAll);
    EXPECT_EQ(parse_discovery_answer(responder.take(branch, leave.wants(), kNow).discovery),
              (Uid{kMaker, 1}));
    const Message mute = ask(Command::discovery, Pid::disc_mute);
    const auto muted = responder.take(mute, leave.wants(), kNow);
    ASSERT_TRUE(muted.message.has_value());
    EXPECT_EQ(muted.message->data, (Data{0, 0})) << "control field: no proxy, no sub-devices";
    EXPECT_EQ(muted.message->command, Command::discovery);
    EXPECT_TRUE(responder.take(branch, leave.wants(), kNow).discovery.empty());
    EXPECT_FALSE(
        responder.take(ask(Command::discovery, Pid::disc_un_mute, {}, kAll), leave.wants(), kNow).message);
    EXPECT_FALSE(responder.muted());
    EXPECT_FALSE(
        responder.take(ask(Command::discovery, Pid::disc_mute, {}, kAll), leave.wants(), kNow).message);
    EXPECT_TRUE(responder.muted()) << "of everybody, too, but not answered";
    EXPECT_TRUE(
        responder.take(ask(Command::discovery, Pid::disc_un_mute), leave.wants(), kNow).message.has_value());
    EXPECT_FALSE(responder.take(ask(Command::discovery, Pid::disc_mute, {1}), leave.wants(), kNow).message)
        << "wrong length";
    EXPECT_FALSE(responder.muted());
}

TEST(RdmConformance, discovery_answers_to_its_branch_only) {
    Responder responder(head(5));
    Leave leave;
    const auto answers = [&](const Uid& low, const Uid& high, const Uid& to = kAll) {
        Message message = ask(Command::discovery, Pid::disc_unique_branch, between(low, high), to);
        return !responder.take(message, leave.wants(), kNow).discovery.empty();
    };
    EXPECT_TRUE(answers({kMaker, 5}, {kMaker, 5}));
    EXPECT_TRUE(answers({kMaker, 0}, {kMaker, 5}));
    EXPECT_FALSE(answers({kMaker, 6}, {kMaker, 9}));
    EXPECT_FALSE(answers({kMaker, 0}, {kMaker, 4}));
    EXPECT_FALSE(answers({kMaker, 9}, {kMaker, 0})) << "ends exchanged";
    EXPECT_FALSE(answers({kMaker, 0}, {kMaker, 9}, {kMaker, 5})) << "of one device only";
    EXPECT_TRUE(answers({kMaker, 0}, {kMaker, 9}, kAllOfOurs));
    Message cut = ask(Command::discovery, Pid::disc_unique_branch, Data(11), kAll);
    EXPECT_TRUE(responder.take(cut, leave.wants(), kNow).discovery.empty());
}

// A line of many: what answers at once is one or, as the wires have it.
TEST(RdmConformance, a_controller_finds_all_of_400_by_halves) {
    std::vector<Responder> line;
    std::set<Uid> there;
    for (std::uint32_t i = 0; i < 400; ++i) {
        line.emplace_back(head(i * 2654435761u % 0xFFFFFFFEu));
        there.insert(line.back().device().uid);
    }
    ASSERT_EQ(there.size(), 400u);
    Leave leave;
    std::set<Uid> found;
    std::size_t asked = 0;
    const auto send = [&](const Message& message) {
        Data wire;
        for (Responder& one : line) {
            const Data answer = one.take(message, leave.wants(), kNow).discovery;
            wire.resize(std::max(wire.size(), answer.size()));
            for (std::size_t i = 0; i < answer.size(); ++i) wire[i] |= answer[i];
        }
        ++asked;
        return wire;
    };
    const std::function<void(std::uint64_t, std::uint64_t)> search = [&](std::uint64_t low,
                                                                         std::uint64_t high) {
        for (;;) {
            const Data wire = send(
                ask(Command::discovery, Pid::disc_unique_branch, between(Uid::of(low), Uid::of(high)), kAll));
            if (wire.empty()) return;
            const auto one = parse_discovery_answer(wire);
            if (one && there.contains(*one)) {
                (void)send(ask(Command::discovery, Pid::disc_mute, {}, *one));
                found.insert(*one);
                continue;
            }
            ASSERT_LT(low, high);
            const std::uint64_t middle = low + (high - low) / 2;
            search(low, middle);
            return search(middle + 1, high);
        }
    };
    search(0, 0xFFFFFFFFFFFEull);
    EXPECT_EQ(found, there);
    EXPECT_LT(asked, 4000u);
}

} // namespace
} // namespace ghost::rdm
