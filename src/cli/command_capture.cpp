// SPDX-License-Identifier: Apache-2.0
#include "base/log.h"
#include "base/print.h"
#include "cli/commands.h"
#include "video/capture_consent.h"

#include <memory>
#include <string>
#include <vector>

namespace ghost::app {
namespace {

struct CaptureArguments {
    std::vector<std::string> devices;
    bool forget = false;
};

int run_capture(const CaptureArguments& arguments) {
    for (const std::string& device : arguments.devices) {
        const Result<void> done =
            arguments.forget ? video::forbid_capture(device) : video::allow_capture(device);
        if (!done.ok()) {
            log_error(done.error().text());
            return 1;
        }
        print_text("%s%s\n", arguments.forget ? "shows may not open " : "shows may open ", device.c_str());
    }
    return 0;
}

} // namespace

void add_capture(CLI::App& app, int& exit_code) {
    CLI::App* command = app.add_subcommand(
        "capture", "allow that shows open a video device of this machine (a camera, a card)");
    const auto arguments = std::make_shared<CaptureArguments>();
    command->add_option("DEVICE", arguments->devices, "such as /dev/video0")->required();
    command->add_flag("--forget", arguments->forget, "allow it no more");
    command->footer("Example: ghostlight capture /dev/video0");
    command->callback([arguments, &exit_code] { exit_code = run_capture(*arguments); });
}

} // namespace ghost::app
