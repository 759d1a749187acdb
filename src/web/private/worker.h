#pragma once
// SPDX-License-Identifier: Apache-2.0
// Worker: a thread beside the server's for work that may wait and takes long, one piece after another, in
// what processor time others leave (nice 19). Whoever owns it never waits for it, at its end neither: a busy
// machine may give such a thread nothing for a minute. So a piece owns all that it touches. The server's
// thread.

#include "net/tcp.h"

#include <functional>
#include <memory>

namespace ghost::web {

class Worker {
public:
    using Done = std::function<void()>; // what is to be done with the result, on the server's thread
    using Work = std::function<Done()>;

    // wake: raised after each piece.
    explicit Worker(std::shared_ptr<dmx::StreamWake> wake);
    ~Worker(); // what is not done is forgotten
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    void put(Work work);
    // Does what is to be done with all results that there are. What a piece threw is thrown here.
    void finish();
    double cpu_s() const; // that its thread has used, without the piece that it is at

private:
    struct Shared;
    static void run(const std::shared_ptr<Shared>& shared);
    std::shared_ptr<Shared> shared_;
};

} // namespace ghost::web
