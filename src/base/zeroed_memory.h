#pragma once
// SPDX-License-Identifier: Apache-2.0
// ZeroedMemory: while one lives, blocks that the program is given hold zeros, as far as the C library can do
// that (glibc), in all threads. For libraries whose result depends on what they find in memory. One at a
// time.

namespace ghost {

class ZeroedMemory {
public:
    ZeroedMemory();
    ~ZeroedMemory();
    ZeroedMemory(const ZeroedMemory&) = delete;
    ZeroedMemory& operator=(const ZeroedMemory&) = delete;
};

} // namespace ghost
