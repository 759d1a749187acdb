// SPDX-License-Identifier: Apache-2.0
#include "archives/private/open_zip.h"

#include <windows.h>

namespace ghost::fixture {

// What libzip opens nobody can replace meanwhile, such as the program that draws the plot.
zip_t* open_zip(const std::filesystem::path& path, int& code) {
    const HANDLE file =
        ::CreateFileW(path.c_str(), GENERIC_READ, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
                      nullptr, OPEN_EXISTING, 0, nullptr);
    code = ZIP_ER_OPEN;
    if (file == INVALID_HANDLE_VALUE) return nullptr;
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* const source = zip_source_win32handle_create(file, 0, -1, &error);
    zip_t* const zip = source != nullptr ? zip_open_from_source(source, ZIP_RDONLY, &error) : nullptr;
    if (zip == nullptr) {
        code = zip_error_code_zip(&error);
        if (source != nullptr)
            zip_source_free(source); // and with it the file
        else
            ::CloseHandle(file);
    }
    zip_error_fini(&error);
    return zip;
}

} // namespace ghost::fixture
