// SPDX-License-Identifier: Apache-2.0
#include "net/reverse_path.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <string>

namespace ghost::dmx {

namespace {

// The next word of a line, which loses it; empty at its end.
std::string_view take_word(std::string_view& line) {
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    const std::string_view word = line.substr(0, line.find(' '));
    line.remove_prefix(word.size());
    return word;
}

std::string_view take_line(std::string_view& text) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    return line;
}

} // namespace

// Two lines for each protocol: names, and under them values.
std::uint64_t parse_reverse_path_drops(std::string_view netstat) {
    while (!netstat.empty()) {
        std::string_view names = take_line(netstat);
        std::string_view values = take_line(netstat);
        std::string_view name = take_word(names), value = take_word(values);
        if (name != value) return 0;
        while (!(name = take_word(names)).empty()) {
            value = take_word(values);
            if (name != "IPReversePathFilter") continue;
            std::uint64_t count = 0;
            const auto [end, failed] = std::from_chars(value.data(), value.data() + value.size(), count);
            return failed == std::errc() && end == value.data() + value.size() ? count : 0;
        }
    }
    return 0;
}

std::uint64_t reverse_path_drops() {
    std::ifstream in("/proc/net/netstat", std::ios::binary);
    return parse_reverse_path_drops(std::string(std::istreambuf_iterator<char>(in), {}));
}

} // namespace ghost::dmx
