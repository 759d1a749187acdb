// SPDX-License-Identifier: Apache-2.0
// Any bytes as a request of a browser; what is a whole head is answered.
#include "web/site.h"

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ghost::web;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const ParsedHead parsed = parse_head(bytes);
    if (parsed.status != 200) return 0;
    if (parsed.bytes > kMostHeadBytes || parsed.bytes > size || parsed.head.fields.size() > kMostHeadLines)
        std::abort();
    std::size_t body_bytes = 0;
    if (body_status(parsed.head, body_bytes) != 200) return 0;
    if (body_bytes > kMostBodyBytes) std::abort();
    Access access{{{"localhost"}, 8010, "lights.example.org"},
                  "0123456789abcdef0123456789abcdef",
                  Pairing("123456", 0),
                  "fedcba9876543210fedcba9876543210"};
    const Routed routed = route(parsed.head, bytes.substr(parsed.bytes).substr(0, body_bytes), access, 1);
    const bool has_token = bytes.find(access.token) != std::string_view::npos;
    const bool has_control = bytes.find(access.control_token) != std::string_view::npos;
    const bool may = parsed.head.target == "/live" && (has_token || has_control);
    if (routed.book && !has_token && !has_control) std::abort();
    if (routed.right == Right::control && !has_control) std::abort();
    if (routed.is_live != (routed.answer.status == 101) || (routed.is_live && !may)) std::abort();
    if (answer_text(routed.answer).find("\r\n\r\n") == std::string::npos) std::abort();
    return 0;
}
