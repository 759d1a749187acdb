#pragma once
// SPDX-License-Identifier: Apache-2.0
// CHECK(condition) and CHECK_EQ(a, b): a violated one is a bug of ours. Both print file, line and values and
// abort, in every build. Never for input: input gets a Result.

#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>

namespace ghost {

[[noreturn]] inline void check_failed(const char* file, int line, const char* expression,
                                      const std::string& values) {
    std::fprintf(stderr, "%s:%d: CHECK failed: %s%s\n", file, line, expression, values.c_str());
    std::abort();
}

template <class A, class B>
std::string check_values(const A& a, const B& b) {
    std::ostringstream text;
    text << " (" << a << " against " << b << ")";
    return text.str();
}

} // namespace ghost

#define CHECK(condition)                                                                                     \
    do {                                                                                                     \
        if (!(condition)) ghost::check_failed(__FILE__, __LINE__, #condition, "");                           \
    } while (false)

#define CHECK_EQ(a, b)                                                                                       \
    do {                                                                                                     \
        const auto& check_a = (a);                                                                           \
        const auto& check_b = (b);                                                                           \
        if (!(check_a == check_b))                                                                           \
            ghost::check_failed(__FILE__, __LINE__, #a " == " #b, ghost::check_values(check_a, check_b));    \
    } while (false)
