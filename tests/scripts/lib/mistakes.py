# SPDX-License-Identifier: Apache-2.0
"""The table of mistakes: what somebody got wrong between a desk and a picture, how that is staged, and what must be said. Used by
mistakes_test.py.

A row: (name, what was done wrong, set-up, what must be named, words that its sentence must have). Named is a finding of `monitor`
(diagnose/diagnosis.h) or, with "explain:", a cause of `explain` (diagnose/explain.h); "error:" is an exit with a message.
Set-up: keys of STANDARD below that differ."""
OPEN = {1: 255, 2: 128, 4: 128, 12: 255, 17: 255}  # a VL2500 Spot at address 1: full, straight down, wide, iris open

STANDARD = {
    "fixtures": [("Spot", 1, 1)],  # name, universe, address; another kind than the VL2500 Spot
    "toml": "",  # at the end of show.toml
    "send": None,  # senders; None: one sACN source of universe 1, all open
    "options": [],  # of ghostlight
    "desk": [],  # commands (ip) in the desk's namespace
    "vis": [],  # and in ours
    "vis_sysctl": [],  # there, of net.ipv4.conf
    "desk_later": None,  # (seconds, commands) in the desk's namespace
    "other": None,  # another program on our machine: (port, shares it)
    "show": None,  # None: live; else frames of a recording, explained only
    "gdtf": None,  # another file of the fixtures
    "firewall": False,
    "firewall_after_s": None,
    "ola": None,  # OLA (real_desks.ola)
    "qlc": None,  # QLC+ (real_desks.qlc)
    "at_s": 0.1,  # of it
    "patience_s": 0,  # after the finding was named first: its words may come later, for they need more looks
    "once": False,  # it happens while somebody looks: who comes later sees something else
    "in_window": True,  # the window says the same
}


def sacn(universe=1, levels=None, **more):
    return {"protocol": "sacn", "universe": universe, "levels": OPEN if levels is None else levels, **more}


def artnet(port_address=0, levels=None, **more):
    return {"protocol": "artnet", "universe": port_address, "levels": OPEN if levels is None else levels, **more}


def with_levels(**changes):
    return {"send": [sacn(levels={**OPEN, **{int(key[1:]): value for key, value in changes.items()}})]}


def on_universes(first, last):
    """A Spot on the first, and one lamp on each of the others."""
    return [("Spot" if universe == first else f"Lamp {universe}", universe, 1) for universe in range(first, last + 1)]


SILENT = []
MISTAKES = [
    # The cable and the network.
    ("cable", "the cable is pulled, or the switch is off", {"desk": ["link set to_net0 down"], "options": ["--interface", "net0"]}, "cable",
     ["net0 has no cable"]),
    ("cable_and_address", "the cable is pulled, and the address of the DHCP server went with it", {
        "vis": ["addr del 10.93.0.2/24 dev net0"], "desk": ["link set to_net0 down"], "options": ["--interface", "net0"]}, "cable",
     ["net0 has no cable"]),
    ("cable_of_two", "the cable of one of two cards is pulled, and the desk is there", {"desk": ["link set to_net0 down"]}, "nothing_arrives",
     ["net0 (10.93.0.2/24, no cable)"]),
    ("output_off", "the desk's output is off", {"send": SILENT}, "nothing_arrives", ["desk's output", "firewall"]),
    ("firewall", "a firewall drops UDP 5568 and 6454", {"firewall": True}, "nothing_arrives", ["firewall on UDP 5568 and 6454", "tcpdump"]),
    ("no_address", "our card has no IPv4 address: no DHCP server answers", {"vis": ["addr del 10.93.0.2/24 dev net0"]}, "nothing_arrives",
     ["net0 has a cable and no IPv4 address", "DHCP"]),
    ("own_address", "no DHCP server answers, and our machine gives itself an address", {
        "vis": ["addr del 10.93.0.2/24 dev net0", "addr add 169.254.3.4/16 brd + dev net0"], "send": [artnet()]}, "nothing_arrives",
     ["net0 gave itself 169.254.3.4", "DHCP"]),
    ("vlan", "the desk's port of the switch is tagged for another VLAN", {"desk": ["link set to_net0 nomaster"]}, "nothing_arrives", ["is it in this network"]),
    ("mask_of_ours", "our mask is 255.255.255.0, the desk broadcasts Art-Net to 10.255.255.255", {"desk": ["addr add 10.93.0.9/8 brd + dev br0"], "send": [artnet(to="10.255.255.255")]},
     "nothing_arrives", ["10.255.255.255", "10.93.0.255", "mask"]),
    ("desk_in_2", "the desk is in 2.x.x.x and broadcasts there, we are in 10.x.x.x with the mask 255.0.0.0",
     {"vis": ["addr del 10.93.0.2/24 dev net0", "addr add 10.93.0.2/8 brd + dev net0"], "desk": ["addr add 2.0.0.1/8 brd + dev br0"],
      "send": [artnet(to="2.255.255.255")]}, "nothing_arrives", ["broadcasts to 2.255.255.255", "mask"]),
    ("other_network", "the desk sends Art-Net from a network that ours cannot answer",
     {"desk": ["addr add 10.77.0.1/24 dev br0"], "send": [artnet(to="10.93.0.2", bind="10.77.0.1")]}, "other_network", ["10.77.0.1", "another network"]),
    ("wrong_interface", "--interface names the wrong network card", {"options": ["--interface", "net1"]}, "wrong_interface",
     ["'Test desk' (10.93.0.1)", "net0", "--interface net0"]),
    ("wrong_interface_and_universe", "the same, and the desk sends another universe than the show's", {"options": ["--interface", "net1"], "send": [artnet(1)]}, "wrong_interface",
     ["10.93.0.1 (Art-Net) sends universe 2", "net0", "--interface net0"]),
    ("no_such_interface", "--interface is misspelt", {"options": ["--interface", "nte0"]}, "error:", ["no network interface 'nte0'", "net0"]),
    ("igmp", "a switch with IGMP snooping and no querier holds the universe's multicast back, its lists still come",
     {"send": [sacn(levels={}, announces=[1], silent=True)]}, "held_back", ["announces universe 1", "IGMP snooping", "unicast"]),
    ("igmp_and_others", "the same, and somebody's Art-Net cannot be read",
     {"send": [sacn(levels={}, announces=[1], silent=True), artnet(version=13)]}, "held_back", ["announces universe 1", "IGMP snooping"]),
    ("reverse_path", "the desk is in another network, and this machine's reverse path filter is strict",
     {"desk": ["addr add 10.77.0.1/24 dev br0"], "vis_sysctl": ["all.rp_filter=1", "net0.rp_filter=1"],
      "send": [sacn(bind="10.77.0.1")]}, "nothing_arrives",
     ["The reverse path filter of this machine dropped", "give that card an address in the desk's network"]),
    ("cable_at_last", "the cable is pulled while we look", {"once": True, "desk_later": (6, ["link set to_net0 down"])}, "lost",
     ["nothing comes for universe 1 any more", "net0: cable pulled"]),
    ("bytes_exchanged", "a sender writes universe numbers in the wrong order of bytes, and announces them in the right one",
     {"send": [sacn(256, to="239.255.0.1", announces=[1])]}, "not_patched", ["the show wants universe 1", "256 is 1 with its two bytes exchanged"]),
    ("other_group", "sACN of universe 1 to the multicast group of universe 2", {"send": [sacn(to="239.255.0.2")]}, "wrong_group", ["multicast group"]),
    # Universes.
    ("sacn_one_off", "sACN, universe one too high", {"send": [sacn(2)]}, "off_by_one", ["sACN comes for universe 2", "universe 1"]),
    ("sacn_elsewhere", "sACN on universe 7", {"send": [sacn(7)]}, "not_patched", ["universe 7 arrive", "the show wants universe 1"]),
    ("sacn_far", "sACN on universe 300, announced", {"send": [sacn(300, announces=[300])]}, "not_patched", ["universe 300", "the show wants universe 1"]),
    ("announced_elsewhere", "sACN of universe 300 by unicast to another machine", {"send": [sacn(300, announces=[300], silent=True)]}, "not_patched",
     ["announces universe 300", "the show wants universe 1"]),
    ("artnet_one_off", "Art-Net counted from 1", {"send": [artnet(1)]}, "off_by_one", ["Art-Net comes for universe 2", "--artnet-offset 0"]),
    ("artnet_swapped", "Sub-Net and Universe exchanged", {"fixtures": [("Spot", 17, 1)], "send": [artnet(256)]}, "not_patched",
     ["1:0:0", "0:1:0", "another order"]),
    ("artnet_net", "Art-Net on Net 3", {"send": [artnet(0x300)]}, "not_patched", ["universe 769", "the show wants universe 1"]),
    ("artnet_net_of_four", "the desk is on Net 0, the show on Net 1, four universes each", {"fixtures": on_universes(257, 260), "send": [artnet(k) for k in range(4)]},
     "not_patched", ["Net:Sub-Net:Universe 0:0:0, the show wants 1:0:0: another Net"]),
    ("four_off", "Art-Net on universes 5 to 8 instead of 1 to 4", {"fixtures": on_universes(1, 4), "send": [artnet(k) for k in range(4, 8)]}, "not_patched",
     ["universes 5-8 arrive", "the show wants universes 1-4"]),
    ("one_output_off", "a desk of eight universes does not send the first one", {"fixtures": on_universes(1, 4), "send": [sacn(k) for k in range(2, 9)]}, "off_by_one",
     ["either nothing is sent for universe 1 or it does not get here", "or all of them are one off"]),
    ("one_output_stops", "the same, and it did until now", {"once": True, "fixtures": on_universes(1, 4), "send": [sacn(stops_s=8)] + [sacn(k) for k in range(2, 9)]}, "lost",
     ["nothing comes for universe 1 any more", "'Test desk' (10.93.0.1) is heard all the while"]),
    ("one_of_two", "only the first of two universes is sent", {"fixtures": [("Spot", 4, 1), ("Far", 9, 1)], "send": [sacn(9)]}, "not_received",
     ["1 fixture on universe 4", "'Spot'"]),
    # What the desk says.
    ("blind", "the desk is in blind: all packets are marked preview", {"send": [sacn(options=0x80)]}, "preview", ["'Test desk'", "leave blind", "--show-preview"]),
    ("goes_blind", "the desk goes blind while we look", {"once": True, "send": [sacn(blind_after_s=6)]}, "preview", ["'Test desk'", "leave blind"]),
    ("goes_bad", "the desk's priority becomes one that does not exist while we look", {"once": True, "send": [sacn(bad_after_s=6)]}, "lost",
     ["nothing comes for universe 1 any more", "cannot be read", "bad_priority"]),
    ("one_unreadable", "one of two universes comes with a priority that does not exist",
     {"fixtures": [("Spot", 4, 1), ("Far", 9, 1)], "send": [sacn(9), sacn(4, priority=250, cid=2)]}, "not_received",
     ["1 fixture on universe 4", "no levels arrive there", "bad_priority"]),
    ("ended", "all packets say that their stream has ended", {"send": [sacn(options=0x40)]}, "nothing_arrives", ["without levels"]),
    ("protocol_off", "we listen to Art-Net alone, and the desk sends sACN", {"options": ["--protocols", "artnet"]}, "nothing_arrives",
     ["sACN is not listened for (--protocols)"]),
    ("low_priority", "the backup has the lower priority, and somebody waits for it",
     {"send": [sacn(), sacn(priority=90, name="Backup", cid=2)]}, "low_priority", ["'Backup'", "priority 90", "'Test desk'", "priority 100"]),
    ("two_desks", "two desks of equal priority send different looks",
     {"send": [sacn(), sacn(levels={1: 10, 6: 255}, name="Second", cid=2)]}, "two_desks", ["'Test desk'", "'Second'", "HTP"]),
    ("forgotten", "a forgotten desk of equal priority has all up, and the main desk's chase is not seen",
     {"once": True, "patience_s": 20, "send": [sacn(levels={**OPEN, 1: 0}, chases=[1, 2, 4, 12]), sacn(levels=dict.fromkeys(range(1, 23), 255), name="Forgotten", cid=2)]}, "two_desks",
     ["'Test desk'", "'Forgotten'", "Switch one off"]),
    ("out_of_step", "two desks of equal priority run one chase half a second apart",
     {"once": True, "patience_s": 20, "send": [sacn(levels={}, chases=[1, 2, 4, 12]), sacn(levels={}, chases=[1, 2, 4, 12], chase_begins=20, name="Second", cid=2)]}, "two_desks",
     ["'Test desk'", "'Second'", "4 channels up at different times", "it is out of step"]),
    ("outranked_of_three", "of three desks the middle one is outranked by the highest, and the lowest alone sends all channels",
     {"send": [sacn(priority=150, name="House", slots=100), sacn(name="Main", cid=2, slots=100), sacn(levels={1: 9}, priority=50, name="LX", cid=3)]}, "low_priority",
     ["'Main' (10.93.0.1) (priority 100) is not shown", "'House' (10.93.0.1) (priority 150) has a higher priority"]),
    ("given_away", "a desk gives all channels away by priority per address, and nobody else sends them", {"send": [sacn(per_address=0)]},
     "bad_priorities", ["'Test desk' (10.93.0.1)", "22 of 22 patched channels on universe 1", "nobody else sends them"]),
    ("dark_above", "a desk of higher priority has all dimmers at 0 and hides the look",
     {"send": [sacn(priority=50, name="Show", cid=2), sacn(levels={**OPEN, 1: 0})]}, "low_priority",
     ["'Show' (10.93.0.1) (priority 50) is not shown", "has a higher priority, and has all dimmers at 0"]),
    ("per_address_low", "the backup's priority is 150, but that of each address is 50",
     {"send": [sacn(), sacn(priority=150, name="Backup", cid=2, per_address=50)]}, "low_priority",
     ["'Backup' (10.93.0.1) (priority 50 at most, one for each address)", "'Test desk' (10.93.0.1) (priority 100)"]),
    ("one_cid", "the backup is a copy of the main desk's disk: two machines with one CID",
     {"send": [sacn(), sacn(levels={1: 10}, bind="10.93.0.11", first_number=100)], "desk": ["addr add 10.93.0.11/24 dev br0"]}, "same_identity",
     ["one identity (CID) on universe 1", "'Test desk' (10.93.0.1)", "10.93.0.11"]),
    ("started_twice", "the desk's program was started twice, with one CID", {"send": [sacn(), sacn(levels={1: 10}, first_number=100)]}, "same_identity",
     ["'Test desk' (10.93.0.1)", "two rows of numbers", "two programs"]),
    ("started_behind", "the same, and its numbers are 5 behind", {"send": [sacn(), sacn(levels={1: 10}, first_number=251)]}, "same_identity",
     ["'Test desk' (10.93.0.1)", "two rows of numbers"]),
    ("started_half_way", "the same, and its numbers are 128 apart", {"send": [sacn(), sacn(levels={1: 10}, first_number=128)]}, "same_identity",
     ["'Test desk' (10.93.0.1)", "two rows of numbers"]),
    ("started_slow", "the same, and the second sends ten times a second", {"send": [sacn(), sacn(levels={1: 10}, every=4)]}, "same_identity",
     ["'Test desk' (10.93.0.1)", "two rows of numbers"]),
    ("started_moving", "the same, and both looks move", {"send": [sacn(moves=[30, 31]), sacn(levels={1: 10}, moves=[60], first_number=7)]}, "same_identity",
     ["'Test desk' (10.93.0.1)", "two rows of numbers"]),
    ("artnet_twice", "two programs of one machine send Art-Net with numbers", {"send": [artnet(), artnet(levels={1: 10}, first_number=5)]}, "same_identity",
     ["10.93.0.1 (Art-Net)", "two rows of numbers", "an address"]),
    ("started_together", "the desk's program was started twice, with one CID and numbers in step", {"send": [sacn(), sacn(levels={1: 10})]}, "same_identity",
     ["'Test desk' (10.93.0.1)", "two programs", "gives two packets one number"]),
    ("unnumbered_twice", "two programs of one machine send Art-Net without numbers", {"send": [artnet(unnumbered=True), artnet(levels={1: 10}, unnumbered=True)]},
     "same_identity", ["10.93.0.1 (Art-Net)", "by turns from the ports", "two programs", "one by two sockets"]),
    ("unnumbered_moving", "the same, and the looks move", {"send": [artnet(unnumbered=True, moves=[30]), artnet(levels={1: 10}, unnumbered=True, moves=[60])]},
     "same_identity", ["10.93.0.1 (Art-Net)", "by turns from the ports"]),
    ("numbered_and_not", "two programs of one machine send Art-Net by one port, one of them without numbers",
     {"send": [artnet(port=6460), artnet(levels={1: 10}, unnumbered=True, port=6460)]}, "same_identity", ["10.93.0.1 (Art-Net)", "one of them without any"]),
    ("forgotten_colour", "a forgotten desk of equal priority has its dimmers at 0 and all colour filters in",
     {"send": [sacn(), sacn(levels={6: 255, 7: 255, 8: 255}, name="Forgotten", cid=2)]}, "two_desks",
     ["'Forgotten' (10.93.0.1) has all dimmers at 0, and raises up to 3 channels"]),
    ("two_alike", "two desks of one name on one machine send different looks", {"send": [sacn(), sacn(levels={1: 10, 6: 255}, cid=2)]}, "two_desks",
     ["'Test desk' (10.93.0.1, CID 0101", "'Test desk' (10.93.0.1, CID 0202"]),
    ("both_ways", "a desk sends sACN and Art-Net, and its Art-Net is another universe's look", {"send": [sacn(), artnet(levels={1: 10, 6: 255})]}, "two_desks",
     ["10.93.0.1 sends by sACN and by Art-Net"]),
    # Which two have the places is chance: the window may say others.
    ("physicals", "an Art-Net sender that changes its Physical field", {"send": [artnet(physicals=[0, 1, 2])], "in_window": False}, "too_many",
     ["10.93.0.1", "names more than one Physical"]),
    ("priorities_255", "priorities per address of 255", {"send": [sacn(per_address=255)]}, "bad_priorities", ["'Test desk' (10.93.0.1)", "above 200"]),
    ("short_priorities", "priorities per address for the first 22 channels alone", {"fixtures": [("Spot", 1, 100)], "send": [sacn(per_address=100, per_address_count=22)]},
     "bad_priorities", ["512 levels on universe 1", "for 22 alone"]),
    ("no_answers", "--no-poll-reply, and the sender asks who wants its Art-Net", {"options": ["--no-poll-reply"], "send": [artnet(polls=True, silent=True)]},
     "nothing_arrives", ["ArtPoll", "--no-poll-reply"]),
    ("two_timecodes", "two machines send time code", {"send": [sacn(timecode=10), sacn(cid=3, timecode=11, silent=True, bind="10.93.0.11")],
                                                       "desk": ["addr add 10.93.0.11/24 dev br0"]}, "two_timecodes", ["10.93.0.1 ", "10.93.0.11"]),
    ("hidden_black_out", "a desk that was switched off by nobody goes on sending its look, and the other one's black-out is not seen",
     {"send": [sacn(levels={}, name="FOH"), sacn(name="Backup", cid=2)]}, "two_desks", ["'FOH' (10.93.0.1) sends 0 alone", "black-out"]),
    ("hidden_dimmers", "the same, and the black-out leaves the colours as they are",
     {"send": [sacn(levels={**OPEN, 1: 0}, name="FOH"), sacn(name="Backup", cid=2)]}, "two_desks", ["'FOH' (10.93.0.1) has all dimmers at 0", "black-out"]),
    ("priorities_alone", "only priorities per address come, no levels", {"send": [sacn(per_address=100, priorities_alone=True)]}, "nothing_arrives",
     ["'Test desk' (10.93.0.1) on universe 1", "only priorities per address"]),
    ("no_slots", "Art-Net packets without a single level", {"send": [artnet(levels={}, slots=0)]}, "nothing_arrives",
     ["10.93.0.1 (Art-Net) on universe 1", "packets without a single level"]),
    ("number_stands", "a sender whose sequence number stands still", {"send": [sacn(number=7)]}, "numbering", ["'Test desk' (10.93.0.1)", "stands still"]),
    ("artnet_number_stands", "Art-Net, and the sequence number stands still at 7", {"send": [artnet(number=6)]}, "numbering", ["10.93.0.1 (Art-Net)", "stands still"]),
    ("three_artnet", "a third Art-Net desk on one universe", {"send": [artnet(), artnet(bind="10.93.0.11"), artnet(bind="10.93.0.12")],
                                                               "desk": ["addr add 10.93.0.11/24 dev br0", "addr add 10.93.0.12/24 dev br0"]},
     "too_many", ["Art-Net merges two"]),
    ("seventeen", "more sACN sources on a universe than are merged", {"send": [sacn(cid=i, name=f"Desk {i}") for i in range(1, 18)]}, "too_many",
     ["16 are merged"]),
    ("sync_stops", "synchronisation packets stop", {"once": True, "send": [sacn(sync=10, sync_stops_s=6)]}, "waits_for_sync", ["wait for a synchronisation packet"]),
    ("crash", "the desk crashes", {"once": True, "send": [sacn(stops_s=6)]}, "lost", ["nothing comes for universe 1 any more"]),
    ("output_moved", "the desk's output is moved to another universe while we look",
     {"once": True, "patience_s": 10, "send": [sacn(moves_after_s=6, moves_to=9)]}, "lost", ["'Test desk' (10.93.0.1) is heard all the while", "universe 9"]),
    ("crash_announced", "a desk that announces its universe crashes", {"once": True, "send": [sacn(stops_s=6, announces=[1])]}, "lost",
     ["nothing comes for universe 1 any more"]),
    ("goodbye_announced", "a desk that announces its universe is closed", {"once": True, "send": [sacn(stops_s=6, goodbye=True, announces=[1])]}, "lost",
     ["said that it ends this stream"]),
    ("goodbye", "the desk switches its output off while we look", {"once": True, "send": [sacn(stops_s=6, goodbye=True)]}, "lost",
     ["nothing comes for universe 1 any more", "said that it ends this stream"]),
    ("priority_250", "a sender with a priority that does not exist", {"send": [sacn(priority=250)]}, "nothing_arrives", ["bad_priority"]),
    ("old_artnet", "a sender of an Art-Net version that is none", {"send": [artnet(version=13)]}, "nothing_arrives", ["bad_version"]),
    ("garbage", "another protocol on the port of sACN", {"send": [sacn(garbage=True)]}, "nothing_arrives", ["not_ours"]),
    ("unread_announced", "a desk announces its universe and sends it with a priority that does not exist", {"send": [sacn(priority=250, announces=[1])]}, "nothing_arrives",
     ["bad_priority"]),
    ("offset_0", "--artnet-offset 0, and the desk sends the first Port-Address", {"options": ["--artnet-offset", "0"], "send": [artnet(0)]}, "nothing_arrives",
     ["--artnet-offset 0", "no universe"]),
    ("universe_0", "the desk counts its universes from 0: sACN of universe 0 by unicast", {"send": [sacn(0, to="10.93.0.2")]}, "nothing_arrives",
     ["bad_universe", "sACN has universes 1 to 63999", "count from 1"]),
    ("universe_0_multicast", "the same by multicast", {"send": [sacn(0)]}, "nothing_arrives", ["bad_universe", "count from 1"]),
    ("two_ways", "every second packet takes a longer way: they come two by two in the wrong order", {"send": [sacn(exchanges=2)]}, "numbering",
     ["come in another order than they were sent", "late and dropped"]),
    ("firewall_later", "a firewall of ours begins to drop what came", {"once": True, "send": [sacn(to="10.93.0.2")], "firewall_after_s": 5}, "lost",
     ["nothing comes for universe 1 any more", "firewall"]),
    ("cut", "packets that are cut on the way", {"send": [sacn(cut=100)]}, "wrong_length", ["more levels", "universe 1"]),
    ("loss", "every tenth packet gets lost: a bad cable, Wi-Fi", {"send": [sacn(loses=10)]}, "packets_lost", ["missing: lost by", "Wi-Fi"]),
    ("port_shared", "another program of ours has the port of Art-Net, and the desk sends sACN elsewhere",
     {"send": SILENT, "other": (6454, True)}, "port_shared", ["6454", "only the one started last"]),
    ("same_host", "the desk runs on this machine and its multicast does not come back", {"send": SILENT, "other": (5568, True)}, "same_host",
     ["unicast to 127.0.0.1"]),
    ("port_taken", "another program keeps the port to itself", {"other": (6454, False)}, "error:", ["UDP port 6454", "taken by"]),
    # The patch and the fixture.
    ("not_patched", "the fixture has no address", {"fixtures": [("Spot", 1, 0)]}, "explain:not_patched", ["it is not patched"]),
    ("same_address", "two fixtures at one address, and the desk means the other", {"fixtures": [("Spot", 1, 1), ("Wash", 1, 1, "Wash")], **with_levels(a1=0)},
     "explain:same_address", ["'Wash'"]),
    ("runs_on", "a fixture is patched at channel 500 and runs past 512", {"fixtures": [("Front", 1, 1), ("Spot", 1, 500)], "send": [sacn(levels=OPEN)]},
     "not_received", ["'Spot' begins on universe 1 and runs past channel 512"]),
    ("overlap", "a fixture begins inside of another one", {"fixtures": [("Front", 1, 1), ("Spot", 1, 20)], "send": [sacn(levels=OPEN)]},
     "explain:overlap", ["'Front'"]),
    ("mode", "the show names a mode that the fixture does not have", {"toml": 'mode = "Standard 23 channels"\n', "send": [sacn(levels={})]}, "explain:no_mode",
     ["Standard 23 channels"]),
    ("no_file", "the fixture's file is missing", {"toml": "", "gdtf": "Missing.gdtf"}, "explain:no_type", ["Missing.gdtf"]),
    ("dimmer", "the blackout or the grand master is down: the dimmer is at 0", with_levels(a1=0), "explain:dimmer", ["channel 1 (1.001) is at 0"]),
    ("dimmer_low", "the fader is at the foot of the dimmer curve", with_levels(a1=2), "explain:dimmer", ["channel 1 (1.001) is at 2"]),
    ("byte_order", "the desk sends the fine byte of a 16-bit dimmer first", {"gdtf": "Ghostlight@Dimmer_Lamp.gdtf", "toml": 'mode = "16 bit"\n',
     "send": [sacn(levels={2: 255})]}, "explain:dimmer", ["coarse byte is at 0", "16-bit order"]),
    ("shutter", "the shutter is closed", with_levels(a11=4), "explain:shutter", ["'Closed'", "channel 11 (1.011)"]),
    ("strobe", "the strobe is at its slowest, and between two flashes", {"show": [(1, {**OPEN, 11: 13})] * 4, "at_s": 0.8}, "explain:strobe",
     ["between two flashes", "'Strobe'", "channel 11 (1.011)", "flashes 1 times a second"]),
    ("lamp_off", "the lamp was put out by its control channel", with_levels(a22=168), "explain:lamp",
     ["the lamp is told to go off", "'Lamp off'", "channel 22 (1.022), value 168"]),
    ("too_short", "the desk sends 22 channels of its universe, and the lamp is at 100", {"fixtures": [("Spot", 1, 100)], "send": [sacn(slots=22)]},
     "explain:not_sent", ["universe 1 comes with 22 channels", "is it patched on the desk", "channel 1 (1.100) is at 0"]),
    ("parked", "cyan, magenta and yellow are parked at full", with_levels(a6=255, a7=255, a8=255), "explain:colour", ["cyan 100 %", "magenta 100 %"]),
    ("one_address_off", "the desk's patch is one address off", {"send": [sacn(levels={key + 1: value for key, value in OPEN.items()})]}, "explain:dimmer",
     ["channel 1 (1.001) is at 0"]),
    ("overridden", "another desk of higher priority sends black", {"send": [sacn(), sacn(levels={}, priority=150, name="House", cid=2)]},
     "explain:overridden", ["'House'", "priority 150"]),
    ("colour_fight", "two desks of equal priority: together their colour flags close", {
        "send": [sacn(levels={**OPEN, 6: 255}), sacn(levels={**OPEN, 7: 255, 8: 255}, name="Second", cid=2)]}, "explain:two_desks",
     ["'Test desk'", "'Second'", "have the same say"]),
    ("per_address_0", "the desk gives its channels away by priority per address", {"send": [sacn(per_address=0)]}, "explain:overridden", ["priority per address"]),
    # The window listens to the network where a show has no recording.
    ("no_recording", "there is neither a desk nor a recording", {"show": [], "in_window": False}, "explain:no_input", ["there is no DMX"]),
    ("not_in_recording", "the recording does not have the universe", {"show": [(2, OPEN)]}, "explain:never_received", ["universe 1 is not in the recording"]),
    ("begins_later", "the recording has the universe later", {"show": [(2, OPEN)] * 4 + [(1, OPEN)]}, "explain:never_received", ["begins in the recording at 2 s"]),
]

# All is well: nothing may be said to be wrong.
WELL = [
    ("of every forty packets one comes behind the next", {"send": [sacn(exchanges=40)]}),
    ("two desks of which one has the dimmers and one all else", {"send": [sacn(levels={1: 255}), sacn(levels={**OPEN, 1: 0}, name="Second", cid=2)]}),
    ("sACN multicast", {}),
    ("sACN unicast", {"send": [sacn(to="10.93.0.2")]}),
    ("sACN of 22 slots, announced", {"send": [sacn(slots=22, announces=[1])]}),
    ("Art-Net unicast", {"send": [artnet(to="10.93.0.2")]}),
    ("Art-Net broadcast", {"send": [artnet(to="10.93.0.255")]}),
    ("a backup that sends the same", {"send": [sacn(), sacn(name="Backup", cid=2)]}),
    ("live and preview in one row of numbers", {"send": [sacn(blind_every=3)]}),
    ("two universes in one row of numbers", {"send": [sacn(step=2), sacn(2, step=2, first_number=1)]}),
    ("other start codes in one row of numbers", {"send": [sacn(text_every=3)]}),
    ("synchronised", {"send": [sacn(sync=10)]}),
    ("synchronised every 1.5 s", {"send": [sacn(sync=10, sync_every=60)]}),
    ("levels name a synchronisation that never comes: shown at once", {"send": [sacn(sync=10, sync_stops_s=0)]}),
    ("priority per address", {"send": [sacn(per_address=100)]}),
    ("two network cards of one desk: every packet comes twice", {"send": [sacn(twin="10.93.0.11")], "desk": ["addr add 10.93.0.11/24 dev br0"]}),
    ("the same with a row of numbers for each card, and the look moves",
     {"send": [sacn(twin="10.93.0.11", twin_first_number=100, moves=[30, 31])], "desk": ["addr add 10.93.0.11/24 dev br0"]}),
    ("the same, and a light flashes with every packet",
     {"send": [sacn(twin="10.93.0.11", twin_first_number=9, flashes=1)], "desk": ["addr add 10.93.0.11/24 dev br0"]}),
    ("every packet comes twice, and a light flashes", {"send": [sacn(twice=True, flashes=1)]}),
    ("Art-Net without numbers by two sockets in turn, and a light flashes", {"send": [artnet(unnumbered=True, by_turns=True, flashes=2)]}),
    ("one desk by sACN and by Art-Net", {"send": [sacn(moves=[30]), artnet(moves=[30])]}),
    ("two desks that share a universe, and each chases its channels",
     {"send": [sacn(levels=OPEN, chases=[30, 31]), sacn(levels={}, chases=[32, 33], chase_begins=7, name="Second", cid=2)]}),
    ("a backup that follows a chase, 50 ms behind",
     {"send": [sacn(levels=OPEN, chases=[40, 41, 42, 43]), sacn(levels=OPEN, chases=[40, 41, 42, 43], chase_begins=38, name="Backup", cid=2)]}),
    ("an equal backup 50 ms behind while all flash in turn, 20 times a second", {"send": [sacn(levels=OPEN, chases=[40, 41], chase_step=1), sacn(levels=OPEN, chases=[40, 41], chase_step=1, name="Backup", cid=2, chase_begins=-2)]}),
    ("two operators that bump the same lamp now and then", {"send": [sacn(levels=OPEN, chases=[40, 41, 42, 43], chase_step=30), sacn(levels=OPEN, chases=[40, 44, 45, 43, 46], chase_step=35, name="Second", cid=2)]}),
    ("two desks that share a universe, each with channels of its own",
     {"send": [sacn(levels={1: 255, 2: 128}), sacn(levels={4: 128, 12: 255, 17: 255}, name="Second", cid=2)]}),
    ("somebody's Art-Net beside it that cannot be read", {"send": [sacn(), artnet(version=13)]}),
    ("Art-Net without numbers", {"send": [artnet(unnumbered=True)]}),
    ("a desk that sends more than is patched", {"send": [sacn(), sacn(9), sacn(30)]}),
    ("another system's Art-Net on the next universe", {"send": [sacn(), artnet(1)]}),
    ("the right one of two interfaces", {"options": ["--interface", "net0"]}),
]
