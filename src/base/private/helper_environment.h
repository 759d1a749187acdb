#pragma once
// SPDX-License-Identifier: Apache-2.0
// What a helper has in its environment, so that one whose main() does not know its command starts no other
// one, which would do so, too. POSIX; any thread.

#include <cstdlib>
#include <string>
#include <vector>

extern char** environ;

namespace ghost {

inline constexpr const char* kIsHelper = "GHOSTLIGHT_IS_HELPER";

inline bool is_helper() {
    return std::getenv(kIsHelper) != nullptr;
}

// This process's own environment and that; refers to both.
class HelperEnvironment {
public:
    HelperEnvironment() : all_{own_.data()} {
        for (char** one = environ; *one; ++one) all_.push_back(*one);
        all_.push_back(nullptr);
    }
    HelperEnvironment(const HelperEnvironment&) = delete;
    HelperEnvironment& operator=(const HelperEnvironment&) = delete;
    char** data() { return all_.data(); }

private:
    std::string own_ = std::string(kIsHelper) + "=1";
    std::vector<char*> all_;
};

} // namespace ghost
