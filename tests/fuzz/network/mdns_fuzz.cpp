// SPDX-License-Identifier: Apache-2.0
// Any bytes as a packet of multicast DNS; what was read is written and read again, and looked through for
// stations.
#include "net/mdns.h"
#include "xchange/protocol.h"

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ghost;
    const auto packet = dmx::parse_dns({data, size});
    if (!packet) return 0;
    if (packet->questions.size() > dmx::kMostDnsQuestions || packet->records.size() > dmx::kMostDnsRecords)
        std::abort();
    for (const dmx::DnsRecord& record : packet->records) {
        std::size_t bytes = 1;
        for (const std::string& label : record.name) bytes += 1 + label.size();
        if (bytes > 255 || record.texts.size() > dmx::kMostDnsTexts) std::abort();
    }
    const auto again = dmx::parse_dns(dmx::build_dns(*packet));
    if (!again || *again != *packet) std::abort();
    const scene::XchangeStation us{"a", "b", "Default", dmx::IpAddress(0x0A000001), 1, false};
    (void)scene::xchange_answer(*packet, us);
    for (const scene::XchangeStation& station : scene::xchange_stations(*packet, us.address))
        if (station.port == 0 || station.name.size() > scene::kMaxXchangeText) std::abort();
    return 0;
}
