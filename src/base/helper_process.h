#pragma once
// SPDX-License-Identifier: Apache-2.0
// This program, started once more for work that may end it: parsers of other people's that read what
// strangers send. The two speak over one stream of bytes. The helper has none of our open files, and once it
// is confined it can open nothing, reach no network, start nothing and take no more memory than it was given.
// On Windows it starts nothing, takes no more memory and changes none of the user's files, but what everybody
// may read it can open, and the network is not closed to it. One thread at a time per object.

#include "base/byte_reader.h"
#include "base/result.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ghost {

// Both ends. Small pieces are gathered until flush(); receive() flushes.
class HelperStream {
public:
    explicit HelperStream(int descriptor) : descriptor_(descriptor) {}

    // False: the other end is gone, as everything after it is.
    bool send(Bytes bytes);
    bool flush();
    bool receive(std::span<std::uint8_t> bytes);
    // Waits until there is something to receive; false after wait_ms.
    bool wait(int wait_ms);

private:
    int descriptor_;
    std::vector<std::uint8_t> out_;
    std::vector<std::uint8_t> in_;
    std::size_t in_at_ = 0;
};

class HelperProcess {
public:
    // command: the only argument that main() gets; one that does not know it may start no helper itself.
    // Error: that, or the system gives no process.
    static Result<HelperProcess> start(const std::string& command);
    HelperProcess(HelperProcess&& other) noexcept;
    HelperProcess& operator=(HelperProcess&&) = delete;
    ~HelperProcess(); // ends it

    HelperStream& stream() { return stream_; }
    double cpu_s() const; // processor time of all its threads so far
    // Ends it and says how it went: "signal 11", "exit code 1".
    std::string end();

private:
    HelperProcess(int process, int descriptor)
        : process_(process), descriptor_(descriptor), stream_(descriptor) {}

    int process_;
    int descriptor_;
    HelperStream stream_;
};

// In the helper, first of all: from here on its stream is all it has, and nothing of it outlasts cpu_s.
// memory_bytes: of address space.
HelperStream confine_helper(std::size_t memory_bytes, std::uint64_t cpu_s);

} // namespace ghost
