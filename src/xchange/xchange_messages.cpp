// SPDX-License-Identifier: Apache-2.0
#include "xchange/protocol.h"

#include "base/report.h"
#include "json_xml_toml/json.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

namespace ghost::scene {

namespace {

using Json = nlohmann::json;

constexpr int kMvrMajor = 1, kMvrMinor = 6;

std::string small(std::string text) {
    for (char& letter : text) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return text;
}

// For people and file names: cut, and without what moves a terminal's cursor.
std::string plain(std::string text) {
    if (text.size() > kMaxXchangeText) text.resize(kMaxXchangeText);
    for (char& letter : text)
        if (static_cast<unsigned char>(letter) < 0x20 || letter == 0x7F) letter = ' ';
    return text;
}

// Keys differ in capitals from program to program.
const Json* find(const Json& object, std::initializer_list<const char*> keys) {
    for (const char* const key : keys) {
        if (const auto found = object.find(key); found != object.end()) return &*found;
        for (auto entry = object.begin(); entry != object.end(); ++entry)
            if (small(entry.key()) == small(key)) return &*entry;
    }
    return nullptr;
}

std::string text_of(const Json* value) {
    if (!value) return "";
    if (value->is_array()) return value->empty() ? "" : text_of(&value->front());
    return value->is_string() ? plain(value->get<std::string>()) : "";
}

std::string uuid_from(std::string text) {
    text = small(std::move(text));
    std::erase_if(text, [](char letter) { return letter == '{' || letter == '}' || letter == ' '; });
    return text.substr(0, 64);
}

bool truth_of(const Json* value, bool otherwise) {
    if (!value) return otherwise;
    if (value->is_boolean()) return value->get<bool>();
    if (value->is_number()) return value->get<double>() != 0.0;
    if (value->is_string())
        return small(value->get<std::string>()) == "true" || value->get<std::string>() == "1";
    return otherwise;
}

std::uint64_t size_of(const Json* value) {
    std::uint64_t size = 0;
    if (!value) return size;
    if (value->is_number()) {
        const double number = value->get<double>();
        return number > 0.0 && number < 1e18 ? static_cast<std::uint64_t>(number) : 0;
    }
    if (value->is_string()) {
        const std::string text = value->get<std::string>();
        if (std::from_chars(text.data(), text.data() + text.size(), size).ec != std::errc()) size = 0;
    }
    return size;
}

XchangeCommit commit_from(const Json& object) {
    XchangeCommit commit;
    commit.asked_as = text_of(find(object, {"FileUUID"}));
    commit.file_uuid = uuid_from(commit.asked_as);
    commit.station_asked_as = text_of(find(object, {"StationUUID"}));
    commit.station_uuid = uuid_from(commit.station_asked_as);
    commit.file_name = text_of(find(object, {"FileName"}));
    commit.comment = text_of(find(object, {"Comment"}));
    commit.file_size = size_of(find(object, {"FileSize"}));
    const Json* const stations = find(object, {"ForStationsUUID", "ForStations"});
    if (stations && stations->is_array())
        for (const Json& station : *stations)
            if (station.is_string() && commit.for_stations.size() < kMostXchangeCommits)
                commit.for_stations.push_back(uuid_from(plain(station.get<std::string>())));
    std::erase(commit.for_stations, "");
    return commit;
}

Json json_of(const XchangeCommit& commit) {
    return {{"Type", "MVR_COMMIT"},
            {"verMajor", kMvrMajor},
            {"verMinor", kMvrMinor},
            {"FileSize", commit.file_size},
            {"FileUUID", commit.file_uuid},
            {"StationUUID", commit.station_uuid},
            {"ForStationsUUID", Json::array()},
            {"Comment", commit.comment},
            {"FileName", commit.file_name}};
}

} // namespace

Result<XchangeMessage> parse_xchange_message(std::string_view text) {
    // A zero at the end is sent by some who write texts as C does.
    while (!text.empty() && text.back() == '\0') text.remove_suffix(1);
    const auto object_or = read_json(text, "", {.bytes = kMaxXchangeMessageBytes});
    if (!object_or.ok()) return Error{"a message that " + object_or.error().what, ""};
    const Json& object = *object_or;
    if (!object.is_object()) return Error{"a message that is no JSON object", ""};
    XchangeMessage message;
    message.type = text_of(find(object, {"Type"}));
    for (char& letter : message.type)
        letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
    if (message.type.empty()) return Error{"a message without a Type", ""};
    message.ok = truth_of(find(object, {"OK"}), true);
    message.text = text_of(find(object, {"Message"}));
    message.provider = text_of(find(object, {"Provider"}));
    message.station_name = text_of(find(object, {"StationName"}));
    const std::string station =
        text_of(message.type == "MVR_LEAVE" ? find(object, {"FromStationUUID", "StationUUID"})
                                            : find(object, {"StationUUID"}));
    message.station_uuid = uuid_from(station);
    message.file_uuid = uuid_from(text_of(find(object, {"FileUUID"})));
    if (message.type == "MVR_COMMIT") message.commits.push_back(commit_from(object));
    const Json* const commits = find(object, {"Commits", "Files"});
    if (commits && commits->is_array()) {
        // The newest stand last.
        const std::size_t skipped = commits->size() - std::min(commits->size(), kMostXchangeCommits);
        for (std::size_t i = skipped; i < commits->size(); ++i)
            if ((*commits)[i].is_object()) message.commits.push_back(commit_from((*commits)[i]));
    }
    for (XchangeCommit& commit : message.commits)
        if (commit.station_uuid.empty()) {
            commit.station_uuid = message.station_uuid;
            commit.station_asked_as = station;
        }
    return message;
}

std::string xchange_message_text(const XchangeMessage& message) {
    Json object = {{"Type", message.type}};
    const bool joins = message.type == "MVR_JOIN" || message.type == "MVR_JOIN_RET";
    if (message.is_answer()) {
        object["OK"] = message.ok;
        object["Message"] = message.text;
    }
    if (joins) {
        object["Provider"] = message.provider;
        object["StationName"] = message.station_name;
        object["StationUUID"] = message.station_uuid;
        object["verMajor"] = kMvrMajor;
        object["verMinor"] = kMvrMinor;
        object["Commits"] = Json::array();
        for (const XchangeCommit& commit : message.commits) object["Commits"].push_back(json_of(commit));
    } else if (message.type == "MVR_COMMIT" && !message.commits.empty()) {
        object = json_of(message.commits.front());
    } else if (message.type == "MVR_LEAVE") {
        object["FromStationUUID"] = message.station_uuid;
        object["StationUUID"] = message.station_uuid; // as the standard's example has it
    } else if (message.type == "MVR_REQUEST") {
        object["FileUUID"] = message.file_uuid;
        object["FromStationUUID"] = Json::array({message.station_uuid});
    }
    return object.dump(-1, ' ', false, Json::error_handler_t::replace);
}

} // namespace ghost::scene
