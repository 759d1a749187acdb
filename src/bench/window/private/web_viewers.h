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
    // All are in when it returns.
    static Result<std::unique_ptr<WebViewers>> look_on(std::uint16_t port, const std::string& token,
                                                       int count);
    ~WebViewers();

    // Ends them. Milliseconds of each picture, from drawn to its last byte, sorted.
    std::vector<double> leave();

private:
    struct One {
        std::unique_ptr<dmx::TcpStream> stream;
        std::vector<std::uint8_t> in;
    };
    void run();
    void read(One& one);

    std::vector<One> all_;
    std::vector<double> ages_ms_;
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

} // namespace ghost::app
