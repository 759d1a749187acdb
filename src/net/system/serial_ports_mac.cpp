// SPDX-License-Identifier: Apache-2.0
// Compiled nowhere so far: no compiler for macOS was at hand.
#include "net/serial.h"

#include "net/private/system_sizes.h"

#include <algorithm>
#include <cctype>

namespace ghost::dmx {

namespace {} // namespace

// Ports go by the serial number of what is plugged in there, and those of ENTTEC begin with EN.
std::vector<std::string> list_usb_pro_ports(const std::filesystem::path& folder) {
    std::vector<std::string> result;
    std::error_code code;
    for (std::filesystem::directory_iterator entry(folder == kSerialPortsById ? "/dev" : folder, code), end;
         !code && entry != end; entry.increment(code)) {
        std::string name = entry->path().filename().string();
        std::transform(name.begin(), name.end(), name.begin(),
                       [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
        const bool says_so = name.starts_with("cu.") && name.find("dmx_usb_pro") != std::string::npos;
        if (!says_so && !name.starts_with("cu.usbserial-en")) continue;
        result.push_back(entry->path().string());
        if (result.size() == kMostPorts) break;
    }
    std::sort(result.begin(), result.end());
    return result;
}

} // namespace ghost::dmx
