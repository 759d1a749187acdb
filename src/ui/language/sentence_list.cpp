// SPDX-License-Identifier: Apache-2.0
// Not split though over 600 lines: one list with headings, whose form, a pattern a line, is the only one that
// lupdate reads.
#include "ui/language/private/sentence_list.h"

#include <QCoreApplication>

namespace ghost::ui {
namespace {

constexpr const char* kSentences[] = {
    // why a fixture is lit or dark
    QT_TRANSLATE_NOOP(
        "Sentence",
        "there is no DMX: %1 and no desk is listened to; all channels keep their defaults, and %2"),
    QT_TRANSLATE_NOOP("Sentence",
                      "there is no DMX: %1 and no desk is listened to; all channels keep their defaults"),
    QT_TRANSLATE_NOOP("Sentence", "universe %1 is not in the recording, which has %2 and %3 more"),
    QT_TRANSLATE_NOOP("Sentence", "universe %1 is not in the recording, which has %2 and %3"),
    QT_TRANSLATE_NOOP("Sentence", "universe %1 never arrived in %2 s; what arrives is %3 and %4 more"),
    QT_TRANSLATE_NOOP("Sentence", "universe %1 never arrived in %2 s; what arrives is %3 and %4"),
    QT_TRANSLATE_NOOP("Sentence",
                      "the dimmer on %1 of function %2, that is %3; its coarse byte is at 0 and its fine one "
                      "at %4: a fader at its foot, or a desk that sends the fine byte first (16-bit order)"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "the dimmer on %1 of function %2, that is %3; its coarse byte is at 0 and its fine one at %4: a "
        "fader at its foot, or a desk that sends the fine byte first (16-bit order); so is %5"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "the dimmer on %1 of function %2, that is %3; its coarse byte is at 0 and its fine one at %4: a "
        "fader at its foot, or a desk that sends the fine byte first (16-bit order); so are %5"),
    QT_TRANSLATE_NOOP("Sentence",
                      "gobo wheel '%1' stands between '%2' and '%3' and lets only %4 of the light through"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "the zoom on %1, which the file calls %2: no angle of a lamp; drawn is a field of %3 deg"),
    QT_TRANSLATE_NOOP("Sentence",
                      "the file gives its beam %1 deg: no angle of a lamp; drawn is a field of %2 deg"),
    QT_TRANSLATE_NOOP("Sentence", "'%1', another kind of fixture, has the same address %2; %3"),
    QT_TRANSLATE_NOOP("Sentence", "its mode is not in the file: '%1' has no mode '%2', did you mean '%3'? "
                                  "(modes: %4); it gets '%5', whose channels mean other things; %6"),
    QT_TRANSLATE_NOOP("Sentence", "its mode is not in the file: '%1' has no mode '%2', did you mean '%3'? "
                                  "(modes: %4); it gets '%5', whose channels mean other things"),
    QT_TRANSLATE_NOOP("Sentence", "its mode is not in the file: '%1' has no mode '%2' (modes: %3); it gets "
                                  "'%4', whose channels mean other things; %5"),
    QT_TRANSLATE_NOOP("Sentence", "its mode is not in the file: '%1' has no mode '%2' (modes: %3); it gets "
                                  "'%4', whose channels mean other things"),
    QT_TRANSLATE_NOOP("Sentence",
                      "no mode of its type is chosen: give it one (Mode in the list of fixtures, or "
                      "mode = in the show file); what follows is of mode '%1'; %2"),
    QT_TRANSLATE_NOOP("Sentence",
                      "no mode of its type is chosen: give it one (Mode in the list of fixtures, or "
                      "mode = in the show file); what follows is of mode '%1'"),
    QT_TRANSLATE_NOOP("Sentence", "nobody says a place that can be used: where its beam comes from and what "
                                  "it hits is not known"),
    QT_TRANSLATE_NOOP("Sentence",
                      "nobody says how it is turned: where its beam goes and what it hits is not known"),
    QT_TRANSLATE_NOOP("Sentence", "lit: %1"),
    QT_TRANSLATE_NOOP("Sentence", "dark because %1"),
    QT_TRANSLATE_NOOP("Sentence", "hands have it so: %1"),
    QT_TRANSLATE_NOOP("Sentence", "hands have them so: %1"),
    QT_TRANSLATE_NOOP("Sentence", "nearly dark (%1 of its light) because %2"),
    QT_TRANSLATE_NOOP("Sentence", "not seen because %1"),
    QT_TRANSLATE_NOOP("Sentence", "%1 of %2 beams, the brightest '%3': %4"),
    QT_TRANSLATE_NOOP("Sentence", "%1 of %2 lm, %3, it glows and throws no beam"),
    QT_TRANSLATE_NOOP("Sentence", "%1 of %2 lm, %3, what it hits is not known (no stage)"),
    QT_TRANSLATE_NOOP("Sentence", "%1 of %2 lm, %3, what it hits is not known (nobody says its place)"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1 of %2 lm, %3, what it hits is not known (nobody says how it is turned)"),
    QT_TRANSLATE_NOOP("Sentence", "%1 of %2 lm, %3, hits '%4' at %5 m with %6 lx"),
    QT_TRANSLATE_NOOP("Sentence", "%1 of %2 lm, %3, its middle hits nothing, its edge '%4'"),
    QT_TRANSLATE_NOOP("Sentence", "%1 of %2 lm, %3, hits nothing: it leaves the stage %4"),
    QT_TRANSLATE_NOOP("Sentence", "mode '%1' has no Beam geometry: nothing in it can shine"),
    QT_TRANSLATE_NOOP("Sentence", "it gives %1 lm, less than 1 % of the brightest fixture (%2 lm)"),
    QT_TRANSLATE_NOOP("Sentence", "its mode is not in the file: %1"),
    QT_TRANSLATE_NOOP("Sentence", "the show names no fixture file for it (gdtf = ...)"),
    QT_TRANSLATE_NOOP("Sentence", "its fixture file %1 is missing or cannot be read: %2"),
    QT_TRANSLATE_NOOP("Sentence", "its fixture file %1 is missing or cannot be read"),
    QT_TRANSLATE_NOOP("Sentence", "'%1' has the same address and does the same"),
    QT_TRANSLATE_NOOP("Sentence", "'%1', another kind of fixture, has the same address %2"),
    QT_TRANSLATE_NOOP("Sentence", "it (%1 channels from %2) and '%3' (%4 channels from %5) read common "
                                  "channels: a mode of the wrong length, or a wrong address; %6"),
    QT_TRANSLATE_NOOP("Sentence", "it (%1 channels from %2) and '%3' (%4 channels from %5) read common "
                                  "channels: a mode of the wrong length, or a wrong address"),
    QT_TRANSLATE_NOOP("Sentence",
                      "it is not patched: without an address its channels keep their defaults, and %1"),
    QT_TRANSLATE_NOOP("Sentence", "it is not patched: without an address its channels keep their defaults"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "it is not patched (break %1): without an address its channels keep their defaults, and %2"),
    QT_TRANSLATE_NOOP("Sentence",
                      "it is not patched (break %1): without an address its channels keep their defaults"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "its address cannot be read: without an address its channels keep their defaults, and %1"),
    QT_TRANSLATE_NOOP("Sentence",
                      "its address cannot be read: without an address its channels keep their defaults"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "its address cannot be read (break %1): without an address its channels keep their defaults, and %2"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "its address cannot be read (break %1): without an address its channels keep their defaults"),
    QT_TRANSLATE_NOOP("Sentence", "there is no DMX: the show has no recording and no desk is listened to; "
                                  "all channels keep their defaults, and %1"),
    QT_TRANSLATE_NOOP("Sentence", "there is no DMX: the show has no recording and no desk is listened to; "
                                  "all channels keep their defaults"),
    QT_TRANSLATE_NOOP("Sentence",
                      "nobody asks for it, no desk, no recording and no hand: it is left dark while the work "
                      "light is on (by its file alone it would give %1 of its light)"),
    QT_TRANSLATE_NOOP("Sentence", "nobody asks for them while the work light is on"),
    QT_TRANSLATE_NOOP("Sentence",
                      "the XML is not well formed: %1, in or behind %2 of that file inside of the "
                      "plot, which is a zip"),
    QT_TRANSLATE_NOOP("Sentence",
                      "the XML is not well formed: %1, in that file inside of the plot, which is a zip"),
    QT_TRANSLATE_NOOP("Sentence", "the XML is not well formed: %1"),
    QT_TRANSLATE_NOOP("Sentence", "%1; its channels keep their defaults, and %2"),
    QT_TRANSLATE_NOOP("Sentence", "%1; its channels keep their defaults"),
    QT_TRANSLATE_NOOP("Sentence", "universe %1 begins in the recording at %2 s, this is %3 s"),
    QT_TRANSLATE_NOOP("Sentence", "universe %1 is not in the recording, which has %2"),
    QT_TRANSLATE_NOOP("Sentence", "universe %1 never arrived in %2 s; what arrives is %3"),
    QT_TRANSLATE_NOOP("Sentence", "universe %1 never arrived in %2 s, nor did any packet"),
    QT_TRANSLATE_NOOP("Sentence", "universe %1 never arrived in %2 s: %3"),
    QT_TRANSLATE_NOOP("Sentence", "universe %1 never arrived in %2 s"),
    QT_TRANSLATE_NOOP("Sentence",
                      "universe %1 is lost: its last packet came %2 s ago and its last look is held, and %3"),
    QT_TRANSLATE_NOOP("Sentence",
                      "universe %1 is lost: its last packet came %2 s ago and its last look is held"),
    QT_TRANSLATE_NOOP("Sentence", "universe %1 is lost: its last packet came %2 s ago and it went black "
                                  "(--on-loss), and %3"),
    QT_TRANSLATE_NOOP("Sentence",
                      "universe %1 is lost: its last packet came %2 s ago and it went black (--on-loss)"),
    QT_TRANSLATE_NOOP("Sentence", "universe %1 comes with %2, and %3 of the fixture lie past these (is it "
                                  "patched on the desk?), and %4"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "universe %1 comes with %2, and %3 of the fixture lie past these (is it patched on the desk?)"),
    QT_TRANSLATE_NOOP("Sentence", "the dimmer on %1 of function %2, that is %3; so is %4"),
    QT_TRANSLATE_NOOP("Sentence", "the dimmer on %1 of function %2, that is %3; so are %4"),
    QT_TRANSLATE_NOOP("Sentence", "the dimmer on %1 of function %2, that is %3"),
    QT_TRANSLATE_NOOP("Sentence", "its intensity is at %1"),
    QT_TRANSLATE_NOOP("Sentence", "no channel of its file dims it: hands alone light it"),
    QT_TRANSLATE_NOOP("Sentence",
                      "stand-in optics of 10000 lm and 25 degrees: its file says nothing of its own"),
    QT_TRANSLATE_NOOP("Sentence", "the dimmer (%1) is still on its way: it gives %2, asked is %3"),
    QT_TRANSLATE_NOOP("Sentence", "all dimmers together (%1) give %2"),
    QT_TRANSLATE_NOOP("Sentence", "its dimmer is %1: it has no DMX channel, the desk works it into %2"),
    QT_TRANSLATE_NOOP("Sentence", "the shutter is closed"),
    QT_TRANSLATE_NOOP("Sentence", "the shutter function %1 is active on %2, value %3"),
    QT_TRANSLATE_NOOP("Sentence", "the shutter function %1 is active on %2, default %3"),
    QT_TRANSLATE_NOOP("Sentence", "its strobe is between two flashes at this moment: function %1 on %2, "
                                  "value %3, flashes %4 times a second"),
    QT_TRANSLATE_NOOP("Sentence", "its strobe is between two flashes at this moment"),
    QT_TRANSLATE_NOOP("Sentence", "the framing blades (%1) let only %2 of what the iris leaves through"),
    QT_TRANSLATE_NOOP("Sentence", "the framing blades (%1) let only %2 of the light through"),
    QT_TRANSLATE_NOOP("Sentence", "the animation wheel lets only %1 of the light through (%2)"),
    QT_TRANSLATE_NOOP("Sentence",
                      "gobo wheel '%1' stands at '%2' and lets only %3 of the light through (%4)"),
    QT_TRANSLATE_NOOP("Sentence", "gobo wheel '%1' stands at '%2' and lets only %3 of the light through"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "gobo wheel '%1' stands between '%2' and '%3' and lets only %4 of the light through (%5)"),
    QT_TRANSLATE_NOOP("Sentence", "its file gives the lamp 0 lumens"),
    QT_TRANSLATE_NOOP("Sentence",
                      "the lamp is told to go off: function %1 on %2, value %3 (in the picture it burns)"),
    QT_TRANSLATE_NOOP("Sentence", "the lamp is told to go off: function %1 on %2, value %3"),
    QT_TRANSLATE_NOOP("Sentence",
                      "it is told to reset itself: function %1 on %2, value %3 (in the picture it does not)"),
    QT_TRANSLATE_NOOP("Sentence", "its lamp gives %1: it is off, or was struck less than a minute ago"),
    QT_TRANSLATE_NOOP("Sentence", "the iris is closed to %1 of the beam's width: %2"),
    QT_TRANSLATE_NOOP("Sentence", "the iris is closed to %1 of the beam's width"),
    QT_TRANSLATE_NOOP("Sentence", "the picture that it projects is black at this moment: of white it has %1"),
    QT_TRANSLATE_NOOP("Sentence", "all its colours are at 0: an LED needs colour as well as its dimmer (%1)"),
    QT_TRANSLATE_NOOP("Sentence", "its colour is at 0: an LED needs colour as well as its dimmer (%1)"),
    QT_TRANSLATE_NOOP("Sentence", "its lens is inside of '%1' and lights only that, from within"),
    QT_TRANSLATE_NOOP("Sentence", "'%1' is right before its lens (%2 cm) and stops the light"),
    QT_TRANSLATE_NOOP("Sentence", "it points %1 and away from everything; only its beam in the haze is seen"),
    QT_TRANSLATE_NOOP("Sentence", "it points %1 and away from everything; there is no haze to show its beam"),
    QT_TRANSLATE_NOOP("Sentence", "slot %1 '%2' of '%3'"),
    // reasons, as groups of dark fixtures
    QT_TRANSLATE_NOOP("Sentence", "their fixture file is missing or cannot be read"),
    QT_TRANSLATE_NOOP("Sentence", "another fixture has their address"),
    QT_TRANSLATE_NOOP("Sentence", "another fixture begins inside of them"),
    QT_TRANSLATE_NOOP("Sentence", "several things together dim them"),
    QT_TRANSLATE_NOOP("Sentence", "their file has no Beam geometry"),
    QT_TRANSLATE_NOOP("Sentence", "they are faint next to the brightest fixture"),
    QT_TRANSLATE_NOOP("Sentence", "their mode is not in the fixture file"),
    QT_TRANSLATE_NOOP("Sentence", "no mode of their type is chosen"),
    QT_TRANSLATE_NOOP("Sentence", "nobody says where they hang, or how they are turned"),
    QT_TRANSLATE_NOOP("Sentence", "their address cannot be read"),
    QT_TRANSLATE_NOOP("Sentence", "their intensity is at 0"),
    QT_TRANSLATE_NOOP("Sentence", "their dimmer is at 0"),
    QT_TRANSLATE_NOOP("Sentence", "their dimmer is nearly at 0"),
    QT_TRANSLATE_NOOP("Sentence", "their dimmer is still on its way"),
    QT_TRANSLATE_NOOP("Sentence", "their dimmer is virtual"),
    QT_TRANSLATE_NOOP("Sentence", "hands alone light them: no channel of their file dims them"),
    QT_TRANSLATE_NOOP("Sentence", "their optics are a stand-in"),
    QT_TRANSLATE_NOOP("Sentence", "their shutter is closed"),
    QT_TRANSLATE_NOOP("Sentence", "their strobe is between two flashes"),
    QT_TRANSLATE_NOOP("Sentence", "their colours let next to nothing through"),
    QT_TRANSLATE_NOOP("Sentence", "their framing blades let next to nothing through"),
    QT_TRANSLATE_NOOP("Sentence", "their animation wheel lets next to nothing through"),
    QT_TRANSLATE_NOOP("Sentence", "their gobo lets next to nothing through"),
    QT_TRANSLATE_NOOP("Sentence", "their zoom gives no beam"),
    QT_TRANSLATE_NOOP("Sentence", "their lamp has 0 lumens"),
    QT_TRANSLATE_NOOP("Sentence", "their lamp is off"),
    QT_TRANSLATE_NOOP("Sentence", "they are told to reset themselves"),
    QT_TRANSLATE_NOOP("Sentence", "their iris is closed"),
    QT_TRANSLATE_NOOP("Sentence", "their picture is black"),
    QT_TRANSLATE_NOOP("Sentence", "their colours are all at 0"),
    QT_TRANSLATE_NOOP("Sentence", "they are inside of an object"),
    QT_TRANSLATE_NOOP("Sentence", "an object is right before their lens"),
    QT_TRANSLATE_NOOP("Sentence", "they point away from everything"),
    QT_TRANSLATE_NOOP("Sentence", "they are not patched"),
    QT_TRANSLATE_NOOP("Sentence", "there is no DMX"),
    QT_TRANSLATE_NOOP("Sentence", "their universe %1 never arrived"),
    QT_TRANSLATE_NOOP("Sentence", "their universe %1 is lost"),
    QT_TRANSLATE_NOOP("Sentence", "their universe %1 comes with fewer channels"),
    QT_TRANSLATE_NOOP("Sentence", "%1 overrides %2, which would light it: on %3 it sends %4 instead of %5"),
    QT_TRANSLATE_NOOP("Sentence", "%1 overrides %2: on %3 it sends %4 instead of %5"),
    QT_TRANSLATE_NOOP("Sentence", "%1 and %2 have the same say: on %3 they send %4 and %5, and %6 shows, for "
                                  "it changed last (LTP); the first alone would light it"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "%1 and %2 have the same say: on %3 they send %4 and %5, and %6 shows, for it changed last (LTP)"),
    QT_TRANSLATE_NOOP("Sentence", "%1 and %2 have the same say: on %3 they send %4 and %5, and %6 shows; the "
                                  "first alone would light it"),
    QT_TRANSLATE_NOOP("Sentence", "%1 and %2 have the same say: on %3 they send %4 and %5, and %6 shows"),
    QT_TRANSLATE_NOOP("Sentence", "%1, priority none for this address) sends %2 on %3 but its list of "
                                  "priorities per address ends before that channel; nobody holds it"),
    QT_TRANSLATE_NOOP("Sentence", "%1, priority none for this address) sends %2 on %3 but its priority per "
                                  "address there is 0, or above 200, which is none; nobody holds it"),
    QT_TRANSLATE_NOOP("Sentence", "%1, priority none for this address) sends %2 on %3 but says by its "
                                  "priority per address that the channel is not its own; nobody holds it"),
    QT_TRANSLATE_NOOP("Sentence", "nobody holds their channels"),
    QT_TRANSLATE_NOOP("Sentence", "a source of higher priority overrides another"),
    QT_TRANSLATE_NOOP("Sentence", "two sources of equal priority send different things"),
    // the network
    QT_TRANSLATE_NOOP("Sentence",
                      "%1. Art-Net that a desk broadcasts to 2.255.255.255 and 10.255.255.255 (one in "
                      "2.x.x.x or 10.x.x.x with the mask 255.0.0.0) does not arrive at our address and mask, "
                      "which take %4 and 255.255.255.255: give both machines one network and one mask"),
    QT_TRANSLATE_NOOP("Sentence", "%1. Art-Net that a desk broadcasts to 2.255.255.255 and 10.255.255.255 "
                                  "(one in 2.x.x.x or 10.x.x.x with the mask 255.0.0.0) does not arrive at "
                                  "our address and mask: give both machines one network and one mask"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "%1. Art-Net that a desk broadcasts to %2 (one in %3 with the mask 255.0.0.0) does not arrive at our "
        "address and mask, which take %4 and 255.255.255.255: give both machines one network and one mask"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1. Art-Net that a desk broadcasts to %2 (one in %3 with the mask 255.0.0.0) does not "
                      "arrive at our address and mask: give both machines one network and one mask"),
    QT_TRANSLATE_NOOP("Sentence", "nothing arrives: is the desk's output on, is it in this network, and is "
                                  "no firewall on UDP %1 and %2 in the way? We listen on %3"),
    QT_TRANSLATE_NOOP("Sentence", "nothing arrives: is the desk's output on, is it in this network, does it "
                                  "send to a universe of ours? We listen on %1"),
    QT_TRANSLATE_NOOP("Sentence", "no levels arrive, though %1: is the desk's output on, is it in this "
                                  "network, and is no firewall on UDP %2 and %3 in the way? We listen on %4"),
    QT_TRANSLATE_NOOP("Sentence", "%1; %2: packets without a single level, also for %3 universes around"),
    QT_TRANSLATE_NOOP("Sentence", "%1; %2: packets without a single level, also for %3 universe around"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "%1; %2: only priorities per address (start code 0xDD), no levels, also for %3 universes around"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "%1; %2: only priorities per address (start code 0xDD), no levels, also for %3 universe around"),
    QT_TRANSLATE_NOOP("Sentence", "%1, also for %2 universes around"),
    QT_TRANSLATE_NOOP("Sentence", "%1, also for %2 universe around"),
    QT_TRANSLATE_NOOP("Sentence", "%1. With --artnet-offset %2 the first Port-Addresses have no universe"),
    QT_TRANSLATE_NOOP("Sentence", "%1. sACN has universes 1 to 63999: a desk that counts from 0 has to count "
                                  "from 1"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1 fixtures on %2 ('%3', ...), no levels arrive there (in Art-Net: Port-Address %4)"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1 fixture on %2 ('%3'), no levels arrive there (in Art-Net: Port-Address %4)"),
    QT_TRANSLATE_NOOP("Sentence", "%1 fixtures on %2 ('%3', ...), no levels arrive there (in Art-Net: "
                                  "Port-Address %4); packets arrive that cannot be read (%5)"),
    QT_TRANSLATE_NOOP("Sentence", "%1 fixture on %2 ('%3'), no levels arrive there (in Art-Net: Port-Address "
                                  "%4); packets arrive that cannot be read (%5)"),
    QT_TRANSLATE_NOOP("Sentence",
                      "off by one? %1 comes for %2 (from Port-Address %3 on), fixtures are on %4: %5"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "off by one? %1 is announced for %2 (from Port-Address %3 on) by %4, fixtures are on %5: %6"),
    QT_TRANSLATE_NOOP("Sentence", "%1; in Art-Net that is Net:Sub-Net:Universe %2, the show wants %3: the "
                                  "same numbers in another order"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1; in Art-Net that is Net:Sub-Net:Universe %2, the show wants %3: another Net"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1; in Art-Net that is Net:Sub-Net:Universe %2, the show wants %3: another Sub-Net"),
    QT_TRANSLATE_NOOP("Sentence", "%1, nothing is patched there; the show wants %2"),
    QT_TRANSLATE_NOOP("Sentence", "%1, nothing is patched there"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "this machine dropped %1 in the last seconds: it is too busy, the sockets' buffers are too small (as "
        "root: sysctl -w net.core.rmem_max=4194304), or somebody's packets have wrong checksums"),
    QT_TRANSLATE_NOOP("Sentence", "the port is taken by %1, which does not share it; close it and try again"),
    QT_TRANSLATE_NOOP("Sentence", "cannot listen: %1"),
    QT_TRANSLATE_NOOP("Sentence", "the interface %1 is down or gone: nothing is heard until it is back"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "no network interface is up: only a desk on this machine, by unicast to 127.0.0.1, can be heard"),
    QT_TRANSLATE_NOOP("Sentence", "%1 has no cable, or what is at its other end is off"),
    QT_TRANSLATE_NOOP("Sentence", "nothing arrives: is the desk's output on, is it in this network, and is "
                                  "no firewall on UDP %1 in the way? We listen on %2"),
    QT_TRANSLATE_NOOP("Sentence",
                      "no levels arrive, though %1: is the desk's output on, is it in this network, and is "
                      "no firewall on UDP %2 in the way? We listen on %3"),
    QT_TRANSLATE_NOOP("Sentence",
                      "no levels arrive, though %1: is the desk's output on, is it in this network, does it "
                      "send to a universe of ours? We listen on %2"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "packets arrive, and none of them can be read as levels: %1. If they are the desk's, it has to be "
        "mended; if not: is its output on, and is it in this network? We listen on %2"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "the port %1 of %2 is taken by %3, too: of two programs only the one started last gets a desk's "
        "unicast. Close the other one, or start again with --interface and an address of this machine"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1 runs on this machine: if it is the desk, its multicast does not come back here "
                      "(QLC+ switches that off): have it send unicast to 127.0.0.1"),
    QT_TRANSLATE_NOOP("Sentence", "%1 sends %2, but it comes in on %3, and we listen on %4 only: start with "
                                  "--interface %5, or without --interface"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "%1 announces %2, and none of it arrives here: either it sends them by unicast to other addresses "
        "than ours (its output page says so), or a switch holds this multicast back (IGMP snooping without a "
        "querier): unicast to %3 gets past both; or it announces what it does not send (its output is off)"),
    QT_TRANSLATE_NOOP("Sentence", "off by one? %1 comes for %2, fixtures are on %3: %4"),
    QT_TRANSLATE_NOOP("Sentence", "off by one? %1 is announced for %2 by %3, fixtures are on %4: %5"),
    QT_TRANSLATE_NOOP(
        "Sentence", "%1. If that is another system's (another hall, somebody's list), this show's desk is "
                    "silent or does not get here: its output, the network, a firewall on UDP 5568 and 6454"),
    QT_TRANSLATE_NOOP(
        "Sentence", "packets for %1 arrive (%2), nothing is patched there; the show wants %3; %4 is %5 with "
                    "its two bytes exchanged: if that is meant, the sender writes them in the wrong order"),
    QT_TRANSLATE_NOOP("Sentence",
                      "packets for %1 arrive (%2), nothing is patched there; the show wants %3; %4 "
                      "is %5 with its two bytes exchanged: the sender writes universe numbers in "
                      "the wrong order of bytes"),
    QT_TRANSLATE_NOOP("Sentence", "packets for %1 arrive (%2), nothing is patched there; the show wants %3"),
    QT_TRANSLATE_NOOP("Sentence", "packets for %1 arrive (%2), nothing is patched there"),
    QT_TRANSLATE_NOOP("Sentence", "%1 fixtures on %2 ('%3', ...), no levels arrive there"),
    QT_TRANSLATE_NOOP("Sentence", "%1 fixture on %2 ('%3'), no levels arrive there"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "%1; '%2' begins on %3 and runs past channel 512, where desks end a universe: is its address right?"),
    QT_TRANSLATE_NOOP("Sentence", "%1; packets arrive that cannot be read (%2)"),
    QT_TRANSLATE_NOOP("Sentence", "nothing comes for %1 any more, since %2: the last look is held. Packets "
                                  "still come, without levels"),
    QT_TRANSLATE_NOOP("Sentence", "nothing comes for %1 any more, since %2: the last look is held. %3: cable "
                                  "pulled %4 ago, which may be why"),
    QT_TRANSLATE_NOOP("Sentence", "nothing comes for %1 any more, since %2: black (--on-loss). %3: cable "
                                  "pulled %4 ago, which may be why"),
    QT_TRANSLATE_NOOP("Sentence", "nothing comes for %1 any more, since %2: the last look is held. %3: gone "
                                  "%4 ago, which may be why"),
    QT_TRANSLATE_NOOP("Sentence", "nothing comes for %1 any more, since %2: black (--on-loss). %3: gone %4 "
                                  "ago, which may be why"),
    QT_TRANSLATE_NOOP("Sentence",
                      "nothing comes for %1 any more, since %2: the last look is held. Its desk said that it "
                      "ends this stream: its output was switched off, or its program closed"),
    QT_TRANSLATE_NOOP("Sentence",
                      "nothing comes for %1 any more, since %2: black (--on-loss). Its desk said that it "
                      "ends this stream: its output was switched off, or its program closed"),
    QT_TRANSLATE_NOOP("Sentence", "nothing comes for %1 any more, since %2: black (--on-loss). Packets still "
                                  "come, without levels"),
    QT_TRANSLATE_NOOP("Sentence", "%1; %2: packets without a single level"),
    QT_TRANSLATE_NOOP("Sentence", "%1; %2: only priorities per address (start code 0xDD), no levels"),
    QT_TRANSLATE_NOOP("Sentence",
                      "nothing comes for %1 any more, since %2: black (--on-loss). Packets arrive that "
                      "cannot be read (%3): if they are its desk's, that has to be mended"),
    QT_TRANSLATE_NOOP("Sentence",
                      "nothing comes for %1 any more, since %2: the last look is held. Packets arrive that "
                      "cannot be read (%3): if they are its desk's, that has to be mended"),
    QT_TRANSLATE_NOOP("Sentence", "most packets of %1 on %2 come after a gap in their numbers: it counts "
                                  "several universes in one row, or as many get lost on the way"),
    QT_TRANSLATE_NOOP("Sentence", "packets of %1 on %2 come in another order than they were sent (two paths, "
                                  "Wi-Fi): %3 of %4 a second are late and dropped"),
    QT_TRANSLATE_NOOP("Sentence", "%1. By %2 only programs of this machine are heard (--interface)"),
    QT_TRANSLATE_NOOP("Sentence", "%1. Art-Net is not listened for (--protocols)"),
    QT_TRANSLATE_NOOP("Sentence", "%1. sACN is not listened for (--protocols)"),
    QT_TRANSLATE_NOOP("Sentence", "%1. Somebody asks who wants Art-Net (ArtPoll) and gets no answer "
                                  "(--no-poll-reply): OLA and some desks send to those alone that answer"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "%1. Somebody asks who wants Art-Net (ArtPoll) and gets no answer, for it asks from another network, "
        "too often or with too many others: OLA and some desks send to those alone that answer"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "%1. Somebody asks who wants Art-Net (ArtPoll) and is answered: where that is the desk, a firewall "
        "of "
        "its machine on UDP 6454 may keep our answer from it, or it has no output for our universes"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "nothing comes for %1 any more, since %2: black (--on-loss). Its desk has stopped, sends elsewhere "
        "now (another universe or machine) or less often than every 2.5 s (sACN) or 10 s (Art-Net), or "
        "something on the way lets nothing through any more: a cable, a firewall, or a switch that prunes "
        "multicast after minutes (IGMP snooping without a querier)"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "nothing comes for %1 any more, since %2: black (--on-loss). %3 is heard all the while, with %4: its "
        "output was switched off or goes elsewhere, or something holds back these packets alone, a firewall "
        "or a switch that prunes multicast (IGMP snooping without a querier)"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "nothing comes for %1 any more, since %2: black (--on-loss). %3 and others are heard all the while, "
        "with %4: its output was switched off or goes elsewhere, or something holds back these packets "
        "alone, a firewall or a switch that prunes multicast (IGMP snooping without a querier)"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "nothing comes for %1 any more, since %2: the last look is held. Its desk has stopped, sends "
        "elsewhere now (another universe or machine) or less often than every 2.5 s (sACN) or 10 s "
        "(Art-Net), or something on the way lets nothing through any more: a cable, a firewall, or a switch "
        "that prunes multicast after minutes (IGMP snooping without a querier)"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "nothing comes for %1 any more, since %2: the last look is held. %3 is heard all the while, with %4: "
        "its output was switched off or goes elsewhere, or something holds back these packets alone, a "
        "firewall or a switch that prunes multicast (IGMP snooping without a querier)"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "nothing comes for %1 any more, since %2: the last look is held. %3 and others are heard all the "
        "while, with %4: its output was switched off or goes elsewhere, or something holds back these "
        "packets alone, a firewall or a switch that prunes multicast (IGMP snooping without a querier)"),
    QT_TRANSLATE_NOOP("Sentence", "%1 is one source too many on %2 and ignored: %3"),
    QT_TRANSLATE_NOOP("Sentence", "%1 are too many sources on %2 and ignored: %3"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1 is shown only in part on %2: %3 has a higher priority, and sends 0 alone"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1 is shown only in part on %2: %3 has a higher priority, and has all dimmers at 0"),
    QT_TRANSLATE_NOOP("Sentence", "%1 is not shown on %2: %3 has a higher priority, and sends 0 alone"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1 is not shown on %2: %3 has a higher priority, and has all dimmers at 0"),
    QT_TRANSLATE_NOOP("Sentence", "%1 is not shown on %2: %3 has a higher priority"),
    QT_TRANSLATE_NOOP("Sentence", "%1 sends priorities per address above 200 on %2 for %3: there is none "
                                  "above 200 (E1.31), and it does not hold these channels"),
    QT_TRANSLATE_NOOP("Sentence", "%1 sends %2 on %3 and priorities per address for %4 alone: it "
                                  "gives the others up, and fixtures are patched there"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1 gives %2 of %3 on universe %4 away (priority per address 0), and nobody else sends "
                      "them: their levels are not used. Are they patched on the desk?"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "%1 comes from more than one source of equal priority, %2, and they have up to %3 up at "
        "different times: %4. If both play these lamps, all is well; if one is a backup, it is out of "
        "step: give it a lower priority"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "%1 come from more than one source of equal priority, %2, and they have up to %3 up at "
        "different times: %4. If both play these lamps, all is well; if one is a backup, it is out of "
        "step: give it a lower priority"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1 comes from more than one source of equal priority, %2, and they differ on up to "
                      "%3: %4. Switch one off, or give one that is a backup a lower priority"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1 come from more than one source of equal priority, %2, and they differ on up to %3: "
                      "%4. Switch one off, or give one that is a backup a lower priority"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1 comes from more than one source of equal priority, %2, and they differ on up to "
                      "%3: %4. %5 is silent, and counts until %6 have gone by"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1 come from more than one source of equal priority, %2, and they differ on up to %3: "
                      "%4. %5 is silent, and counts until %6 have gone by"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1 comes from more than one source of equal priority, %2, and they differ on up to "
                      "%3: %4. None of these is now above 0 at two of them, so they may be meant to share"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1 come from more than one source of equal priority, %2, and they differ on up to %3: "
                      "%4. None of these is now above 0 at two of them, so they may be meant to share"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1 comes from more than one source of equal priority, %2, and they differ on up to "
                      "%3: %4. %5 sends 0 alone: if that is a black-out, the others hide it"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1 comes from more than one source of equal priority, %2, and they differ on up to "
                      "%3: %4. %5 has all dimmers at 0: if that is a black-out, the others hide it"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1 come from more than one source of equal priority, %2, and they differ on up to %3: "
                      "%4. %5 sends 0 alone: if that is a black-out, the others hide it"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1 come from more than one source of equal priority, %2, and they differ on up to %3: "
                      "%4. %5 has all dimmers at 0: if that is a black-out, the others hide it"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1 comes from more than one source of equal priority, %2, and they differ on up to "
                      "%3: %4. %5 has all dimmers at 0, and raises up to %6 of lamps that others light: a "
                      "closed shutter or a colour among these would take the light away. If they are not "
                      "meant to share, switch one off, or give one that is a backup a lower priority"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1 come from more than one source of equal priority, %2, and they differ on up to %3: "
                      "%4. %5 has all dimmers at 0, and raises up to %6 of lamps that others light: a closed "
                      "shutter or a colour among these would take the light away. If they are not meant to "
                      "share, switch one off, or give one that is a backup a lower priority"),
    QT_TRANSLATE_NOOP("Sentence",
                      "two senders have one identity (CID) on %1: %2 and one at %3 that sends other packets. "
                      "The first is shown, the second is dropped. One is a copy of the other (a cloned disk, "
                      "a copied set-up): give it a CID of its own"),
    QT_TRANSLATE_NOOP("Sentence",
                      "packets of %1 on %2 come in two rows of numbers, or one of them without any, with "
                      "different levels: two programs send there as one, or one that gives two packets one "
                      "number (a base and an effect). Now the look of this shows, now of that. Of two, close "
                      "one, or give it an identity of its own (sACN: a CID, Art-Net: an address)"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "the packets of %1 on %2 come by turns from the ports %3 and %4 with different levels: two programs "
        "send there as one, or one by two sockets. Now the look of this shows, now of that. Of two, close "
        "one, or give it an identity of its own (sACN: a CID, Art-Net: an address)"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1 does not count its packets up on %2: %3 of %4 a second are dropped as late or "
                      "twice, for their sequence number stands still or counts down. The look follows in "
                      "jumps until this sender is mended"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1 comes with %2, and %3 (%4) is patched past these: not patched on the desk?"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1 comes with %2, and %3 (%4) are patched past these: not patched on the desk?"),
    QT_TRANSLATE_NOOP("Sentence", "%1. %2 names more than one Physical (input): it has several, or it "
                                  "changes what it names, and each counts as a source"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1. %2 sends by sACN and by Art-Net: if that is one desk, one of them will do"),
    QT_TRANSLATE_NOOP("Sentence", "%1 marks some of %2 as preview (blind), which is not shown: leave blind "
                                  "on the desk, or start with --show-preview"),
    QT_TRANSLATE_NOOP("Sentence", "%1 marks %2 as preview (blind), which is not shown: leave blind on the "
                                  "desk, or start with --show-preview"),
    QT_TRANSLATE_NOOP("Sentence", "more universes arrive than the %1 that are shown at once; those of the "
                                  "show and of --universes are always among them"),
    QT_TRANSLATE_NOOP("Sentence",
                      "levels of %1 on %2 wait for a synchronisation packet that does not come, or seldom; "
                      "after %3 at most they show without"),
    QT_TRANSLATE_NOOP("Sentence", "%1 sends Art-Net from another network than ours (%2), by a router or "
                                  "because the addresses do not fit: without a router its unicast and our "
                                  "answers do not arrive, and this machine needs an address in its network"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "%1 sends %2 to the multicast group of another universe; the levels are used as those of %3"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1 declares more levels on %2 than its packets hold, or than 512; those that come are "
                      "used"),
    QT_TRANSLATE_NOOP("Sentence",
                      "in the numbers of the last seconds %1 packets are missing: lost by a cable, a switch, "
                      "Wi-Fi or a firewall that lets only some through, or left out by a sender that skips "
                      "numbers"),
    QT_TRANSLATE_NOOP("Sentence",
                      "in the numbers of the last seconds %1 packet is missing: lost by a cable, a switch, "
                      "Wi-Fi or a firewall that lets only some through, or left out by a sender that skips "
                      "numbers"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "two Art-Net time codes run, of %1 and %2: the one that came first is followed until it is silent"),
    QT_TRANSLATE_NOOP("Sentence", "no levels"),
    QT_TRANSLATE_NOOP("Sentence", "behind preview"),
    QT_TRANSLATE_NOOP("Sentence", "lower priority"),
    QT_TRANSLATE_NOOP("Sentence", "holds no slot"),
    QT_TRANSLATE_NOOP("Sentence", "in part"),
    QT_TRANSLATE_NOOP("Sentence", "merged"),
    QT_TRANSLATE_NOOP("Sentence", "shown"),
    QT_TRANSLATE_NOOP("Sentence", "waiting"),
    QT_TRANSLATE_NOOP("Sentence", "silent"),
    // what a plot has
    QT_TRANSLATE_NOOP("Sentence", "Fixture files that are missing"),
    QT_TRANSLATE_NOOP("Sentence", "Fixture files that cannot be read"),
    QT_TRANSLATE_NOOP("Sentence", "Fixture files without a DMX mode"),
    QT_TRANSLATE_NOOP("Sentence", "Modes that the fixture file does not have"),
    QT_TRANSLATE_NOOP("Sentence", "Fixture files that say nothing of their light"),
    QT_TRANSLATE_NOOP("Sentence", "Fixture files taken by a name that is nearly the same"),
    QT_TRANSLATE_NOOP("Sentence", "Files that are missing"),
    QT_TRANSLATE_NOOP("Sentence", "Pictures and models that are missing"),
    QT_TRANSLATE_NOOP("Sentence", "Films and pictures that cannot be read"),
    QT_TRANSLATE_NOOP("Sentence", "Names that lead nowhere"),
    QT_TRANSLATE_NOOP("Sentence", "Fixtures that share channels"),
    QT_TRANSLATE_NOOP("Sentence", "Fixtures without an address"),
    QT_TRANSLATE_NOOP("Sentence", "Fixtures that run past channel 512"),
    QT_TRANSLATE_NOOP("Sentence", "Parts of fixtures without an address"),
    QT_TRANSLATE_NOOP("Sentence", "Addresses that cannot be"),
    QT_TRANSLATE_NOOP("Sentence", "Addresses that fit another mode"),
    QT_TRANSLATE_NOOP("Sentence", "Fixtures with the very same address"),
    QT_TRANSLATE_NOOP("Sentence", "Names that are given twice"),
    QT_TRANSLATE_NOOP("Sentence", "Fixture numbers that are given twice"),
    QT_TRANSLATE_NOOP("Sentence", "Identities that are given twice"),
    QT_TRANSLATE_NOOP("Sentence", "Names that lead out of the file"),
    QT_TRANSLATE_NOOP("Sentence", "Values that a file leaves out"),
    QT_TRANSLATE_NOOP("Sentence", "Things in the file that mean nothing to us"),
    QT_TRANSLATE_NOOP("Sentence", "Things in the file that no picture needs"),
    QT_TRANSLATE_NOOP("Sentence", "Other"),
    QT_TRANSLATE_NOOP("Sentence", "is not in the plot"),
    QT_TRANSLATE_NOOP("Sentence", "cannot be read"),
    QT_TRANSLATE_NOOP("Sentence", "gives no light"),
    QT_TRANSLATE_NOOP("Sentence", "says nothing of its light: a beam is assumed"),
    QT_TRANSLATE_NOOP("Sentence", "says nothing of its light: hands alone light a stand-in"),
    QT_TRANSLATE_NOOP("Sentence", "%1 fixtures of %2 types, patched in %3 universes"),
    QT_TRANSLATE_NOOP("Sentence", "%1 fixtures of %2 types, patched in %3 universe"),
    QT_TRANSLATE_NOOP("Sentence", "%1 fixtures of %2 type, patched in %3 universes"),
    QT_TRANSLATE_NOOP("Sentence", "%1 fixtures of %2 type, patched in %3 universe"),
    QT_TRANSLATE_NOOP("Sentence", "%1 fixture of %2 type, patched in %3 universe"),
    QT_TRANSLATE_NOOP("Sentence", "%1 of no type"),
    QT_TRANSLATE_NOOP("Sentence", "no scenery: heads hang in empty space"),
    QT_TRANSLATE_NOOP("Sentence", "%1 pieces of scenery in %2 layers"),
    QT_TRANSLATE_NOOP("Sentence", "%1 pieces of scenery in %2 layer"),
    QT_TRANSLATE_NOOP("Sentence", "%1 piece of scenery in %2 layer"),
    QT_TRANSLATE_NOOP("Sentence", "%1 cameras"),
    QT_TRANSLATE_NOOP("Sentence", "%1 camera"),
    QT_TRANSLATE_NOOP("Sentence", "export the file again"),
    QT_TRANSLATE_NOOP("Sentence", "keep one of them, or give them names of their own"),
    QT_TRANSLATE_NOOP("Sentence", "put the file there, or correct its name"),
    QT_TRANSLATE_NOOP("Sentence", "see that this is the fixture that was meant"),
    QT_TRANSLATE_NOOP("Sentence", "put the file into the archive or beside the plot, or name another one in "
                                  "[[substitute]] of the show file"),
    QT_TRANSLATE_NOOP("Sentence", "give the fixture a type in the program that drew the plot"),
    QT_TRANSLATE_NOOP("Sentence", "get the file again from its maker"),
    QT_TRANSLATE_NOOP("Sentence", "fine for machines; for a lamp get a newer file from its maker"),
    QT_TRANSLATE_NOOP("Sentence", "get a newer file from its maker"),
    QT_TRANSLATE_NOOP("Sentence", "choose a mode that the file has, in the plot or in the show file"),
    QT_TRANSLATE_NOOP("Sentence", "get the file again, or make one of it that FFmpeg plays"),
    QT_TRANSLATE_NOOP("Sentence", "get the file again, with its models; a plain shape stands in"),
    QT_TRANSLATE_NOOP("Sentence", "export the model again, with its textures"),
    QT_TRANSLATE_NOOP("Sentence", "get the file again, with its pictures; the gobo is open until then"),
    QT_TRANSLATE_NOOP("Sentence", "export the plot again, with its gobo pictures"),
    QT_TRANSLATE_NOOP("Sentence", "get the file again; a plain shape stands in"),
    QT_TRANSLATE_NOOP("Sentence", "get the file again"),
    QT_TRANSLATE_NOOP("Sentence", "export the plot again, with its models"),
    QT_TRANSLATE_NOOP("Sentence", "export the plot again, with its media"),
    QT_TRANSLATE_NOOP("Sentence", "nothing is drawn by it; export again if grouping by it matters"),
    QT_TRANSLATE_NOOP("Sentence", "export the plot again, with its symbols"),
    QT_TRANSLATE_NOOP("Sentence", "get a newer file from its maker, or see that the range is right"),
    QT_TRANSLATE_NOOP(
        "Sentence", "patch them in the plot, or with address in [[fixture]] or [[change]] of the show file"),
    QT_TRANSLATE_NOOP("Sentence", "give it an address in that range"),
    QT_TRANSLATE_NOOP("Sentence", "move them to addresses where they fit"),
    QT_TRANSLATE_NOOP("Sentence", "give each break an address, if the desk drives it"),
    QT_TRANSLATE_NOOP("Sentence", "fine where a multipatch is meant"),
    QT_TRANSLATE_NOOP("Sentence", "give one of them other addresses, or the mode with fewer channels"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "name another file of this fixture in [[substitute]] of the show file, or get a newer one"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "fine where it is no lamp; else name another file of it in [[substitute]] of the show file"),
    QT_TRANSLATE_NOOP("Sentence", "give each fixture a number of its own, or mark them as multipatch"),
    QT_TRANSLATE_NOOP("Sentence", "export the plot again; each object needs a UUID of its own"),
    QT_TRANSLATE_NOOP("Sentence", "%1 fixtures have no address, all channels keep their defaults: %2"),
    QT_TRANSLATE_NOOP("Sentence", "%1 fixture has no address, all channels keep their defaults: %2"),
    QT_TRANSLATE_NOOP("Sentence", "%1 fixtures of one type share address %2 and will do the same: %3"),
    QT_TRANSLATE_NOOP("Sentence", "%1 fixtures of %2 give no light, as the mode has no beam: %3"),
    QT_TRANSLATE_NOOP("Sentence", "%1 fixture of %2 gives no light, as the mode has no beam: %3"),
    QT_TRANSLATE_NOOP("Sentence", "%1 fixtures of %2 have stand-in optics, which hands alone light, as the "
                                  "mode has no beam: %3"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1 fixture of %2 has stand-in optics, which hands alone light, as the mode "
                      "has no beam: %3"),
    QT_TRANSLATE_NOOP("Sentence",
                      "'%1' and '%2' share channels %3 to %4 of universe %5, expected channels of their own"),
    // what files of plots and fixtures lack
    QT_TRANSLATE_NOOP("Sentence", "a second attribute named '%1', links mean the first"),
    QT_TRANSLATE_NOOP("Sentence", "the picture %1 is not in the archive"),
    QT_TRANSLATE_NOOP("Sentence", "the texture '%1' is not in the archive"),
    QT_TRANSLATE_NOOP("Sentence", "mesh '%1' is not in the archive"),
    QT_TRANSLATE_NOOP("Sentence", "gobo '%1' is not in the archive"),
    QT_TRANSLATE_NOOP("Sentence", "no Beam or Laser geometry in mode '%1': it gives no light"),
    QT_TRANSLATE_NOOP(
        "Sentence", "no Beam or Laser geometry in mode '%1': taking one of 10000 lm and 25 degrees at '%2', "
                    "which hands alone light, as its channels have numbers for names"),
    QT_TRANSLATE_NOOP("Sentence", "%1 fixtures are left out, more than 10 km from most of the plot: no "
                                  "picture holds both: %2"),
    QT_TRANSLATE_NOOP("Sentence", "%1 fixture is left out, more than 10 km from most of the plot: no picture "
                                  "holds both: %2"),
    QT_TRANSLATE_NOOP("Sentence", "objects more than 10 km from most of the plot are left out: %1"),
    QT_TRANSLATE_NOOP("Sentence", "would be %1 bytes, and no more than %2 are read again: nothing is "
                                  "changed; a palette of fewer fixtures needs less"),
    QT_TRANSLATE_NOOP("Sentence", "the pictures of its %1 lights need %2 MB of memory, and %3 are free: "
                                  "fewer lights or a smaller picture need less"),
    QT_TRANSLATE_NOOP("Sentence", "its passes need pictures of %1 x %2 in %3 layers, and this device has "
                                  "them up to %4 a side and %5 layers"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "it needs pictures of %1 x %2 in %3 layers, and this device has them up to %4 a side and %5 layers; "
        "no light bounces. Lamps and objects far from all others make the room so large"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "%1 has more patterns with * and ? than can be compared with so many and so long names (500 million "
        "letters): this one and those after it match nothing; write names out, or shorter patterns"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "%1 mesh files are left out: the others need all of the %2 GiB that the meshes of a plot may have"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "%1 mesh file is left out: the others need all of the %2 GiB that the meshes of a plot may have"),
    QT_TRANSLATE_NOOP("Sentence", "its gobos stay open, and perhaps those of other files: with it the "
                                  "pictures of all fixture files need more than %1 GiB"),
    QT_TRANSLATE_NOOP("Sentence", "is empty: there is no show in it"),
    QT_TRANSLATE_NOOP("Sentence",
                      "is no show: a folder with a show.toml, a show.toml, or a plot (.mvr) can be opened"),
    QT_TRANSLATE_NOOP("Sentence", "objects with edges of more than two triangles, of which none is inside or "
                                  "outside; they are drawn as they are: %1"),
    QT_TRANSLATE_NOOP("Sentence", "objects with triangles that have no area; those are not seen: %1"),
    QT_TRANSLATE_NOOP("Sentence",
                      "objects are mirrored (negative scale), and so are the pictures on them: %1"),
    QT_TRANSLATE_NOOP("Sentence",
                      "objects of more than a million triangles, which take long to draw and to trace: %1"),
    QT_TRANSLATE_NOOP("Sentence", "objects without normals get smooth ones: %1"),
    QT_TRANSLATE_NOOP("Sentence", "%1 and %2 more"),
    QT_TRANSLATE_NOOP("Sentence", "%1 (and so in %2 more files)"),
    QT_TRANSLATE_NOOP("Sentence", "not used, as neither picture nor motion needs it: %1"),
    QT_TRANSLATE_NOOP("Sentence", "%1 values of %2"),
    QT_TRANSLATE_NOOP("Sentence", "%1 (%2 fixtures need it)"),
    QT_TRANSLATE_NOOP("Sentence", "%1 (%2 fixture needs it)"),
    QT_TRANSLATE_NOOP("Sentence", "fixture file '%1' is not in the archive"),
    QT_TRANSLATE_NOOP("Sentence", "fixture file '%1' is not in the archive, did you mean '%2'?"),
    QT_TRANSLATE_NOOP("Sentence", "element %1 means nothing to MVR 1.6 in %2; kept for the export"),
    QT_TRANSLATE_NOOP("Sentence", "%1 is '%2', expected a number from %3 to %4, taking %5"),
    QT_TRANSLATE_NOOP("Sentence", "no mesh '%1' (.glb or .3ds) in models/, taking the primitive"),
    QT_TRANSLATE_NOOP("Sentence",
                      "%1 fixtures share their name with others and are called '%2' and so on: %3"),
    QT_TRANSLATE_NOOP("Sentence", "%1 has no physical range, taking %2 to %3 degrees"),
    QT_TRANSLATE_NOOP("Sentence", "Zoom has no physical range: the beam keeps its %1 degrees"),
    QT_TRANSLATE_NOOP("Sentence", "an animation wheel whose sets are named as a way into the beam moves in; "
                                  "the names are believed (%1 functions)"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "the focus is named far at its low end, which is near here; the names are believed (%1 functions)"),
    QT_TRANSLATE_NOOP("Sentence", "a colour temperature whose sets are named in kelvin and state no value; "
                                  "the names are believed (%1 functions)"),
    QT_TRANSLATE_NOOP("Sentence", "a frost whose sets are named in per cent and state no value; the names "
                                  "are believed, and what pulses is drawn half in (%1 functions)"),
    QT_TRANSLATE_NOOP("Sentence", "a rotation has a speed where its name says that there is none; the names "
                                  "are believed (%1 functions)"),
    QT_TRANSLATE_NOOP("Sentence", "the rate of a pulsing iris falls where its name says that it gets faster; "
                                  "taken for the seconds of a pulse (%1 functions)"),
    QT_TRANSLATE_NOOP("Sentence", "a prism without facets; drawn as %1, by its name or as most are"),
    QT_TRANSLATE_NOOP("Sentence", "there is no Symdef '%1'; nothing is drawn"),
    QT_TRANSLATE_NOOP("Sentence", "text '%1' is taken as a Source of type File"),
    QT_TRANSLATE_NOOP("Sentence", "expected %1, found '%2'; taken as %3"),
    QT_TRANSLATE_NOOP("Sentence", "the matrix flattens what it places (its determinant is 0)"),
    QT_TRANSLATE_NOOP("Sentence", "channels '%1' and '%2' both use byte %3 of break %4"),
    QT_TRANSLATE_NOOP("Sentence", "Symdef without a ChildList; its geometries are read all the same"),
    QT_TRANSLATE_NOOP("Sentence", "the %1 that %2 names does not exist"),
    QT_TRANSLATE_NOOP("Sentence", "these objects are in no Layer; they are put in one without a name"),
    QT_TRANSLATE_NOOP("Sentence", "mode '%1' takes no DMX: all its channels are virtual"),
    QT_TRANSLATE_NOOP("Sentence", "the channel's geometry '%1' is not in this mode's tree"),
    QT_TRANSLATE_NOOP("Sentence", "GDTFSpec '%1': taken is '%2'"),
    QT_TRANSLATE_NOOP("Sentence", "%1 fixture of %2 type, patched in %3 universes"),
    QT_TRANSLATE_NOOP("Sentence", "%1 deg"),
    QT_TRANSLATE_NOOP("Sentence", "note"),
    QT_TRANSLATE_NOOP("Sentence", "warning"),
    QT_TRANSLATE_NOOP("Sentence", "error"),
    QT_TRANSLATE_NOOP("Sentence", "Not opened: %1"),
    QT_TRANSLATE_NOOP("Sentence", "mend the file and open it again"),
    // what the engine does
    QT_TRANSLATE_NOOP("Sentence", "opening %1"),
    QT_TRANSLATE_NOOP("Sentence", "taking over %1"),
    QT_TRANSLATE_NOOP("Sentence", "taking the changes of %1"),
    QT_TRANSLATE_NOOP("Sentence", "drawing anew on the graphics device"),
    QT_TRANSLATE_NOOP("Sentence", "baked: %1, %2 passes"),
    QT_TRANSLATE_NOOP("Sentence", "live: %1, because %2"),
    QT_TRANSLATE_NOOP("Sentence", "live: a free camera"),
    QT_TRANSLATE_NOOP("Sentence", "the show has changes that are not saved"),
    QT_TRANSLATE_NOOP("Sentence", "its passes are being read"),
    QT_TRANSLATE_NOOP("Sentence", "its passes have %1 pixels, and the window shows it with %2"),
    QT_TRANSLATE_NOOP("Sentence", "its passes need %1 MB on the device, which has not got them"),
    QT_TRANSLATE_NOOP("Sentence", "its passes are of an earlier version of Ghostlight: bake it again, once"),
    QT_TRANSLATE_NOOP("Sentence", "files of the show changed since its bake: bake it again"),
    QT_TRANSLATE_NOOP("Sentence", "%1; run `ghostlight bake` again"),
    QT_TRANSLATE_NOOP("Sentence", "belongs to another bake than manifest.json says"),
    QT_TRANSLATE_NOOP("Sentence", "has version %1, this program reads up to %2"),
    QT_TRANSLATE_NOOP("Sentence", "is %1 x %2 pixels, expected %3 x %4"),
    QT_TRANSLATE_NOOP("Sentence", "has no channel %1, expected R, G, B"),
    QT_TRANSLATE_NOOP("Sentence", "has no channel %1, expected R G B = x y z in metres and A"),
    QT_TRANSLATE_NOOP("Sentence", "fragment %1 is not a finite number"),
    QT_TRANSLATE_NOOP("Sentence", "fragment %1 belongs to no pixel or is out of order"),
    QT_TRANSLATE_NOOP("Sentence", "has no 'position', expected the name of the position picture"),
    QT_TRANSLATE_NOOP("Sentence", "has no [camera] with matrix_world and fov_y_deg"),
    // who shows the picture
    QT_TRANSLATE_NOOP("Sentence", "shown by the graphics device in %1 ms, by the window it took %2 ms"),
    QT_TRANSLATE_NOOP("Sentence", "shown by the window in %1 ms, by the graphics device it took %2 ms"),
    QT_TRANSLATE_NOOP("Sentence", "shown by the graphics device, as it was asked for"),
    QT_TRANSLATE_NOOP("Sentence", "shown by the window: the graphics device has no displays"),
    QT_TRANSLATE_NOOP("Sentence", "shown by the window: the display lost its surface too often"),
    QT_TRANSLATE_NOOP("Sentence", "shown by the window: the display's surface says nothing of itself"),
    QT_TRANSLATE_NOOP("Sentence", "shown by the window: the graphics device does not reach this display"),
    QT_TRANSLATE_NOOP("Sentence", "shown by the window: the display has no format that is known here"),
    QT_TRANSLATE_NOOP("Sentence", "shown by the window: nothing can be copied to the display's pictures"),
    QT_TRANSLATE_NOOP("Sentence", "baked pictures are turned off"),
    QT_TRANSLATE_NOOP("Sentence", "light bounces"),
    QT_TRANSLATE_NOOP("Sentence", "the work light is on"),
    QT_TRANSLATE_NOOP("Sentence", "a share of the pixels is asked for"),
    QT_TRANSLATE_NOOP("Sentence", "lux are measured on surfaces"),
    QT_TRANSLATE_NOOP("Sentence", "objects are hidden or shown by hand"),
    QT_TRANSLATE_NOOP("Sentence", "surfaces are set by hand"),
    QT_TRANSLATE_NOOP("Sentence", "air, even light or shadows are set by hand"),
    QT_TRANSLATE_NOOP("Sentence", "a remote control sets the haze"),
    QT_TRANSLATE_NOOP("Sentence", "a mover is not where the model has it"),
    QT_TRANSLATE_NOOP("Sentence", "a fixture identifies itself"),
    QT_TRANSLATE_NOOP("Sentence", "trackers may move what is on stage"),
    // words of the show file
    QT_TRANSLATE_NOOP("Sentence", "off"),
    QT_TRANSLATE_NOOP("Sentence", "room"),
    QT_TRANSLATE_NOOP("Sentence", "normal"),
    QT_TRANSLATE_NOOP("Sentence", "fine"),
    QT_TRANSLATE_NOOP("Sentence", "haze"),
    QT_TRANSLATE_NOOP("Sentence", "fog"),
    QT_TRANSLATE_NOOP("Sentence", "it is not baked"),
    QT_TRANSLATE_NOOP("Sentence", "its passes are not whole: bake it again"),
    QT_TRANSLATE_NOOP("Sentence", "baking"),
    QT_TRANSLATE_NOOP("Sentence", "baking: %1"),
    QT_TRANSLATE_NOOP("Sentence", "importing"),
    QT_TRANSLATE_NOOP("Sentence", "contact sheet"),
    QT_TRANSLATE_NOOP("Sentence", "contact sheet: %1"),
    QT_TRANSLATE_NOOP("Sentence", "rendering"),
    QT_TRANSLATE_NOOP("Sentence", "rendering: %1"),
    // what an action says that cannot be done
    QT_TRANSLATE_NOOP("Sentence", "no show is open"),
    QT_TRANSLATE_NOOP(
        "Sentence", "the show is being opened under its new name, which takes a moment: nothing is changed"),
    QT_TRANSLATE_NOOP("Sentence", "no fixture is selected"),
    QT_TRANSLATE_NOOP("Sentence", "no fixture is selected; Shift+R gives everything back"),
    QT_TRANSLATE_NOOP("Sentence",
                      "nothing of the selected fixtures is set by hand; Shift+R gives everything back"),
    QT_TRANSLATE_NOOP("Sentence", "nothing that is selected turns both ways"),
    QT_TRANSLATE_NOOP("Sentence", "there is no picture yet"),
    QT_TRANSLATE_NOOP("Sentence", "there is nothing but air to hide"),
    QT_TRANSLATE_NOOP("Sentence", "this is a fixture; Remove takes it away"),
    QT_TRANSLATE_NOOP("Sentence", "there is nothing but air to aim at"),
    QT_TRANSLATE_NOOP("Sentence", "%1 head does not reach that far, and turned as far as possible"),
    QT_TRANSLATE_NOOP("Sentence", "%1 heads do not reach that far, and turned as far as possible"),
    QT_TRANSLATE_NOOP("Sentence", "%1 of them do not reach that far, and turned as far as possible"),
    QT_TRANSLATE_NOOP("Sentence", "there is no action '%1', did you mean '%2'?"),
    QT_TRANSLATE_NOOP("Sentence", "there is no action '%1'"),
    QT_TRANSLATE_NOOP("Sentence", "takes no arguments, so what is '%1'?"),
    QT_TRANSLATE_NOOP("Sentence", "'%1' is a word too many: it takes %2"),
    QT_TRANSLATE_NOOP("Sentence", "'%1' is neither on nor off"),
    QT_TRANSLATE_NOOP("Sentence", "it needs the name of a file"),
    QT_TRANSLATE_NOOP("Sentence", "it needs the name of a folder"),
    QT_TRANSLATE_NOOP("Sentence", "a quote \" without its end"),
    QT_TRANSLATE_NOOP("Sentence", "'%1' is no %2 from %3 to %4"),
    QT_TRANSLATE_NOOP("Sentence", "it needs a %1 from %2 to %3"),
    QT_TRANSLATE_NOOP("Sentence", "number"),
    QT_TRANSLATE_NOOP("Sentence", "degrees"),
    QT_TRANSLATE_NOOP("Sentence", "metres"),
    QT_TRANSLATE_NOOP("Sentence", "metres a second"),
    QT_TRANSLATE_NOOP("Sentence", "direction"),
    QT_TRANSLATE_NOOP("Sentence", "place in metres"),
    QT_TRANSLATE_NOOP("Sentence", "spread in metres"),
    QT_TRANSLATE_NOOP("Sentence", "share"),
    QT_TRANSLATE_NOOP("Sentence", "share of the picture"),
    QT_TRANSLATE_NOOP("Sentence", "share of the width, on or off"),
    QT_TRANSLATE_NOOP("Sentence", "share of the pixels in percent, 0 for automatic,"),
    QT_TRANSLATE_NOOP("Sentence", "extinction per metre"),
    QT_TRANSLATE_NOOP("Sentence", "unevenness"),
    QT_TRANSLATE_NOOP("Sentence", "factor"),
    QT_TRANSLATE_NOOP("Sentence", "field of view"),
    QT_TRANSLATE_NOOP("Sentence", "number of seconds"),
    QT_TRANSLATE_NOOP("Sentence", "number of degrees"),
    QT_TRANSLATE_NOOP("Sentence", "number of kelvin"),
    QT_TRANSLATE_NOOP("Sentence", "number of lux"),
    QT_TRANSLATE_NOOP("Sentence", "number of samples"),
    QT_TRANSLATE_NOOP("Sentence", "number of samples per pixel"),
    QT_TRANSLATE_NOOP("Sentence", "number of bounces"),
    QT_TRANSLATE_NOOP("Sentence", "number of pictures a second"),
    QT_TRANSLATE_NOOP("Sentence", "first second"),
    QT_TRANSLATE_NOOP("Sentence", "last second"),
    QT_TRANSLATE_NOOP("Sentence", "slot, 0 is open,"),
    QT_TRANSLATE_NOOP("Sentence", "value"),
    QT_TRANSLATE_NOOP("Sentence", "least value"),
    QT_TRANSLATE_NOOP("Sentence", "largest value"),
    QT_TRANSLATE_NOOP("Sentence", "pixel from the left"),
    QT_TRANSLATE_NOOP("Sentence", "pixel from the top"),
    QT_TRANSLATE_NOOP("Sentence", "number of seconds, 'opened', 'picture', 'settled', 'saved' or 'jobs'"),
    QT_TRANSLATE_NOOP("Sentence", "there is no hazer '%1'; the show has %2"),
    QT_TRANSLATE_NOOP("Sentence", "hazer %1: expected %2 number, not %3"),
    QT_TRANSLATE_NOOP("Sentence", "hazer %1: expected %2 numbers, not %3"),
    QT_TRANSLATE_NOOP("Sentence", "hazer: expected place, direction, rate, spread or reach, not '%1'"),
    QT_TRANSLATE_NOOP("Sentence", "0 0 0 has no length, expected where the haze is blown, like 0 0 1"),
    QT_TRANSLATE_NOOP("Sentence", "the show has %1 cameras, no number %2"),
    QT_TRANSLATE_NOOP("Sentence", "the camera stands at what it looks at"),
    QT_TRANSLATE_NOOP("Sentence", "the show has no fixtures"),
    QT_TRANSLATE_NOOP("Sentence",
                      "has neither show.toml nor book.json: to compare with is a show, a plot or a book"),
    QT_TRANSLATE_NOOP("Sentence", "no further fixture is called '%1'"),
    QT_TRANSLATE_NOOP("Sentence", "no fixture is called '%1'"),
    QT_TRANSLATE_NOOP("Sentence", "the show has no cue: add one"),
    QT_TRANSLATE_NOOP("Sentence", "this was the last cue"),
    QT_TRANSLATE_NOOP("Sentence", "this is the first cue"),
    QT_TRANSLATE_NOOP("Sentence", "this is the last cue"),
    QT_TRANSLATE_NOOP("Sentence", "there is no cue number %1"),
    QT_TRANSLATE_NOOP("Sentence", "another cue is called '%1'"),
    QT_TRANSLATE_NOOP("Sentence", "a cue needs a name"),
    QT_TRANSLATE_NOOP("Sentence",
                      "'%1' is none of name, number, look, at, camera, flight, fade, follow, page and notes"),
    QT_TRANSLATE_NOOP("Sentence", "a cue needs a look, a camera or a place in the recording"),
    QT_TRANSLATE_NOOP("Sentence", "there is no cue '%1', did you mean '%2'?"),
    QT_TRANSLATE_NOOP("Sentence", "there is no cue '%1'"),
    QT_TRANSLATE_NOOP("Sentence", "'%1' is neither up nor down"),
    QT_TRANSLATE_NOOP("Sentence", "'%1' is no size like 1920x1080, 16 to 8192 each way"),
    QT_TRANSLATE_NOOP("Sentence",
                      "'%1' is neither a size like 1920x1080, 16 to 8192 each way, nor a camera of the show"),
    QT_TRANSLATE_NOOP("Sentence", "nothing runs in the background"),
    QT_TRANSLATE_NOOP("Sentence", "the name must end in .%1"),
    QT_TRANSLATE_NOOP("Sentence", "no such folder"),
    QT_TRANSLATE_NOOP("Sentence", "no such file"),
    QT_TRANSLATE_NOOP("Sentence", "no such file or folder"),
    QT_TRANSLATE_NOOP("Sentence", "save the show first (Ctrl+S): what runs in the background reads its file"),
    QT_TRANSLATE_NOOP("Sentence", "a film shows the recording of the show, and it has none"),
    QT_TRANSLATE_NOOP("Sentence", "the film must end after it begins"),
    QT_TRANSLATE_NOOP("Sentence", "nothing lights the picture: the show has no recording and nothing is set "
                                  "by hand; 'save-picture' saves what a desk does now"),
    QT_TRANSLATE_NOOP("Sentence", "no selected fixture has '%1', did you mean '%2'?"),
    QT_TRANSLATE_NOOP("Sentence", "no selected fixture has '%1'"),
    QT_TRANSLATE_NOOP("Sentence", "'%1' is dark or turns its wheel, and nobody set its %2 by hand"),
    QT_TRANSLATE_NOOP("Sentence", "'%1' is no colour like #ff8000"),
    QT_TRANSLATE_NOOP("Sentence", "'%1' is none of 8, 16 and 24 bits"),
    QT_TRANSLATE_NOOP("Sentence", "'%1' is none of %2"),
    QT_TRANSLATE_NOOP("Sentence", "'%1' is neither first nor last"),
    QT_TRANSLATE_NOOP("Sentence",
                      "colours go from one to the other (line or symmetric), not to both sides of one"),
    QT_TRANSLATE_NOOP("Sentence",
                      "nothing of '%1' is set by hand; name what all shall have, or hold it first"),
    QT_TRANSLATE_NOOP("Sentence", "everything of the selected fixtures is the hand's already"),
    QT_TRANSLATE_NOOP("Sentence", "does not lie like a truss or a pipe, so nothing hangs under it"),
    QT_TRANSLATE_NOOP("Sentence",
                      "has no room beside what hangs there for %1 more; take fewer, or hang them elsewhere"),
    QT_TRANSLATE_NOOP("Sentence", "there is no object '%1'"),
    QT_TRANSLATE_NOOP("Sentence", "the stage has no truss or pipe to hang them under"),
    QT_TRANSLATE_NOOP("Sentence", "'%1' is no truss or pipe that lies"),
    QT_TRANSLATE_NOOP("Sentence", "'%1' is neither off nor a colour like #ff8000"),
    QT_TRANSLATE_NOOP("Sentence",
                      "no object of the stage is chosen: double click one, or choose it in Scene"),
    QT_TRANSLATE_NOOP("Sentence", "the stage has no object '%1', did you mean '%2'?"),
    QT_TRANSLATE_NOOP("Sentence", "the stage has no object '%1'"),
    QT_TRANSLATE_NOOP("Sentence", "there is no such object"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "%1 objects are called '%2', and a show knows them by name: in the model give each its own"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "nothing of %1 is set by hand for the selected fixtures; 'hold' takes what the desk asks for"),
    QT_TRANSLATE_NOOP("Sentence", "no selected fixture has anything of the palette '%1'"),
    QT_TRANSLATE_NOOP("Sentence", "another palette is called '%1'"),
    QT_TRANSLATE_NOOP("Sentence",
                      "'%1' is no address like 2.101 (universe 1 to 63999, channel 1 to 512), nor 'none'"),
    QT_TRANSLATE_NOOP("Sentence", "align: expected x, y or z"),
    QT_TRANSLATE_NOOP("Sentence", "'%1' is no name: 1 to 100 bytes, no leading dot, none of /\\:*?\"<>|"),
    QT_TRANSLATE_NOOP("Sentence", "another fixture is called '%1'"),
    QT_TRANSLATE_NOOP("Sentence", "has no fixture file that can be read"),
    QT_TRANSLATE_NOOP("Sentence", "hangs on a track, which says where it is"),
    QT_TRANSLATE_NOOP("Sentence", "three fixtures or more can be spread evenly"),
    QT_TRANSLATE_NOOP("Sentence", "is of the plot, which only its own program can add to"),
    QT_TRANSLATE_NOOP("Sentence", "another file of this name lies beside the show already; rename the new "
                                  "one, or put it there yourself and the show takes it"),
    QT_TRANSLATE_NOOP("Sentence", "'%1' is no name of a camera: it names a folder"),
    QT_TRANSLATE_NOOP("Sentence", "another camera is called '%1'"),
    QT_TRANSLATE_NOOP("Sentence", "camera '%1' is made from where the fixtures hang, for the show has none "
                                  "of its own; keep one first (Ctrl+K)"),
    QT_TRANSLATE_NOOP("Sentence", "has no camera number %1"),
    QT_TRANSLATE_NOOP("Sentence",
                      "has a [[camera]] that cannot be read (Messages say which); mend it there first"),
    QT_TRANSLATE_NOOP("Sentence",
                      "the picture stands at no camera of the show: go to one, or keep this one (Ctrl+K)"),
    QT_TRANSLATE_NOOP("Sentence", "camera '%1' is the last one of the show; keep another one first (Ctrl+K)"),
    QT_TRANSLATE_NOOP(
        "Sentence", "camera '%1' cannot be removed: cue '%2' goes to it; give that cue another camera first"),
    QT_TRANSLATE_NOOP("Sentence", "camera '%1' cannot be removed: a tracker moves it"),
    QT_TRANSLATE_NOOP("Sentence",
                      "look '%1' cannot be removed: cue '%2' recalls it; give that cue another look first"),
    QT_TRANSLATE_NOOP("Sentence", "camera '%1' cannot be removed: mover '%2' carries it"),
    QT_TRANSLATE_NOOP("Sentence", "it needs a camera and its new name"),
    QT_TRANSLATE_NOOP("Sentence", "is no model, expected .glb, .gltf, .obj or .3ds"),
    QT_TRANSLATE_NOOP("Sentence",
                      "the show has a plot; 'ghostlight import' into its folder merges a newer one"),
    QT_TRANSLATE_NOOP("Sentence", "is no plot, expected .mvr"),
    QT_TRANSLATE_NOOP("Sentence", "has no DMX mode"),
    QT_TRANSLATE_NOOP("Sentence", "a recording runs; 'record off' ends it"),
    QT_TRANSLATE_NOOP("Sentence", "nothing was recorded in this window"),
    QT_TRANSLATE_NOOP("Sentence", "it must end after it begins"),
    QT_TRANSLATE_NOOP("Sentence",
                      "[[cue]] names look '%1', which the show does not have, did you mean '%2'?"),
    QT_TRANSLATE_NOOP("Sentence", "[[cue]] names look '%1', which the show does not have"),
    QT_TRANSLATE_NOOP("Sentence",
                      "[[cue]] names camera '%1', which the show does not have, did you mean '%2'?"),
    QT_TRANSLATE_NOOP("Sentence", "[[cue]] names camera '%1', which the show does not have"),
    QT_TRANSLATE_NOOP("Sentence", "is there and is no cue book that Ghostlight made (which .ghostlight in it "
                                  "would tell), with '%1' in it: it is not replaced"),
    QT_TRANSLATE_NOOP("Sentence", "is there and is no paperwork that Ghostlight made (which .ghostlight in "
                                  "it would tell), with '%1' in it: it is not replaced"),
    QT_TRANSLATE_NOOP("Sentence",
                      "has '%1', which Ghostlight did not make: it is not replaced before that is "
                      "elsewhere"),
    QT_TRANSLATE_NOOP("Sentence",
                      "has '%1', which somebody changed: it is not replaced before that is elsewhere"),
    QT_TRANSLATE_NOOP("Sentence", "the show has no mover '%1', did you mean '%2'?"),
    QT_TRANSLATE_NOOP("Sentence", "the show has no mover '%1'"),
    QT_TRANSLATE_NOOP("Sentence", "mover '%1' has %2 axes, expected a number for each, or off"),
    QT_TRANSLATE_NOOP("Sentence", "does not lie like a truss or a pipe, so no hoists hold it"),
    QT_TRANSLATE_NOOP("Sentence", "goes with mover '%1' already"),
    QT_TRANSLATE_NOOP("Sentence", "is the name of another mover"),
    QT_TRANSLATE_NOOP("Sentence", "'%1' would end at channel %2 of its universe, expected at most 512"),
    QT_TRANSLATE_NOOP("Sentence", "has no [[mover]] '%1'"),
    QT_TRANSLATE_NOOP("Sentence", "has an axis of '%1' that cannot be read; mend it there first"),
    QT_TRANSLATE_NOOP("Sentence", "has an axis of '%1' that is no table"),
    QT_TRANSLATE_NOOP("Sentence",
                      "nothing that a mover carries is selected: click a lamp on it, or double click it"),
    QT_TRANSLATE_NOOP("Sentence", "'%1' is neither commanded nor machine"),
    QT_TRANSLATE_NOOP("Sentence", "there is no such fixture any more"),
    QT_TRANSLATE_NOOP("Sentence", "the fixture has no such mode any more"),
    QT_TRANSLATE_NOOP("Sentence", "'%1', expected off, read or edit"),
    QT_TRANSLATE_NOOP("Sentence", "one of the factors must be above 0"),
    QT_TRANSLATE_NOOP("Sentence", "there is no material '%1'"),
    QT_TRANSLATE_NOOP("Sentence", "'%1' is none of specular, roughness, shininess"),
    QT_TRANSLATE_NOOP("Sentence", "the show is not open: %1"),
    QT_TRANSLATE_NOOP("Sentence", "no show is being opened"),
    QT_TRANSLATE_NOOP("Sentence", "a quarter of an hour went by without it"),
    QT_TRANSLATE_NOOP("Sentence", "is there already; a new show needs a name of its own"),
    QT_TRANSLATE_NOOP("Sentence",
                      "is there already: another name, or over it (in a script: save-as FILE over)"),
    QT_TRANSLATE_NOOP("Sentence", "cannot be made: %1"),
    QT_TRANSLATE_NOOP("Sentence", "what a show names lies beside it, so under another name it stays in %1; a "
                                  "copy of the file alone: Save a copy of the show file"),
    QT_TRANSLATE_NOOP("Sentence",
                      "is no .mvr, as Vectorworks, Capture, grandMA3 and Production Assist export it"),
    QT_TRANSLATE_NOOP("Sentence", "the guide is not installed beside this program"),
    QT_TRANSLATE_NOOP("Sentence", "no program was found that opens it"),
    QT_TRANSLATE_NOOP("Sentence", "what is not saved can be kept nowhere"),
    QT_TRANSLATE_NOOP("Sentence", "looks cannot be stored before this is mended, for that would lose it: %1"),
    QT_TRANSLATE_NOOP("Sentence", "was changed by another program and is read again; once more, please"),
    QT_TRANSLATE_NOOP("Sentence", "there are %1 looks; remove one first"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "nothing is set by hand; 'Store what is seen' in Looks stores what a desk or recording does"),
    QT_TRANSLATE_NOOP("Sentence", "there is no look yet: store one"),
    QT_TRANSLATE_NOOP("Sentence", "another look is called '%1'"),
    QT_TRANSLATE_NOOP("Sentence", "there is no look '%1', did you mean '%2'?"),
    QT_TRANSLATE_NOOP("Sentence", "there is no look '%1'"),
    QT_TRANSLATE_NOOP("Sentence", "there is no palette '%1', did you mean '%2'?"),
    QT_TRANSLATE_NOOP("Sentence", "there is no palette '%1'"),
    QT_TRANSLATE_NOOP("Sentence", "a plot that is opened as it is cannot be edited; make a show of it "
                                  "first (in a script: import-plot)"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "is open in another window: %1; close it there, or take it over (in a script: take-over)"),
    QT_TRANSLATE_NOOP("Sentence",
                      "changes of an earlier time wait: take them or drop them first (Edit menu)"),
    QT_TRANSLATE_NOOP("Sentence", "another window has the show, and what is not saved here is kept nowhere"),
    QT_TRANSLATE_NOOP("Sentence", "%1: nobody can say whether another program changed it; save yours over it "
                                  "(in a script: save over), or save a copy"),
    QT_TRANSLATE_NOOP("Sentence", "was changed by another program since it was read here: take what the file "
                                  "says, or save yours over it (in a script: reload, save over)"),
    QT_TRANSLATE_NOOP("Sentence", "is the show file itself, which 'save' writes"),
    QT_TRANSLATE_NOOP("Sentence", "there are no changes of an earlier time"),
    QT_TRANSLATE_NOOP("Sentence", "no other window has this show open"),
    QT_TRANSLATE_NOOP("Sentence", "'%1' is none of lux, luminance and off"),
    QT_TRANSLATE_NOOP("Sentence", "the largest value must be at least half as large again as the least"),
    QT_TRANSLATE_NOOP("Sentence", "'%1' is none of on, off and a place X Y"),
    QT_TRANSLATE_NOOP("Sentence", "'%1' is none of on, off and auto"),
    QT_TRANSLATE_NOOP("Sentence", "another show was opened: no fixture file is substituted"),
    QT_TRANSLATE_NOOP("Sentence", "the plot was not imported: no fixture file is substituted"),
    QT_TRANSLATE_NOOP("Sentence", "another show was opened meanwhile; it is left as it is"),
    QT_TRANSLATE_NOOP("Sentence", "another show was opened meanwhile; its own recording plays"),
    QT_TRANSLATE_NOOP("Sentence", "the window was closed before it was done"),
    QT_TRANSLATE_NOOP("Sentence", "another plot is being imported: take it when that is done"),
    QT_TRANSLATE_NOOP("Sentence",
                      "the show that was made of the plot cannot be opened: no fixture file is substituted"),
    QT_TRANSLATE_NOOP("Sentence", "no show is open, or it is still being looked through"),
    QT_TRANSLATE_NOOP("Sentence",
                      "the page of the plot has no fixtures of a file, a kind or a title called so"),
    QT_TRANSLATE_NOOP("Sentence", "it needs the file to stand in, too"),
    QT_TRANSLATE_NOOP("Sentence", "there is no fixture file that seems to be the same"),
    QT_TRANSLATE_NOOP("Sentence", "there is one display only; View has 'The picture in a second window' (in "
                                  "a script: second-display window)"),
    QT_TRANSLATE_NOOP("Sentence", "there is no display '%1'; there are %2"),
    QT_TRANSLATE_NOOP(
        "Sentence", "there is no folder 'demo' beside this program (assets/demo, or share/ghostlight/demo)"),
    QT_TRANSLATE_NOOP("Sentence", "no plot came from the network (MVR-xchange)"),
    QT_TRANSLATE_NOOP("Sentence", "the picture cannot be written"),
    QT_TRANSLATE_NOOP("Sentence", "changes are saved nowhere: save a copy elsewhere, or close and lose them "
                                  "(in a script: quit anyway)"),
    QT_TRANSLATE_NOOP("Sentence", "there is nothing to undo"),
    QT_TRANSLATE_NOOP("Sentence", "there is nothing to redo"),
    QT_TRANSLATE_NOOP("Sentence", "this window keeps nothing: it was started with --forget"),
    QT_TRANSLATE_NOOP("Sentence", "'%1', expected off, or a port like 8010 or 0.0.0.0:8010"),
    QT_TRANSLATE_NOOP("Sentence", "nothing listens to browsers: View, In browsers..."),
    QT_TRANSLATE_NOOP("Sentence", "bounced light is '%1', expected %2"),
    QT_TRANSLATE_NOOP("Sentence", "haze is '%1', expected one of %2"),
    QT_TRANSLATE_NOOP("Sentence", "this machine alone"),
    QT_TRANSLATE_NOOP("Sentence", "%1. %2 has a cable and no IPv4 address (no DHCP server answers, perhaps): "
                                  "for Art-Net, and for sACN by IPv4, it needs one in the desk's network"),
    QT_TRANSLATE_NOOP("Sentence", "%1. %2 gave itself %3, as a machine does that no DHCP server answers: for "
                                  "Art-Net the desk has to be in 169.254.x.x, too"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "%1. The reverse path filter of this machine dropped %2 in the last seconds, of senders that it "
        "would "
        "not answer by the card that they came by: if they are the desk's, give that card an address in the "
        "desk's network (or, as root: sysctl -w net.ipv4.conf.all.rp_filter=2, and the same for the card)"),
    QT_TRANSLATE_NOOP("Sentence", "%1. A desk on this very machine has to send unicast to 127.0.0.1: "
                                  "multicast of QLC+ does not come back here"),
    QT_TRANSLATE_NOOP(
        "Sentence",
        "%1. To tell them apart: where '%2' shows packets to an address of ours, to its broadcast or to the "
        "group of a universe of ours (239.255.0.1, ff18::.. for 1), a firewall or the reverse path filter of "
        "this machine drops them, or their sender has an address of ours; to another broadcast, the masks "
        "differ; to another group, it is another universe; where it shows none at all, they do not get here: "
        "a cable, another VLAN, a switch that holds multicast back (IGMP snooping without a querier), a desk "
        "that sends to other addresses alone (unicast), or one that is silent"),
};

} // namespace

std::span<const char* const> sentence_list() {
    return kSentences;
}

} // namespace ghost::ui
