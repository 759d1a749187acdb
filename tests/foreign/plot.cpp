// SPDX-License-Identifier: Apache-2.0
// Prints the fixtures of a plot and their addresses: plot FILE.mvr
#include <cstdio>
#include <mvr/mvr_load.h>

int main(int count, char** words) {
    using namespace ghost::scene;
    if (count != 2) return 2;
    const auto loaded = load_mvr(std::filesystem::path(words[1]));
    if (!loaded.ok()) {
        std::fprintf(stderr, "%s\n", loaded.error().text().c_str());
        return 1;
    }
    for (const ghost::Message& message : loaded->report.messages)
        std::fprintf(stderr, "%s: %s\n", message.where.c_str(), message.what.c_str());
    for (const PlotObject& object : loaded->plot.objects) {
        if (object.kind != ObjectKind::fixture) continue;
        std::printf("%s, %s:", object.name.c_str(), object.device.gdtf_spec.c_str());
        for (const auto& address : patch_addresses(loaded->plot, object))
            std::printf(" %d.%d", address.universe, address.channel);
        std::printf("\n");
    }
    return 0;
}
