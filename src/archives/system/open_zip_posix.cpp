// SPDX-License-Identifier: Apache-2.0
#include "archives/private/open_zip.h"

namespace ghost::fixture {

zip_t* open_zip(const std::filesystem::path& path, int& code) {
    return zip_open(path.c_str(), ZIP_RDONLY, &code);
}

} // namespace ghost::fixture
