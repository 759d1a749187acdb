// SPDX-License-Identifier: Apache-2.0
#include "web/site.h"

#include "base/text.h"
#include "json_xml_toml/json.h"
#include "web/private/files.h"
#include "web/websocket.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace ghost::web {
namespace {

constexpr JsonLimits kBodyLimits{.bytes = kMostBodyBytes, .values = 8, .members = 4, .depth = 2};

std::string type_of(std::string_view name) {
    if (name.ends_with(".html")) return "text/html; charset=utf-8";
    if (name.ends_with(".css")) return "text/css; charset=utf-8";
    if (name.ends_with(".js")) return "text/javascript; charset=utf-8";
    return "image/svg+xml";
}

Answer file(std::string_view name) {
    for (const WebFile& one : web_files())
        if (one.name == name) return {.type = type_of(name), .body = one.bytes, .text = {}, .fields = {}};
    return refusal(404);
}

// Where browsers do not trust the origin, they refuse the field, and complain with the address and its token.
Answer page(bool is_trusted) {
    Answer answer = file("index.html");
    if (is_trusted) answer.fields = {{"Cross-Origin-Opener-Policy", "same-origin"}};
    return answer;
}

// One of the words of a list with commas.
bool names(std::string_view list, std::string_view word) {
    const std::vector<std::string_view> words = split(list, ',');
    return std::any_of(words.begin(), words.end(),
                       [&](std::string_view one) { return trimmed(one) == word; });
}

// Of the tokens in a list of protocols the one that opens most.
Right right_in(std::string_view protocols, const Access& access) {
    Right right = Right::none;
    for (const std::string_view one : split(protocols, ','))
        if (const std::string_view word = trimmed(one); word.starts_with("t."))
            right = std::max(right, right_of(word.substr(2), access));
    return right;
}

Right right_in_fields(const Head& head, const Access& access) {
    constexpr std::string_view kBearer = "Bearer ";
    const std::string_view given = head.field("authorization");
    return given.starts_with(kBearer) ? right_of(given.substr(kBearer.size()), access) : Right::none;
}

Routed live(const Head& head, const Access& access) {
    const std::string accept = accept_of(head.field("sec-websocket-key"));
    if (lower(head.field("upgrade")) != "websocket" || head.field("sec-websocket-version") != "13" ||
        !names(lower(head.field("connection")), "upgrade")) {
        Answer answer = refusal(426);
        answer.fields = {{"Upgrade", "websocket"}, {"Sec-WebSocket-Version", "13"}};
        return {answer};
    }
    if (accept.empty()) return {refusal(400)};
    const std::string_view protocols = head.field("sec-websocket-protocol");
    const Right right = right_in(protocols, access);
    if (!names(protocols, kProtocol) || right == Right::none) return {refusal(401)};
    Answer answer{.status = 101, .type = {}, .body = {}, .text = {}, .fields = {}};
    answer.fields = {{"Upgrade", "websocket"},
                     {"Connection", "Upgrade"},
                     {"Sec-WebSocket-Accept", accept},
                     {"Sec-WebSocket-Protocol", std::string(kProtocol)}};
    return {answer, true, right, {}};
}

// Tells a page whose handshake was refused whether it was for its token.
Answer right(const Head& head, const Access& access) {
    const Right right = right_in_fields(head, access);
    if (right == Right::none) return refusal(401);
    return {.type = "application/json",
            .body = {},
            .text = nlohmann::json{{"right", name_of(right)}}.dump(),
            .fields = {}};
}

Routed book(const Head& head, const Access& access) {
    constexpr std::string_view kBook = "/book/";
    const Right right = right_in_fields(head, access);
    if (right == Right::none) return {refusal(401)};
    return {refusal(404), false, right, head.target.substr(kBook.size())};
}

Answer pair(const Head& head, std::string_view body, Access& access, double now_s) {
    if (lower(trimmed(split(head.field("content-type"), ';').front())) != "application/json")
        return refusal(415);
    const auto asked = read_json(body, "pair", kBodyLimits);
    if (!asked.ok() || !asked->is_object() || !asked->contains("code") || !(*asked)["code"].is_string())
        return refusal(400);
    if (!access.pairing || !access.pairing->accepts((*asked)["code"].get<std::string>(), now_s))
        return refusal(401);
    access.pairing.reset();
    return {.type = "application/json",
            .body = {},
            .text = nlohmann::json{{"token", access.token}, {"right", "view"}}.dump(),
            .fields = {}};
}

} // namespace

void Access::allow_control(bool allowed) {
    constexpr std::size_t kMostTakenBack = 64;
    if (!control_token.empty()) taken_back.push_back(control_token);
    if (taken_back.size() > kMostTakenBack) taken_back.erase(taken_back.begin());
    control_token = allowed ? make_token() : "";
}

void Access::renew() {
    token = make_token();
    taken_back.clear();
    if (!control_token.empty()) control_token = make_token();
    pairing.reset();
}

std::string_view name_of(Right right) {
    return right == Right::control ? "control" : right == Right::view ? "view" : "none";
}

Right right_of(std::string_view token, const Access& access) {
    bool views = is_same_secret(token, access.token);
    for (const std::string& one : access.taken_back) views |= is_same_secret(token, one);
    const bool controls = is_same_secret(token, access.control_token);
    return controls ? Right::control : views ? Right::view : Right::none;
}

Answer refusal(int status) {
    const char* why = "This is not here.\n";
    switch (status) {
    case 400:
        why = "The request is malformed.\n";
        break;
    case 401:
        why = "The token or the digits are not the right ones, or no longer.\n";
        break;
    case 403:
        why = "Another page asked for this.\n";
        break;
    case 405:
        why = "This address takes another method.\n";
        break;
    case 421:
        why = "Ghostlight is not called so; start it with --host NAME if it is.\n";
        break;
    case 426:
        why = "This address is for a WebSocket.\n";
        break;
    case 408:
        why = "The request took too long.\n";
        break;
    case 503:
        why = "Too many are looking on already.\n";
        break;
    default:
        break;
    }
    return {.status = status, .type = "text/plain; charset=utf-8", .body = why, .text = {}, .fields = {}};
}

Routed route(const Head& head, std::string_view body, Access& access, double now_s) {
    constexpr std::string_view kFiles = "/a/";
    const std::string_view host = head.field("host");
    if (!is_own_host(host, access.own)) return {refusal(421)};
    const bool gets = head.method == "GET", posts = head.method == "POST";
    if (!gets && !posts) return {refusal(405)};
    const bool is_live = head.target == "/live", is_pair = head.target == "/pair";
    if (is_pair ? !posts : posts) return {refusal(405)};
    if ((is_live || is_pair) && !is_own_origin(head.field("origin"), host, access.own)) return {refusal(403)};
    if (is_live) return live(head, access);
    if (is_pair) return {pair(head, body, access, now_s)};
    if (head.target.starts_with("/book/")) return book(head, access);
    if (head.target == "/right") return {right(head, access)};
    if (head.target == "/") return {page(is_trusted_host(host, access.own))};
    if (head.target.starts_with(kFiles)) return {file(std::string_view(head.target).substr(kFiles.size()))};
    return {refusal(404)};
}

} // namespace ghost::web
