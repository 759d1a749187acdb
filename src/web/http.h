#pragma once
// SPDX-License-Identifier: Apache-2.0
// The head of an HTTP request (RFC 9112) as browsers send it, and answers to it. Strict: what may be read in
// two ways is refused. Pure; any bytes are taken.

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ghost::web {

inline constexpr std::size_t kMostHeadBytes = 8u << 10;
inline constexpr std::size_t kMostHeadLines = 64;
inline constexpr std::size_t kMostBodyBytes = 256;

struct Head {
    std::string method;
    std::string target;                                      // begins with '/'; not decoded
    std::vector<std::pair<std::string, std::string>> fields; // names in small letters, values trimmed

    // Empty where it is missing; fields that decide anything are there once at most.
    std::string_view field(std::string_view name) const;
    bool has(std::string_view name) const;
};

struct ParsedHead {
    int status = 0; // 0: more bytes are needed; 200: it is whole; else the answer that refuses it
    Head head;
    std::size_t bytes = 0; // of the head, its empty line included
};
ParsedHead parse_head(std::string_view bytes);

// Length of the body that follows, kMostBodyBytes at most. Returns 200, or the answer that refuses it.
int body_status(const Head& head, std::size_t& bytes);

struct Answer {
    int status = 200;
    std::string type; // of the body
    std::string_view body;
    std::string text;                                        // the body, where it is made for this answer
    std::vector<std::pair<std::string, std::string>> fields; // besides those that all have
};
// All bytes of an answer after which the connection ends, or goes on as a WebSocket (101).
std::string answer_text(const Answer& answer);
// Those before a body of that length, which follows by itself.
std::string answer_head(const Answer& answer, std::size_t body_bytes);

} // namespace ghost::web
