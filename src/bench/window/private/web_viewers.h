#pragma once
// SPDX-License-Identifier: Apache-2.0
// WebViewers: browsers as the server sees them, without the work of one: they take pictures, say that they
// are painted as soon as the last byte is there, and note how old they were then. A thread of their own.

#include "base/result.h"
#include "net/tcp.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace ghost::app {

class WebViewers {
public:
    // All are in when it returns. slow_bytes_per_s: so much the last of them reads; 0: it is like the others.
    static Result<std::unique_ptr<WebViewers>> look_on(std::uint16_t port, const std::string& token,
                                                       int count, double slow_bytes_per_s = 0);
    ~WebViewers();

    double cpu_s() const { return cpu_s_; } // that their thread has used
    // Milliseconds of each picture, from drawn to its last byte, sorted.
    struct Ages {
        std::vector<double> of_most_ms, of_slow_ms;
    };
    Ages leave(); // ends them

private:
    struct One {
        std::unique_ptr<dmx::TcpStream> stream;
        std::vector<std::uint8_t> in;
        double bytes_per_s = 0; // 0: all that comes
        double may_read = 0;    // bytes
    };
    void run();
    void read(One& one);

    std::vector<One> all_;
    Ages ages_;
    std::atomic<double> cpu_s_{0};
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

} // namespace ghost::app
