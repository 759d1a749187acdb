// SPDX-License-Identifier: Apache-2.0
// What the server is told, checked before anything is made of it.
#include "web/protocol.h"

#include "json_xml_toml/json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace ghost::web {
namespace {

constexpr JsonLimits kMessageLimits{.bytes = kMostMessageBytes, .values = 64, .members = 16, .depth = 8};

// A whole number of that range.
Result<long> whole(const nlohmann::json& message, const char* key, long low, long high) {
    const auto found = message.find(key);
    if (found == message.end() || !found->is_number_integer() || *found < low || *found > high)
        return Error{std::string("'") + key + "' is not a whole number of " + std::to_string(low) + ".." +
                         std::to_string(high),
                     "message"};
    return found->get<long>();
}

Result<bool> flag(const nlohmann::json& message, const char* key) {
    const auto found = message.find(key);
    if (found == message.end() || !found->is_boolean())
        return Error{std::string("'") + key + "' is neither true nor false", "message"};
    return found->get<bool>();
}

Result<double> number_from(const nlohmann::json& value, const char* what, double low, double high) {
    const double number = value.is_number() ? value.get<double>() : std::nan("");
    if (number >= low && number <= high) return number;
    char expected[96];
    std::snprintf(expected, sizeof expected, "'%s' is not a number from %g to %g", what, low, high);
    return Error{expected, "message"};
}

// A list of so many numbers.
template <class Vector>
Result<Vector> vector_from(const nlohmann::json& message, const char* key, double low, double high) {
    Vector vector{};
    const auto found = message.find(key);
    if (found == message.end() || !found->is_array() ||
        found->size() != static_cast<std::size_t>(Vector::length()))
        return Error{std::string("'") + key + "' is not a list of " + std::to_string(Vector::length()) +
                         " numbers",
                     "message"};
    for (int k = 0; k < Vector::length(); ++k) {
        TRY(const double number, number_from((*found)[static_cast<std::size_t>(k)], key, low, high));
        vector[k] = static_cast<float>(number);
    }
    return vector;
}

// No longer than that, and nothing that a line could not have.
Result<std::string> text_from(const nlohmann::json& value, const char* what, std::size_t most) {
    if (value.is_string())
        if (auto text = value.get<std::string>();
            !text.empty() && text.size() <= most &&
            std::none_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 32; }))
            return text;
    return Error{std::string("'") + what + "' is not a text of 1.." + std::to_string(most) + " bytes",
                 "message"};
}

Result<OwnCamera> own_from(const nlohmann::json& message) {
    constexpr double kFarthest_m = 10'000, kNearest_m = 0.01;
    if (!message.is_object()) return Error{"'own' is no object", "message"};
    OwnCamera own;
    TRY(own.position_m, vector_from<glm::vec3>(message, "position_m", -kFarthest_m, kFarthest_m));
    TRY(own.target_m, vector_from<glm::vec3>(message, "target_m", -kFarthest_m, kFarthest_m));
    if (glm::distance(own.position_m, own.target_m) < static_cast<float>(kNearest_m))
        return Error{"'own' looks at where it stands", "message"};
    const auto fov = message.find("fov_y_deg");
    if (fov == message.end()) return Error{"'own' has no 'fov_y_deg'", "message"};
    TRY(const double fov_y_deg, number_from(*fov, "fov_y_deg", 1, 120));
    own.fov_y_deg = static_cast<float>(fov_y_deg);
    return own;
}

Result<ToServer> watch_from(const nlohmann::json& message) {
    Watch watch;
    TRY(const long width, whole(message, "width", 1, kMostWidth));
    watch.width = static_cast<int>(width);
    TRY(watch.calm, flag(message, "calm"));
    if (const auto camera = message.find("camera"); camera != message.end()) {
        TRY(watch.camera, text_from(*camera, "camera", kMostArgumentBytes));
    }
    if (const auto own = message.find("own"); own != message.end()) {
        TRY(watch.own, own_from(*own));
    }
    if (!watch.camera.empty() && watch.own) return Error{"'camera' and 'own' are one too many", "message"};
    if (message.contains("probe")) {
        TRY(watch.probe, vector_from<glm::vec2>(message, "probe", 0, 1));
    }
    return ToServer{std::move(watch)};
}

Result<ToServer> do_from(const nlohmann::json& message) {
    Do what;
    TRY(const long n, whole(message, "n", 1, 0x7FFFFFFF));
    what.n = static_cast<std::uint32_t>(n);
    const auto word = message.find("what");
    if (word == message.end()) return Error{"'what' is missing", "message"};
    TRY(what.command.what, text_from(*word, "what", kMostWordBytes));
    const auto args = message.find("args");
    if (args == message.end() || !args->is_array() || args->size() > kMostArguments)
        return Error{"'args' is not a list of " + std::to_string(kMostArguments) + " at most", "message"};
    for (const nlohmann::json& one : *args) {
        if (one.is_boolean()) {
            what.command.arguments.emplace_back(one.get<bool>());
        } else if (one.is_number()) {
            TRY(const double number, number_from(one, "args", -1e9, 1e9));
            what.command.arguments.emplace_back(number);
        } else {
            TRY(std::string text, text_from(one, "args", kMostArgumentBytes));
            what.command.arguments.emplace_back(std::move(text));
        }
    }
    return ToServer{std::move(what)};
}

} // namespace

Result<ToServer> read_message(Opcode opcode, Bytes payload, bool may_control) {
    if (opcode == Opcode::binary) {
        ByteReader reader(payload);
        const std::uint8_t kind = reader.u8();
        const std::uint32_t number = reader.u32_le();
        if (kind != 1 || !reader.ok() || reader.left() > 0)
            return Error{"not five bytes that say what was painted", "message"};
        return ToServer{Painted{number}};
    }
    const std::string_view text(reinterpret_cast<const char*>(payload.data()), payload.size());
    TRY(const nlohmann::json message, read_json(text, "message", kMessageLimits));
    const auto type = message.is_object() ? message.find("type") : message.end();
    if (!message.is_object() || type == message.end() || !type->is_string())
        return Error{"not an object with a 'type'", "message"};
    if (*type == "watch") return watch_from(message);
    if (*type == "do") return may_control ? do_from(message) : Result<ToServer>(ToServer{Unread{}});
    if (*type == "pictures") {
        TRY(const bool on, flag(message, "on"));
        return ToServer{WantPictures{on}};
    }
    if (*type == "levels") {
        TRY(const bool on, flag(message, "on"));
        return ToServer{WantLevels{on}};
    }
    if (*type == "explain") {
        TRY(const long fixture, whole(message, "fixture", 0, 1'000'000));
        return ToServer{Explain{static_cast<std::size_t>(fixture)}};
    }
    if (*type == "ping") {
        const auto t = message.find("t");
        if (t == message.end() || !t->is_number() || !std::isfinite(t->get<double>()))
            return Error{"'t' is not a number", "message"};
        return ToServer{Ping{t->get<double>()}};
    }
    return Error{"unknown type, expected watch, levels, explain or ping", "message"};
}

} // namespace ghost::web
