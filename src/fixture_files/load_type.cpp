// SPDX-License-Identifier: Apache-2.0
#include "fixture_files/load_type.h"

#include "base/text.h"
#include "fixture_files/gdtf/gdtf.h"
#include "fixture_files/ofl/ofl.h"
#include "fixture_files/qxf/qxf.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string>

namespace ghost::fixture {
namespace {

enum class Format { gdtf, qxf, ofl, unknown }; // as kTypeEndings counts them

Format format_of_name(const std::filesystem::path& path) {
    const auto found = std::find(kTypeEndings.begin(), kTypeEndings.end(), lower(path.extension().string()));
    return static_cast<Format>(found - kTypeEndings.begin());
}

// By the first character that says something; a byte order mark may go before it.
Format format_of_start(std::string_view start) {
    if (start.starts_with("PK")) return Format::gdtf;
    if (start.starts_with("\xEF\xBB\xBF")) start.remove_prefix(3);
    start = trimmed(start);
    if (start.starts_with('<')) return Format::qxf;
    if (start.starts_with('{')) return Format::ofl;
    return Format::unknown;
}

} // namespace

bool has_type_extension(const std::filesystem::path& path) {
    return format_of_name(path) != Format::unknown;
}

Result<LoadedType> load_type(const std::filesystem::path& path) {
    Format format = Format::unknown;
    std::error_code code;
    if (std::filesystem::is_regular_file(path, code)) { // a pipe would block
        std::array<char, 256> start{};
        std::ifstream file(path, std::ios::binary);
        file.read(start.data(), start.size());
        format = format_of_start({start.data(), static_cast<std::size_t>(file.gcount())});
    }
    if (format == Format::unknown) format = format_of_name(path);
    switch (format) {
    case Format::gdtf:
        return load_gdtf(path);
    case Format::qxf:
        return load_qxf(path);
    case Format::ofl:
        return load_ofl(path);
    case Format::unknown:
        break;
    }
    return Error{"is no fixture file: expected GDTF (.gdtf), QLC+ (.qxf) or Open Fixture Library (.json)",
                 path.string()};
}

} // namespace ghost::fixture
