// SPDX-License-Identifier: Apache-2.0
#include "bench/private/temporary_folder.h"

#include <cstdlib>
#include <string>
#include <system_error>

namespace ghost::app {

TemporaryFolder::TemporaryFolder() {
    std::error_code code;
    std::string name = (std::filesystem::temp_directory_path(code) / "ghostlight-bench-XXXXXX").string();
    if (!code && ::mkdtemp(name.data())) path = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    if (!path.empty()) std::filesystem::remove_all(path, ignored);
}

Result<void> TemporaryFolder::made() const {
    if (path.empty()) return Error{"cannot make a folder for the measurement", "TMPDIR"};
    return {};
}

} // namespace ghost::app
