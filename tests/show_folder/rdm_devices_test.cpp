// SPDX-License-Identifier: Apache-2.0
#include "show_folder/rdm_devices.h"

#include "show/show.h"
#include "support/explain_trial.h"

#include <set>

namespace ghost::scene {
namespace {

Show heads(int count) {
    Show show;
    for (int i = 0; i < count; ++i) {
        PatchedFixture fixture;
        fixture.name = "Head " + std::to_string(i + 1);
        fixture.type = trial::type_of(trial::kDimmer + trial::simple("2,3", "Pan", -270, 270) +
                                      trial::simple("4", "ColorSub_C", 0, 1));
        fixture.universe = 3;
        fixture.address = 1 + 4 * i;
        show.fixtures.push_back(fixture);
    }
    return show;
}

TEST(RdmDevices, what_a_fixture_says_of_itself) {
    Show show = heads(1);
    std::vector<fixture::State> states(1);
    states[0].pan_deg = -12.34f;
    const std::vector<RdmFixture> devices = rdm_devices(show, states);
    ASSERT_EQ(devices.size(), 1u);
    const rdm::Device& device = devices[0].device;
    EXPECT_EQ(device.universe, 3);
    EXPECT_EQ(device.start_address, 1);
    EXPECT_EQ(device.footprint(), 4);
    EXPECT_EQ(device.label, "Head 1");
    ASSERT_EQ(device.slots.size(), 4u);
    EXPECT_EQ(device.slots[0].label, 0x0001);
    EXPECT_EQ(device.slots[1].label, 0x0101);
    EXPECT_EQ(device.slots[1].name, "Pan");
    EXPECT_TRUE(device.slots[2].fine);
    EXPECT_EQ(device.slots[2].label, 1) << "the slot that it refines";
    EXPECT_EQ(device.slots[3].label, 0x0202);
    ASSERT_EQ(device.sensors.size(), 1u);
    EXPECT_EQ(device.sensors[0].value, -123);
    EXPECT_EQ(device.sensors[0].least, -2700);
    EXPECT_EQ(device.sensors[0].most, 2700);
}

TEST(RdmDevices, uids_are_distinct_and_stay_what_they_are) {
    const Show show = heads(400);
    std::set<rdm::Uid> uids;
    for (const RdmFixture& one : rdm_devices(show)) uids.insert(one.device.uid);
    EXPECT_EQ(uids.size(), 400u);
    // Others may come and go, and addresses change.
    Show other = heads(3);
    other.fixtures.erase(other.fixtures.begin());
    other.fixtures[1].address = 100;
    const auto before = rdm_devices(heads(3)), after = rdm_devices(other);
    EXPECT_EQ(after[0].device.uid, before[1].device.uid);
    EXPECT_EQ(after[1].device.uid, before[2].device.uid);
    // Several of one name; by the plot's id where there is one.
    for (PatchedFixture& fixture : other.fixtures) fixture.name = "Spot";
    const auto twins = rdm_devices(other);
    EXPECT_NE(twins[0].device.uid, twins[1].device.uid);
    other.fixtures[0].uuid = "a";
    const rdm::Uid by_id = rdm_devices(other)[0].device.uid;
    other.fixtures[0].name = "Renamed";
    EXPECT_EQ(rdm_devices(other)[0].device.uid, by_id);
}

TEST(RdmDevices, only_what_is_patched_and_known) {
    Show show = heads(3);
    show.fixtures[0].address = 0;
    show.fixtures[1].type = nullptr;
    const auto devices = rdm_devices(show);
    ASSERT_EQ(devices.size(), 1u);
    EXPECT_EQ(devices[0].fixture, 2u);
}

} // namespace
} // namespace ghost::scene
