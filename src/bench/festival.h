#pragma once
// SPDX-License-Identifier: Apache-2.0
// Festival: a show of many fixtures for the tables that need one, made by tools/make_festival.py (so the
// bench runs in the source folder, as it does for the demo) in a folder that goes with it. Main thread.

#include "base/result.h"

#include <string>
#include <utility>

namespace ghost::app {

class Festival {
public:
    // Error: there is no tools/make_festival.py here, or no Python.
    static Result<Festival> make(int fixtures);
    Festival(Festival&& other) noexcept : folder_(std::exchange(other.folder_, {})) {}
    Festival& operator=(Festival&& other) noexcept {
        std::swap(folder_, other.folder_);
        return *this;
    }
    ~Festival();
    const std::string& folder() const { return folder_; }

private:
    explicit Festival(std::string folder) : folder_(std::move(folder)) {}
    std::string folder_;
};

} // namespace ghost::app
