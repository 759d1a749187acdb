# SPDX-License-Identifier: Apache-2.0
"""Rows of the table of mistakes (mistakes.py says what a row is) with real desks: OLA and QLC+ (real_desks.py)."""
from mistakes import OPEN, SILENT, sacn
from real_desks import ola, qlc

SHIFTED = {address + 1: value for address, value in OPEN.items()}
BLACK = {**OPEN, 1: 0}
OTHER_LOOK = {**OPEN, 6: 255, 12: 10}
OLA_SACN, QLC_SACN = ola("e131"), qlc("E1.31", multicast=1, universe=1)


def desk(*desks, **setup):
    return {"send": SILENT, **{key: value for one in desks for key, value in one.items()}, **setup}


DESK_MISTAKES = [
    ("ola_not_patched", "OLA: its universe is not patched to the output", desk(ola("e131", patched=False)), "nothing_arrives", ["desk's output on"]),
    ("ola_other_card", "OLA: its sACN leaves by another card of its machine", desk(ola("e131", ip="10.99.0.1"), desk=["addr add 10.99.0.1/24 dev to_net1"],
     vis=["link set net1 down"]), "nothing_arrives", ["is it in this network"]),
    ("ola_sacn_one_off", "OLA: sACN, universe one too high", desk(ola("e131", 2)), "off_by_one", ["sACN comes for universe 2", "universe 1"]),
    ("ola_artnet_one_off", "OLA: universe 1 is Port-Address 1, and it sends to those alone that asked for that", desk(ola("artnet", 1)), "off_by_one",
     ["Art-Net is announced for universe 2", "'test' (10.93.0.1)", "--artnet-offset 0"]),
    ("ola_artnet_broadcast", "OLA: the same, and it broadcasts", desk(ola("artnet", 1, always_broadcast="true")), "off_by_one",
     ["Art-Net comes for universe 2", "--artnet-offset 0"]),
    ("ola_net", "OLA: Art-Net on Net 3", desk(ola("artnet", 16, net=3)), "not_patched", ["announces universe 769", "the show wants universe 1"]),
    ("ola_subnet", "OLA: Art-Net on Sub-Net 1, broadcast", desk(ola("artnet", 16, subnet=1, always_broadcast="true")), "not_patched",
     ["universe 17", "the show wants universe 1"]),
    ("ola_priority", "OLA is the main desk, and its priority is 90", desk(ola("e131", priority=90), send=[sacn(name="House")]), "low_priority",
     ["'OLA Server' (10.93.0.1) (priority 90)", "'House' (10.93.0.1) (priority 100)"]),
    ("ola_blackout", "OLA: the blackout: the dimmer is at 0", desk(ola("e131", levels=BLACK)), "explain:dimmer", ["channel 1 (1.001) is at 0"]),
    ("ola_one_address_off", "OLA: the patch is one address off", desk(ola("e131", levels=SHIFTED)), "explain:dimmer", ["channel 1 (1.001) is at 0"]),
    ("qlc_no_output", "QLC+: the universe has no output", desk(qlc("")), "nothing_arrives", ["desk's output on"]),
    ("qlc_loopback", "QLC+: the output is that of 127.0.0.1", desk(qlc("E1.31", card="127.0.0.1", multicast=1, universe=1)), "nothing_arrives",
     ["is it in this network"]),
    ("qlc_here", "QLC+ runs on our machine, and its multicast does not come back",
     desk(qlc("E1.31", on="vis", card="10.93.0.2", multicast=1, universe=1)), "nothing_arrives", ["on this very machine", "unicast to 127.0.0.1"]),
    ("qlc_elsewhere", "QLC+: unicast to another machine", desk(qlc("E1.31", multicast=0, ucastIP="10.93.0.77", universe=1)), "nothing_arrives",
     ["is it in this network"]),
    ("qlc_sacn_one_off", "QLC+: sACN, universe one too high", desk(qlc("E1.31", multicast=1, universe=2)), "off_by_one", ["sACN comes for universe 2"]),
    ("qlc_other_group", "QLC+: universe 1 to the multicast group of universe 2", desk(qlc("E1.31", multicast=1, universe=1, mcastIP="2")), "wrong_group",
     ["Q Light Controller Plus", "multicast group of another universe"]),
    ("qlc_artnet_one_off", "QLC+: Art-Net counted from 1", desk(qlc("ArtNet", outputUni=1)), "off_by_one", ["Art-Net comes for universe 2", "--artnet-offset 0"]),
    ("qlc_net", "QLC+: Art-Net on universe 768, which is Net 3", desk(qlc("ArtNet", outputUni=768)), "not_patched", ["universe 769", "the show wants universe 1"]),
    ("qlc_priority", "QLC+ with priority 50 beside OLA", desk(qlc("E1.31", multicast=1, universe=1, priority=50), OLA_SACN), "low_priority",
     ["Q Light Controller Plus", "(priority 50)", "'OLA Server' (10.93.0.1) (priority 100)"]),
    ("qlc_and_ola", "QLC+ and OLA send different looks", desk(qlc("E1.31", levels=OTHER_LOOK, multicast=1, universe=1), OLA_SACN), "two_desks",
     ["Q Light Controller Plus", "'OLA Server'", "HTP"]),
    ("qlc_not_started", "QLC+: its show is not started", desk(qlc("E1.31", plays=False, multicast=1, universe=1)), "explain:dimmer", ["channel 1 (1.001) is at 0"]),
    ("qlc_one_address_off", "QLC+: the patch is one address off", desk(qlc("E1.31", levels=SHIFTED, multicast=1, universe=1)), "explain:dimmer",
     ["channel 1 (1.001) is at 0"]),
]

DESK_WELL = [
    ("OLA, sACN", desk(OLA_SACN)),
    ("OLA on our machine, sACN", desk(ola("e131", on="vis", ip="10.93.0.2"))),
    ("OLA, Art-Net to who asked for it", desk(ola("artnet", 16))),
    ("QLC+, sACN multicast", desk(QLC_SACN)),
    ("QLC+, sACN unicast", desk(qlc("E1.31", multicast=0, ucastIP="10.93.0.2", universe=1))),
    ("QLC+, Art-Net", desk(qlc("ArtNet"))),
    ("QLC+ and OLA send the same", desk(QLC_SACN, OLA_SACN)),
]
