// SPDX-License-Identifier: Apache-2.0
#include "cli/options/number_option.h"

#include <string>

namespace ghost::app {

CLI::Validator number_in(double low, double high) {
    const CLI::Range range(low, high);
    const std::string name = range.get_description();
    return {[low, high, name](const std::string& text) {
                double number = 0;
                const bool read = CLI::detail::lexical_cast(text, number);
                return read && number >= low && number <= high ? std::string{}
                                                               : "'" + text + "' is not a number in " + name;
            },
            name};
}

} // namespace ghost::app
