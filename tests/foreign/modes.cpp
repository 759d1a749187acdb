// SPDX-License-Identifier: Apache-2.0
// Prints the modes of a fixture file: modes FILE.gdtf
#include <cstdio>
#include <fixture_files/load_type.h>

int main(int count, char** words) {
    if (count != 2) return 2;
    const auto loaded = ghost::fixture::load_type(words[1]);
    if (!loaded.ok()) {
        std::fprintf(stderr, "%s\n", loaded.error().text().c_str());
        return 1;
    }
    for (const ghost::fixture::Mode& mode : loaded->type.modes)
        std::printf("%s: %zu channels\n", mode.name.c_str(), mode.channels.size());
    return 0;
}
