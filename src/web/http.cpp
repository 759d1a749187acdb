// SPDX-License-Identifier: Apache-2.0
#include "web/http.h"

#include "base/text.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace ghost::web {
namespace {

// Of which a second one would leave open which of the two holds.
constexpr std::array<std::string_view, 10> kOnce{
    "authorization", "connection", "content-length",    "content-type",           "host",
    "origin",        "upgrade",    "sec-websocket-key", "sec-websocket-protocol", "sec-websocket-version"};

// RFC 9110, 5.6.2.
bool is_token(std::string_view text) {
    constexpr std::string_view kMarks = "!#$%&'*+-.^_`|~";
    return !text.empty() && std::all_of(text.begin(), text.end(), [&](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               kMarks.find(c) != std::string_view::npos;
    });
}

bool is_target(std::string_view text) {
    return text.starts_with('/') &&
           std::all_of(text.begin(), text.end(), [](char c) { return c > ' ' && c < 0x7F; });
}

bool is_value(std::string_view text) {
    return std::all_of(text.begin(), text.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return (byte >= ' ' && byte != 0x7F) || c == '\t';
    });
}

int read_request_line(std::string_view line, Head& head) {
    const std::vector<std::string_view> words = split(line, ' ');
    if (words.size() != 3 || !is_token(words[0]) || !is_target(words[1])) return 400;
    if (words[2] != "HTTP/1.1") return words[2].starts_with("HTTP/") ? 505 : 400;
    head.method = words[0];
    head.target = words[1];
    return 200;
}

int read_field(std::string_view line, Head& head) {
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos || !is_token(line.substr(0, colon)) ||
        !is_value(line.substr(colon + 1)))
        return 400;
    const std::string name = lower(line.substr(0, colon));
    if (head.has(name) && std::find(kOnce.begin(), kOnce.end(), name) != kOnce.end()) return 400;
    if (name == "transfer-encoding") return 501;
    head.fields.emplace_back(name, trimmed(line.substr(colon + 1)));
    return 200;
}

const char* reason(int status) {
    switch (status) {
    case 101:
        return "Switching Protocols";
    case 200:
        return "OK";
    case 400:
        return "Bad Request";
    case 401:
        return "Unauthorized";
    case 403:
        return "Forbidden";
    case 404:
        return "Not Found";
    case 405:
        return "Method Not Allowed";
    case 408:
        return "Request Timeout";
    case 411:
        return "Length Required";
    case 413:
        return "Content Too Large";
    case 415:
        return "Unsupported Media Type";
    case 421:
        return "Misdirected Request";
    case 426:
        return "Upgrade Required";
    case 431:
        return "Request Header Fields Too Large";
    case 501:
        return "Not Implemented";
    case 503:
        return "Service Unavailable";
    case 505:
        return "HTTP Version Not Supported";
    default:
        return "Refused";
    }
}

} // namespace

std::string_view Head::field(std::string_view name) const {
    for (const auto& [own, value] : fields)
        if (own == name) return value;
    return {};
}

bool Head::has(std::string_view name) const {
    return std::any_of(fields.begin(), fields.end(), [&](const auto& field) { return field.first == name; });
}

ParsedHead parse_head(std::string_view bytes) {
    ParsedHead parsed;
    const auto refused = [&](int status) {
        parsed.status = status;
        return parsed;
    };
    std::size_t begin = 0;
    for (std::size_t lines = 0;; ++lines) {
        const std::string_view rest = bytes.substr(begin, kMostHeadBytes - begin);
        const std::size_t end = rest.find("\r\n");
        const std::string_view line = rest.substr(0, end);
        if (line.find('\n') != std::string_view::npos || line.find('\0') != std::string_view::npos)
            return refused(400);
        if (end == std::string_view::npos) return refused(bytes.size() >= kMostHeadBytes ? 431 : 0);
        begin += end + 2;
        if (lines > 0 && line.empty()) break;
        if (lines > kMostHeadLines) return refused(431);
        const int status = lines == 0 ? read_request_line(line, parsed.head) : read_field(line, parsed.head);
        if (status != 200) return refused(status);
    }
    parsed.bytes = begin;
    return refused(200);
}

int body_status(const Head& head, std::size_t& bytes) {
    const std::string_view text = head.field("content-length");
    bytes = 0;
    if (!head.has("content-length")) return head.method == "POST" ? 411 : 200;
    const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), bytes);
    if (failed == std::errc::result_out_of_range) return 413;
    if (failed != std::errc() || end != text.data() + text.size()) return 400;
    return bytes <= kMostBodyBytes ? 200 : 413;
}

std::string answer_text(const Answer& answer) {
    const std::string_view body = answer.text.empty() ? answer.body : std::string_view(answer.text);
    return answer_head(answer, body.size()).append(body);
}

std::string answer_head(const Answer& answer, std::size_t body_bytes) {
    std::string text = "HTTP/1.1 " + std::to_string(answer.status) + " " + reason(answer.status) + "\r\n";
    for (const auto& [name, value] : answer.fields) text += name + ": " + value + "\r\n";
    if (answer.status == 101) return text + "\r\n";
    if (!answer.type.empty()) text += "Content-Type: " + answer.type + "\r\n";
    text += "Content-Length: " + std::to_string(body_bytes) +
            "\r\n"
            "Connection: close\r\n"
            "Cache-Control: no-store\r\n"
            "Content-Security-Policy: default-src 'none'; script-src 'self'; style-src 'self'; img-src "
            "'self' blob:; "
            "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'\r\n"
            "Cross-Origin-Resource-Policy: same-origin\r\n"
            "Permissions-Policy: camera=(), microphone=(), geolocation=()\r\n"
            "Referrer-Policy: no-referrer\r\n"
            "X-Content-Type-Options: nosniff\r\n"
            "X-Frame-Options: DENY\r\n"
            "\r\n";
    return text;
}

} // namespace ghost::web
