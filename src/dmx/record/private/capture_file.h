#pragma once
// SPDX-License-Identifier: Apache-2.0
// CaptureFile: the packets of a network capture, pcap (microseconds or nanoseconds, either byte order) or
// pcapng (sections, interfaces, enhanced, simple and old packet blocks), one after another, without holding
// the file. draft-ietf-opsawg-pcap, draft-ietf-opsawg-pcapng. One thread.

#include "archives/byte_source.h"

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace ghost::dmx {

struct CapturedFrame {
    std::chrono::nanoseconds time{0}; // since 1970; of a packet without time, that of the one before
    std::uint32_t link_type = 0;      // LINKTYPE_...
    Bytes bytes;                      // until the next call
    bool cut = false;                 // the capture kept less than there was
};

class CaptureFile {
public:
    static bool recognises(Bytes first_bytes);
    CaptureFile(ByteSource& source, std::string name);

    // Nothing at the end, or where the file is damaged or cut off (then there is a problem).
    std::optional<CapturedFrame> next();
    const std::vector<Error>& problems() const { return problems_; }
    double share() const; // of the file that was read
    std::optional<std::string> source_problem() const { return source_.problem(); }

private:
    struct Interface {
        std::uint32_t link_type = 0;
        std::uint8_t resolution = 6; // if_tsresol: 10^-n s, with the top bit 2^-n s
        std::int64_t offset_s = 0;
    };

    Bytes take(std::size_t count); // empty at the end
    void stop(const std::string& what);
    std::uint16_t u16(ByteReader& reader) const { return big_endian_ ? reader.u16_be() : reader.u16_le(); }
    std::uint32_t u32(ByteReader& reader) const { return big_endian_ ? reader.u32_be() : reader.u32_le(); }
    void read_pcap_header();
    std::optional<CapturedFrame> next_pcap();
    std::optional<CapturedFrame> next_pcapng();
    bool begin_section(Bytes head);
    void read_interface(Bytes body);
    std::optional<CapturedFrame> read_packet(std::uint32_t type, Bytes body);

    ByteSource& source_;
    std::string name_;
    std::vector<std::uint8_t> buffer_;
    std::size_t used_ = 0;           // of buffer_
    std::vector<std::uint8_t> body_; // of a pcapng block
    std::uint64_t offset_ = 0;       // in the file, of the end of buffer_
    bool stopped_ = false;
    bool next_generation_ = false; // pcapng
    bool big_endian_ = false;
    bool nanoseconds_ = false;
    std::vector<Interface> interfaces_; // of this section; pcap: one
    std::chrono::nanoseconds time_{0};
    std::vector<Error> problems_;
};

} // namespace ghost::dmx
