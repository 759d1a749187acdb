// SPDX-License-Identifier: Apache-2.0
#include "archives/byte_source.h"

#include <algorithm>

namespace ghost::dmx {

namespace fs = std::filesystem;

Result<ByteSource> ByteSource::open(const fs::path& path) {
    std::error_code code;
    if (!fs::exists(path, code)) return Error{"no such file", path.string()};
    if (!fs::is_regular_file(path, code)) return Error{"not a plain file", path.string()};
    const std::uintmax_t size = fs::file_size(path, code);
    if (code) return Error{"cannot read its size: " + code.message(), path.string()};
    std::ifstream file(path, std::ios::binary);
    if (!file) return Error{"cannot open", path.string()};
    std::uint8_t first[3] = {};
    file.read(reinterpret_cast<char*>(first), sizeof first);
    const bool packed = GzipFile::recognises(Bytes(first, static_cast<std::size_t>(file.gcount())));
    file.clear();
    if (!packed) return ByteSource(std::move(file), size);
    ByteSource source((std::vector<std::uint8_t>()));
    source.gzip_ = std::make_unique<GzipFile>(std::move(file), size);
    return source;
}

std::size_t ByteSource::read(std::uint64_t offset, std::span<std::uint8_t> target) {
    if (gzip_) return gzip_->read(offset, target);
    if (offset >= size_) return 0;
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(target.size(), size_ - offset));
    if (!file_.is_open()) {
        std::copy_n(memory_.begin() + static_cast<std::ptrdiff_t>(offset), count, target.begin());
        return count;
    }
    file_.clear();
    file_.seekg(static_cast<std::streamoff>(offset));
    file_.read(reinterpret_cast<char*>(target.data()), static_cast<std::streamsize>(count));
    return static_cast<std::size_t>(std::max<std::streamsize>(file_.gcount(), 0));
}

} // namespace ghost::dmx
