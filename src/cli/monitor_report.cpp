// SPDX-License-Identifier: Apache-2.0
#include "cli/private/monitor_report.h"

#include "base/print.h"
#include "diagnose/diagnosis.h"
#include "diagnose/diagnosis_parts.h"

#include <nlohmann/json.hpp>

namespace ghost::app {

namespace {

using Json = nlohmann::ordered_json;

double seconds_of(std::chrono::nanoseconds time) {
    return std::chrono::duration<double>(time).count();
}

double age_s(const dmx::Universe& universe) {
    return seconds_of(std::chrono::steady_clock::now().time_since_epoch() - universe.arrival);
}

// What is on the network beside the levels we show.
Json network_json(const dmx::Statistics& statistics) {
    Json network{{"sampling", statistics.sampling}};
    for (const char* list : {"sync", "discovered", "unlisted", "sockets", "links", "triggers"})
        network[list] = Json::array();
    for (const dmx::SyncStatus& sync : statistics.sync)
        network["sync"].push_back({{"id", dmx::source_id(sync.source)},
                                   {"universe", sync.universe},
                                   {"packets", sync.packets},
                                   {"late", sync.late},
                                   {"age_s", seconds_of(sync.age)}});
    for (const dmx::DiscoveredSource& source : statistics.discovered)
        network["discovered"].push_back({{"protocol", dmx::protocol_name(source.protocol)},
                                         {"id", source.id},
                                         {"name", source.name},
                                         {"from", dmx::address_text(source.from)},
                                         {"universes", *source.universes},
                                         {"age_s", seconds_of(source.age)}});
    for (const dmx::UnlistedUniverse& universe : statistics.unlisted_universes)
        network["unlisted"].push_back({{"universe", universe.universe},
                                       {"protocol", dmx::protocol_name(universe.protocol)},
                                       {"from", dmx::address_text(universe.from)},
                                       {"packets", universe.packets},
                                       {"age_s", seconds_of(universe.age)}});
    for (const dmx::SocketStatus& socket : statistics.sockets)
        network["sockets"].push_back({{"name", socket.name},
                                      {"ipv6", socket.ipv6},
                                      {"groups", socket.groups},
                                      {"receive_buffer_bytes", socket.receive_buffer_bytes},
                                      {"packets", socket.packets},
                                      {"kernel_overflow", socket.overflow}});
    for (const dmx::LinkChange& change : statistics.link_changes)
        network["links"].push_back({{"number", change.number}, {"text", change.text}});
    for (const dmx::TriggerStatus& trigger : statistics.triggers)
        network["triggers"].push_back({{"number", trigger.number},
                                       {"text", dmx::trigger_text(trigger.trigger)},
                                       {"from", dmx::address_text(trigger.from)}});
    if (statistics.timecode)
        network["timecode"] = {{"time", dmx::timecode_text(statistics.timecode->time)},
                               {"from", dmx::address_text(statistics.timecode->from)},
                               {"packets", statistics.timecode->packets},
                               {"age_s", seconds_of(statistics.time - statistics.timecode->arrival)}};
    network["wire_to_store_ms"] = {{"count", statistics.latency.count()},
                                   {"p50", statistics.latency.percentile_ms(0.5)},
                                   {"p99", statistics.latency.percentile_ms(0.99)},
                                   {"max", statistics.latency.max_ms()}};
    network["port_users"] = Json::array();
    for (const dmx::PortUser& user : statistics.port_users)
        network["port_users"].push_back({{"port", user.port},
                                         {"address", dmx::address_text(user.address)},
                                         {"pid", user.pid},
                                         {"program", user.program}});
    return network;
}

const char* state_text(const dmx::UsbPortStatus& port) {
    return port.answered ? "ok" : port.open ? "no answer" : "not open";
}

Json usb_json(const dmx::Statistics& statistics) {
    Json ports = Json::array();
    for (const dmx::UsbPortStatus& port : statistics.usb)
        ports.push_back({{"port", port.path},
                         {"universe", port.universe},
                         {"state", state_text(port)},
                         {"problem", port.problem},
                         {"serial", port.serial},
                         {"firmware", port.firmware},
                         {"openings", port.openings},
                         {"frames", port.counters.frames},
                         {"overruns", port.counters.overruns},
                         {"not_levels", port.counters.not_levels},
                         {"malformed", port.counters.malformed},
                         {"other_labels", port.counters.other_labels},
                         {"skipped_bytes", port.counters.skipped_bytes}});
    return ports;
}

const char* state_text(const dmx::MidiStatus& midi) {
    return !midi.open ? "not open" : midi.time ? "ok" : "no time code";
}

Json midi_json(const dmx::Statistics& statistics) {
    const dmx::MidiStatus& midi = statistics.midi;
    if (midi.path.empty()) return nullptr;
    Json result{{"port", midi.path},
                {"state", state_text(midi)},
                {"problem", midi.problem},
                {"openings", midi.openings},
                {"bytes", midi.counters.bytes},
                {"quarter_frames", midi.counters.quarter_frames},
                {"full_frames", midi.counters.full_frames},
                {"malformed", midi.counters.malformed}};
    if (midi.time) {
        result["time"] = dmx::timecode_text(*midi.time);
        result["age_s"] = seconds_of(statistics.time - midi.arrival);
    }
    return result;
}

const char* state_text(const LtcStatus& ltc) {
    return !ltc.open ? "not open" : ltc.time ? "ok" : "no time code";
}

constexpr double kSilent_dbfs = -60;

Json ltc_json(const std::optional<LtcStatus>& ltc) {
    if (!ltc) return nullptr;
    Json result{{"input", ltc->name},
                {"state", state_text(*ltc)},
                {"problem", ltc->problem},
                {"openings", ltc->openings},
                {"loudest_dbfs", ltc->loudest_dbfs}};
    if (ltc->time) {
        result["time"] = dmx::timecode_text(*ltc->time);
        result["age_s"] = seconds_of(std::chrono::steady_clock::now().time_since_epoch() - ltc->arrival);
        result["channel"] = ltc->channel;
        result["backwards"] = ltc->counters.is_backwards;
        result["level_dbfs"] = ltc->counters.level_dbfs;
        result["frames"] = ltc->counters.frames;
        result["left_out"] = ltc->counters.left_out;
    }
    return result;
}

Json diagnosis_json(const std::vector<scene::Sentence>& sentences) {
    Json list = Json::array();
    for (const scene::Sentence& sentence : sentences)
        list.push_back({{"trouble", scene::trouble_name(sentence.trouble)},
                        {"problem", sentence.is_problem},
                        {"text", sentence.text}});
    return list;
}

} // namespace

std::string monitor_json(const MonitorReport& from, bool levels) {
    const dmx::Universes& universes = from.universes;
    const dmx::Statistics& statistics = from.statistics;
    Json report;
    report["time"] = from.unix_s;
    report["universes"] = Json::array();
    for (const dmx::Universe& universe : universes.list) {
        Json entry{{"universe", universe.number},
                   {"lost", universe.lost},
                   {"black", universe.black},
                   {"age_s", age_s(universe)}};
        if (from.has_patch) entry["patched"] = from.patch.has(universe.number);
        if (levels) entry["levels"] = *universe.levels;
        report["universes"].push_back(std::move(entry));
    }
    report["sources"] = Json::array();
    for (const dmx::SourceStatus& source : statistics.sources)
        report["sources"].push_back({{"universe", source.universe},
                                     {"protocol", dmx::protocol_name(source.protocol)},
                                     {"id", source.id},
                                     {"name", source.name},
                                     {"from", dmx::place_text(source)},
                                     {"state", dmx::source_state_name(source.state)},
                                     {"preview", source.preview},
                                     {"wrong_group", source.wrong_group},
                                     {"wrong_length", source.wrong_length},
                                     {"sync_universe", source.sync_universe},
                                     {"held", source.held},
                                     {"priority", source.priority},
                                     {"per_address_priority", source.per_address_priority},
                                     {"slots", source.slot_count},
                                     {"packets", source.packets},
                                     {"slots_held", source.slots_held},
                                     {"role", scene::role_text(source, statistics.sources)},
                                     {"rate_hz", source.rate_hz},
                                     {"jitter_ms", source.jitter_ms},
                                     {"missed", source.missed},
                                     {"out_of_sequence", source.out_of_sequence},
                                     {"other_way", source.other_way},
                                     {"age_s", seconds_of(source.age)}});
    Json counters{{"packets_sacn", statistics.packets_sacn},
                  {"packets_artnet", statistics.packets_artnet},
                  {"unlisted", statistics.unlisted},
                  {"kernel_overflow", statistics.overflow},
                  {"wrong_group", statistics.wrong_group},
                  {"wrong_length", statistics.wrong_length},
                  {"pauses", statistics.pauses},
                  {"polls_refused", statistics.polls_refused},
                  {"poll_replies_sent", statistics.poll_replies_sent},
                  {"announcements_sent", statistics.announcements_sent},
                  {"preview", statistics.merge.preview},
                  {"missed", statistics.merge.missed},
                  {"out_of_sequence", statistics.merge.out_of_sequence},
                  {"other_way", statistics.merge.other_way},
                  {"held", statistics.merge.held},
                  {"sources_replaced", statistics.merge.sources_replaced},
                  {"too_many_sources", statistics.merge.too_many_sources},
                  {"too_many_universes", statistics.merge.too_many_universes},
                  {"universes_forgotten", statistics.merge.universes_forgotten},
                  {"sources_lost", statistics.merge.sources_lost},
                  {"sources_terminated", statistics.merge.sources_terminated}};
    for (std::size_t i = 0; i < statistics.notices.size(); ++i)
        counters["notices"][dmx::notice_name(static_cast<dmx::Notice>(i))] = statistics.notices[i];
    for (std::size_t i = 0; i < statistics.drops.size(); ++i)
        counters["drops"][dmx::drop_name(static_cast<dmx::Drop>(i))] = statistics.drops[i];
    report["counters"] = std::move(counters);
    report["network"] = network_json(statistics);
    report["usb"] = usb_json(statistics);
    report["midi"] = midi_json(statistics);
    report["ltc"] = ltc_json(from.ltc);
    if (from.has_patch) {
        report["patch"] = Json::array();
        for (const scene::PatchedUniverse& one : from.patch.universes())
            report["patch"].push_back(
                {{"universe", one.universe}, {"fixtures", one.fixtures}, {"first", one.first}});
    }
    report["diagnosis"] = diagnosis_json(scene::diagnose(statistics, from.patch));
    return report.dump(-1, ' ', false, Json::error_handler_t::replace);
}

namespace {

void print_usb_port(const dmx::UsbPortStatus& port) {
    const std::string place = one_line(port.path) + ", universe " + std::to_string(port.universe);
    if (!port.open)
        print_text("%s: %s\n", place.c_str(), one_line(port.problem).c_str());
    else if (!port.answered)
        print_text("%s: nobody answers; is it a DMX USB Pro? (An Open DMX USB cannot receive)\n",
                   place.c_str());
    else
        print_text(
            "%s: DMX USB Pro %s, firmware %s; frames %llu, overruns %llu, not levels %llu, not understood "
            "%llu and %llu bytes\n",
            place.c_str(), one_line(port.serial).c_str(), one_line(port.firmware).c_str(),
            static_cast<unsigned long long>(port.counters.frames),
            static_cast<unsigned long long>(port.counters.overruns),
            static_cast<unsigned long long>(port.counters.not_levels),
            static_cast<unsigned long long>(port.counters.malformed + port.counters.other_labels),
            static_cast<unsigned long long>(port.counters.skipped_bytes));
}

void print_midi_port(const dmx::MidiStatus& midi) {
    if (midi.path.empty()) return;
    const std::string path = one_line(midi.path);
    if (!midi.open)
        print_text("%s: %s\n", path.c_str(), one_line(midi.problem).c_str());
    else if (!midi.time)
        print_text("%s: MIDI, %llu bytes and no time code yet\n", path.c_str(),
                   static_cast<unsigned long long>(midi.counters.bytes));
    else
        print_text("%s: MIDI time code %s; quarter frames %llu, full frames %llu, no times %llu\n",
                   path.c_str(), dmx::timecode_text(*midi.time).c_str(),
                   static_cast<unsigned long long>(midi.counters.quarter_frames),
                   static_cast<unsigned long long>(midi.counters.full_frames),
                   static_cast<unsigned long long>(midi.counters.malformed));
}

void print_ltc(const LtcStatus& ltc) {
    const std::string name = one_line(ltc.name);
    if (!ltc.time)
        print_text("%s: %s\n", name.c_str(),
                   !ltc.open && ltc.problem.empty()  ? "it has ended, and no time code (LTC) was in it"
                   : !ltc.open                       ? ltc.problem.c_str()
                   : ltc.loudest_dbfs < kSilent_dbfs ? "silent: is the cable in, is the input turned up?"
                                                     : "a sound, and no time code (LTC) in it yet");
    else
        print_text("%s: LTC %s%s, channel %d, %.0f dBFS; frames %llu, left out %llu%s\n", name.c_str(),
                   dmx::timecode_text(*ltc.time).c_str(), ltc.counters.is_backwards ? " backwards" : "",
                   ltc.channel, ltc.counters.level_dbfs, static_cast<unsigned long long>(ltc.counters.frames),
                   static_cast<unsigned long long>(ltc.counters.left_out), ltc.open ? "" : "; it has ended");
}

} // namespace

void print_monitor_table(const MonitorReport& from) {
    const dmx::Universes& universes = from.universes;
    const dmx::Statistics& statistics = from.statistics;
    print_text("%-8s %-7s %-15s %4s %5s %7s %7s %7s %6s  %-14s %s\n", "universe", "from", "address", "prio",
               "slots", "rate/s", "jitter", "missed", "age s", "is", "source");
    for (const dmx::SourceStatus& source : statistics.sources)
        print_text("%-8d %-7s %-15s %4d %5d %7.1f %7.1f %7llu %6.1f  %-14s %s%s%s\n", source.universe,
                   dmx::protocol_name(source.protocol), one_line(dmx::place_text(source)).c_str(),
                   source.priority, source.slot_count, source.rate_hz, source.jitter_ms,
                   static_cast<unsigned long long>(source.missed), seconds_of(source.age),
                   scene::role_text(source, statistics.sources).c_str(),
                   source.protocol == dmx::Protocol::artnet ? source.id.c_str()
                                                            : one_line(source.name).c_str(),
                   source.per_address_priority ? " (priority per address)" : "",
                   from.has_patch && !from.patch.has(source.universe) ? " (not patched)" : "");
    for (const dmx::Universe& universe : universes.list)
        if (universe.lost)
            print_text("%-8d LOST %.1f s ago, %s\n", universe.number, age_s(universe),
                       universe.black ? "black" : "last look held");
    for (const dmx::UsbPortStatus& port : statistics.usb) print_usb_port(port);
    print_midi_port(statistics.midi);
    if (from.ltc) print_ltc(*from.ltc);
    if (statistics.sampling) print_text("finding out who sends; levels show after 1.5 s\n");
    if (statistics.timecode)
        print_text("time code %s from %s\n", dmx::timecode_text(statistics.timecode->time).c_str(),
                   dmx::address_text(statistics.timecode->from).c_str());
    std::uint64_t dropped = 0;
    for (const std::uint64_t count : statistics.drops) dropped += count;
    print_text(
        "packets: sACN %llu, Art-Net %llu; not listed %llu, not understood %llu, of wrong length %llu, "
        "preview %llu, late %llu, kernel overflow %llu; polls answered with %llu replies\n",
        static_cast<unsigned long long>(statistics.packets_sacn),
        static_cast<unsigned long long>(statistics.packets_artnet),
        static_cast<unsigned long long>(statistics.unlisted), static_cast<unsigned long long>(dropped),
        static_cast<unsigned long long>(statistics.wrong_length),
        static_cast<unsigned long long>(statistics.merge.preview),
        static_cast<unsigned long long>(statistics.merge.out_of_sequence),
        static_cast<unsigned long long>(statistics.overflow),
        static_cast<unsigned long long>(statistics.poll_replies_sent));
    for (const scene::Sentence& sentence : scene::diagnose(statistics, from.patch))
        print_text("%s %s\n", sentence.is_problem ? "!" : "-", sentence.text.c_str());
    print_text("\n");
}

} // namespace ghost::app
