// SPDX-License-Identifier: Apache-2.0
#include "net/serial.h"

#include "net/private/system_sizes.h"

#include <algorithm>
#include <cctype>

namespace ghost::dmx {

namespace {} // namespace

std::vector<std::string> list_usb_pro_ports(const std::filesystem::path& folder) {
    std::vector<std::string> result;
    std::error_code code;
    for (std::filesystem::directory_iterator entry(folder, code), end; !code && entry != end;
         entry.increment(code)) {
        std::string name = entry->path().filename().string();
        std::transform(name.begin(), name.end(), name.begin(),
                       [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
        if (name.find("dmx_usb_pro") == std::string::npos) continue;
        result.push_back(entry->path().string());
        if (result.size() == kMostPorts) break;
    }
    std::sort(result.begin(), result.end());
    return result;
}

} // namespace ghost::dmx
