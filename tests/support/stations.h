#pragma once
// SPDX-License-Identifier: Apache-2.0
// Stations of MVR-xchange on the loopback interface for tests, and one that does what none should.

#include "disk/files.h"
#include "net/socket.h"
#include "net/tcp.h"
#include "support/must.h"
#include "support/test_folder.h"
#include "support/tiny_gdtf.h"
#include "xchange/protocol.h"
#include "xchange/xchange.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <thread>

namespace ghost::app::stations {

using namespace std::chrono_literals;
namespace fs = std::filesystem;
using Kind = XchangeEvent::Kind;

using Folder = TestFolder;

// A plot without anything in it, and so many bytes beside.
inline std::string write_plot(const fs::path& path, std::size_t bytes) {
    std::string filler;
    for (std::size_t i = 0; filler.size() < bytes; ++i) filler += static_cast<char>(i * 2654435761u >> 13);
    const auto zip =
        fixture::make_zip({{"GeneralSceneDescription.xml",
                            "<GeneralSceneDescription verMajor=\"1\" verMinor=\"6\"><Scene><Layers/>"
                            "</Scene></GeneralSceneDescription>"},
                           {"filler.bin", filler}});
    const std::string content(zip.begin(), zip.end());
    EXPECT_TRUE(write_file_atomic(path, content).ok());
    return content;
}

XchangeOptions station(const std::string& name) {
    XchangeOptions options;
    options.station = name;
    options.interface = "127.0.0.1";
    options.finds = false;
    return options;
}

inline std::string at(std::uint16_t port) {
    return "127.0.0.1:" + std::to_string(port);
}

// What a station tells, until it tells one of that kind; nothing when that takes too long.
inline std::optional<XchangeEvent> wait_for(Xchange& xchange, Kind kind,
                                            std::chrono::seconds patience = 20s) {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (std::chrono::steady_clock::now() < end) {
        for (XchangeEvent& event : xchange.take())
            if (event.kind == kind) return std::move(event);
        std::this_thread::sleep_for(5ms);
    }
    return std::nullopt;
}

inline std::string content_of(const fs::path& path) {
    const auto text = read_text_file(path, 1u << 30);
    return text.ok() ? *text : text.error().text();
}

inline std::unique_ptr<Xchange> start(const XchangeOptions& options) {
    return must(Xchange::start(options));
}

inline std::string package(const std::string& content,
                           scene::XchangePayload payload = scene::XchangePayload::message) {
    const auto header = scene::build_xchange_header(payload, content.size());
    return std::string(header.begin(), header.end()) + content;
}

// A station made by hand: what it answers to a message of a type is the test's. It joins by --peer.
class Forged {
public:
    explicit Forged(std::function<std::string(const scene::XchangeMessage&)> answer)
        : answer_(std::move(answer)) {
        listener_ = std::move(*dmx::TcpListener::open(0x7F000001, 0));
        thread_ = std::thread([this] { run(); });
    }
    ~Forged() {
        stop_ = true;
        thread_.join();
    }
    std::uint16_t port() const { return listener_->port(); }
    // From now on whoever was answered gets a byte more now and then.
    void trickle() { trickles_ = true; }

private:
    struct Visitor {
        std::unique_ptr<dmx::TcpStream> stream;
        scene::XchangeReader reader;
        std::string out;
        bool answered = false;
    };
    void run() {
        int turns = 0;
        std::vector<Visitor> visitors;
        while (!stop_) {
            while (auto stream = listener_->accept()) visitors.push_back({std::move(stream), {}, {}, false});
            for (Visitor& visitor : visitors) {
                if (!visitor.stream) continue;
                const scene::XchangeReader::Sink sink{[&](std::string_view json) -> Result<void> {
                                                          visitor.out +=
                                                              answer_(*scene::parse_xchange_message(json));
                                                          return {};
                                                      },
                                                      [](Bytes, bool) -> Result<void> { return {}; }};
                const auto bytes = visitor.stream->read();
                if (!bytes || (!bytes->empty() && !visitor.reader.take(*bytes, sink).ok())) {
                    visitor.stream.reset();
                    continue;
                }
                const auto sent = visitor.stream->send(
                    {reinterpret_cast<const std::uint8_t*>(visitor.out.data()), visitor.out.size()});
                if (sent) visitor.out.erase(0, *sent);
                visitor.answered |= sent && *sent > 0;
                if (trickles_ && visitor.answered && turns % 500 == 0) visitor.out += '\0';
            }
            ++turns;
            std::this_thread::sleep_for(1ms);
        }
    }

    std::function<std::string(const scene::XchangeMessage&)> answer_;
    std::unique_ptr<dmx::TcpListener> listener_;
    std::atomic<bool> stop_{false}, trickles_{false};
    std::thread thread_;
};

// Offers one plot, and answers the request for it with these bytes.
std::function<std::string(const scene::XchangeMessage&)> offering(const std::string& reply,
                                                                  const std::string& name = "x.mvr") {
    return [=](const scene::XchangeMessage& message) -> std::string {
        if (message.type == "MVR_REQUEST") return reply;
        if (message.type != "MVR_JOIN") return "";
        return package(R"({"Type":"MVR_JOIN_RET","OK":"true","StationName":"Forged","StationUUID":"f",)"
                       R"("Commits":[{"FileUUID":"1","FileName":")" +
                       name + R"("}]})");
    };
}

} // namespace ghost::app::stations
