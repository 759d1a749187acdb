// SPDX-License-Identifier: Apache-2.0
// MVR-xchange as two stations that mean harm would speak it: one that joins us, one that we join, on two
// connections each. Input: what one of them does, again and again: a byte (connection, what), two of length,
// as many of content. Only whole .mvr files lie in our folder afterwards, and nothing beside it.
#include "fuzz/fuzz_folder.h"
#include "fuzz/stored_zip.h"

#include "xchange/private/xchange_loop.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <set>

#include <sys/socket.h>

using namespace ghost;
using namespace ghost::app;

namespace {

namespace fs = std::filesystem;
constexpr std::size_t kMostDone = 64; // by one input

enum class What { message, file, bytes, part_of_message, part_of_file, close, wait };
constexpr int kWhats = 7;

class Stations {
public:
    explicit Stations(Xchange::Loop& loop, dmx::TcpListener& theirs) : loop_(loop), theirs_(theirs) {}

    void act(std::size_t place, What what, Bytes content) {
        std::unique_ptr<dmx::TcpStream>& stream = streams_[place];
        if (what == What::close) stream.reset();
        if (what == What::close || what == What::wait) return;
        if (!stream) connect(stream, place);
        if (!stream) return;
        const auto kind = what == What::file || what == What::part_of_file ? scene::XchangePayload::file
                                                                           : scene::XchangePayload::message;
        std::vector<std::uint8_t> bytes;
        const bool is_part = what == What::part_of_message || what == What::part_of_file;
        if (what != What::bytes)
            bytes = scene::build_xchange_header(kind, content.size() + (is_part ? 9 : 0), 0, is_part ? 2 : 1);
        bytes.insert(bytes.end(), content.begin(), content.end());
        (void)stream->send(bytes);
    }

    void hear() {
        for (const auto& stream : streams_)
            if (stream) (void)stream->read();
    }

private:
    // The first two call us; we call the others.
    void connect(std::unique_ptr<dmx::TcpStream>& stream, std::size_t place) {
        if (place < streams_.size() / 2) {
            auto called = dmx::TcpStream::connect(dmx::IpAddress(0x7F000001), loop_.port());
            if (called.ok()) stream = std::move(*called);
        } else {
            stream = theirs_.accept();
        }
        const linger at_once{1, 0}; // no port waits for a minute
        if (stream) (void)::setsockopt(stream->handle(), SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
    }

    Xchange::Loop& loop_;
    dmx::TcpListener& theirs_;
    std::array<std::unique_ptr<dmx::TcpStream>, 4> streams_;
};

std::set<std::string> names_in(const fs::path& folder) {
    std::set<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        names.insert(entry.path().filename().string());
    return names;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fs::path ours = [] {
        constexpr std::string_view kXml = "<GeneralSceneDescription verMajor=\"1\" "
                                          "verMinor=\"6\"><Scene><Layers/></Scene></GeneralSceneDescription>";
        return fuzz_file("ours.mvr",
                         stored_zip({{"GeneralSceneDescription.xml",
                                      {reinterpret_cast<const std::uint8_t*>(kXml.data()), kXml.size()}}}));
    }();
    static const auto theirs = dmx::TcpListener::open(0x7F000001, 0);
    if (!theirs.ok()) std::abort();
    while ((*theirs)->accept()) {
    } // of the input before
    const fs::path save = fuzz_folder() / "save";
    fs::remove_all(save);
    XchangeOptions options;
    options.station = "fuzz";
    options.interface = "127.0.0.1";
    options.finds = false;
    options.save = save;
    options.share = {ours};
    options.peers = {"127.0.0.1:" + std::to_string((*theirs)->port())};
    const auto loop = Xchange::Loop::open(options);
    if (!loop.ok()) std::abort();
    {
        Stations stations(**loop, **theirs);
        ByteReader reader(Bytes(data, size));
        (*loop)->step(std::chrono::milliseconds(0));
        for (std::size_t done = 0; reader.left() >= 3 && done < kMostDone; ++done) {
            const std::uint8_t how = reader.u8();
            const std::size_t bytes = reader.u16_be();
            stations.act(how & 3, static_cast<What>((how >> 2) % kWhats),
                         reader.take(std::min(bytes, reader.left())));
            (*loop)->step(std::chrono::milliseconds(0));
            stations.hear();
        }
    }
    (*loop)->step(std::chrono::milliseconds(0));
    if ((*loop)->take().size() > 1000) std::abort();
    if (names_in(fuzz_folder()) != std::set<std::string>{"ours.mvr", "save"}) std::abort();
    for (const std::string& name : names_in(save)) {
        if (!name.ends_with(".mvr") || name.starts_with(".")) continue; // what did not come to its end
        std::ifstream file(save / name, std::ios::binary);
        char first[4] = {};
        file.read(first, sizeof first);
        if (std::string_view(first, sizeof first) != "PK\x03\x04") std::abort();
    }
    return 0;
}
