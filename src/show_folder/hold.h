#pragma once
// SPDX-License-Identifier: Apache-2.0
// Hold: who has a show open to change it. A file beside what is kept of the show says host, process and since
// when, and is locked for as long as that program lives: one that was killed holds nothing. Where a disk has
// no locks, a process of this host is looked for. One thread.

#include "base/result.h"

#include <filesystem>
#include <string>

namespace ghost {

class Hold {
public:
    enum class Other { keeps, gives_way };
    // file: in a folder of the show's own, home (own_folder.h). Error: it cannot be written there.
    static Result<Hold> take(const std::filesystem::path& file, const std::filesystem::path& home,
                             Other other);

    Hold(Hold&& other) noexcept;
    Hold& operator=(Hold&& other) noexcept;
    ~Hold(); // gives it back

    // Whether it is this program's, which may have given way since it took it.
    bool is_ours() const;
    // "process 4711 on studio, since 2026-11-24 14:02": who has it, where it is not ours.
    std::string holder() const;

private:
    explicit Hold(std::filesystem::path file) : file_(std::move(file)) {}

    std::filesystem::path file_;
    int handle_ = -1; // of ours
};

} // namespace ghost
