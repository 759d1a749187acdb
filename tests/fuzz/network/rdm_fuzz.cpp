// SPDX-License-Identifier: Apache-2.0
// Any bytes as an Art-Net packet of RDM to a node whose devices live as long as the run, and as a message and
// as a discovery answer.
#include "rdm/node.h"

#include <cstddef>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ghost::rdm;
    const auto devices_at = [](std::uint16_t universe) {
        std::vector<Device> devices(3);
        for (std::uint32_t i = 0; i < devices.size(); ++i) {
            devices[i].uid = {kMaker, i + 1};
            devices[i].universe = universe;
            devices[i].personalities = {{"short", 4}, {"long", 400}};
            devices[i].slots.resize(200);
            devices[i].sensors.resize(2);
        }
        return devices;
    };
    static Node node;
    static std::uint32_t runs = 0; // senders and times, as many as there may be; tables that change
    if (runs % 64 == 0) node.update(devices_at(static_cast<std::uint16_t>(1 + runs / 64 % 3)));
    const auto allow = [](const Change& change) -> std::optional<Nack> {
        if (change.label.size() > kMaxLabelBytes) std::abort();
        if (change.what == Change::What::start_address && (change.number < 1 || change.number > 512))
            std::abort();
        return std::nullopt;
    };
    const Node::Sender from{++runs % 64, std::chrono::milliseconds(10) * runs};
    const auto port_of = [](std::uint16_t port_address) {
        return port_address < 4 ? std::optional(Port{1, 1}) : std::nullopt;
    };
    for (const auto& packet : node.take({data, size}, from, allow, port_of))
        if (!is_rdm(packet)) std::abort();
    while (const auto news = node.news(from.now, port_of))
        for (const auto& packet : news->packets)
            if (!is_rdm(packet)) std::abort();
    const auto parsed = parse({data, size});
    if (const Message* message = std::get_if<Message>(&parsed))
        if (message->data.size() > kMaxDataBytes || !std::holds_alternative<Message>(parse(build(*message))))
            std::abort();
    (void)parse_discovery_answer({data, size});
    return 0;
}
