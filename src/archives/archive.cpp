// SPDX-License-Identifier: Apache-2.0
#include "archives/archive.h"

#include "archives/private/open_zip.h"
#include "base/text.h"

#include <zip.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <system_error>
#include <utility>

namespace ghost::fixture {

struct Archive::Zip {
    zip_t* handle = nullptr;
    ~Zip() {
        if (handle) zip_discard(handle);
    }
};

namespace {

std::string plain(std::string_view path) {
    std::string text = lower(path);
    std::replace(text.begin(), text.end(), '\\', '/');
    return text;
}

bool climbs(const std::string& entry) {
    const std::string path = plain(entry);
    if (path.starts_with('/') || (path.size() > 1 && path[1] == ':')) return true;
    const std::vector<std::string_view> parts = split(path, '/');
    return std::find(parts.begin(), parts.end(), "..") != parts.end();
}

// A zip's directory stands at its end: without it the file is no zip to a reader, however it begins.
std::string zip_fault(bool begins_as_zip, const char* why) {
    return begins_as_zip
               ? std::string("the archive is cut short or damaged at its end: it begins as a zip, but the "
                             "directory that a zip ends with is not there or does not fit (") +
                     why + "); get the file again, whole"
               : std::string("expected a zip archive: ") + why;
}

bool begins_as_zip(Bytes bytes) {
    return bytes.size() >= 4 && bytes[0] == 'P' && bytes[1] == 'K' && bytes[2] == 3 && bytes[3] == 4;
}

bool begins_as_zip(const std::filesystem::path& path) {
    std::array<char, 4> start{};
    std::ifstream file(path, std::ios::binary);
    file.read(start.data(), start.size());
    return file && begins_as_zip(Bytes(reinterpret_cast<const std::uint8_t*>(start.data()), start.size()));
}

} // namespace

Archive::Archive(std::unique_ptr<Zip> zip, std::string name, const ArchiveLimits& limits)
    : zip_(std::move(zip)), name_(std::move(name)), limits_(limits) {}
Archive::Archive(Archive&&) noexcept = default;
Archive& Archive::operator=(Archive&&) noexcept = default;
Archive::~Archive() = default;

Result<Archive> Archive::open(Bytes bytes, const std::string& name, const ArchiveLimits& limits) {
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
    if (!source) {
        Error result{std::string("cannot read the zip: ") + zip_error_strerror(&error), name};
        zip_error_fini(&error);
        return result;
    }
    auto zip = std::make_unique<Zip>();
    zip->handle = zip_open_from_source(source, ZIP_RDONLY, &error);
    if (!zip->handle) {
        zip_source_free(source);
        Error result{zip_fault(begins_as_zip(bytes), zip_error_strerror(&error)), name};
        zip_error_fini(&error);
        return result;
    }
    zip_error_fini(&error);
    return index(std::move(zip), name, limits);
}

Result<Archive> Archive::open_file(const std::filesystem::path& path, const ArchiveLimits& limits) {
    const std::string name = path.filename().string();
    // libzip waits for ever for the end of a pipe.
    if (std::error_code code; !std::filesystem::is_regular_file(path, code))
        return Error{std::filesystem::exists(path, code) ? "is not a plain file" : "no such file",
                     path.string()};
    int code = 0;
    auto zip = std::make_unique<Zip>();
    zip->handle = open_zip(path, code);
    if (!zip->handle) {
        zip_error_t error;
        zip_error_init_with_code(&error, code);
        Error result{zip_fault(begins_as_zip(path), zip_error_strerror(&error)), path.string()};
        zip_error_fini(&error);
        return result;
    }
    return index(std::move(zip), name, limits);
}

zip* Archive::handle() const {
    return zip_->handle;
}

Result<Archive> Archive::index(std::unique_ptr<Zip> zip, const std::string& name,
                               const ArchiveLimits& limits) {
    const zip_int64_t count = zip_get_num_entries(zip->handle, 0);
    if (count < 0 || static_cast<std::size_t>(count) > limits.entries)
        return Error{"the zip has " + std::to_string(count) + " entries, at most " +
                         std::to_string(limits.entries) + " are allowed",
                     name};
    Archive archive(std::move(zip), name, limits);
    for (zip_int64_t i = 0; i < count; ++i) {
        const char* entry =
            zip_get_name(archive.zip_->handle, static_cast<zip_uint64_t>(i), ZIP_FL_ENC_GUESS);
        if (entry) archive.add(entry);
    }
    return archive;
}

void Archive::add(const std::string& entry) {
    if (climbs(entry)) {
        climbing_.push_back(entry);
        return;
    }
    const auto [known, is_new] = plain_.emplace(plain(entry), names_.size());
    const auto first = names_.begin() + static_cast<std::ptrdiff_t>(known->second);
    if (!is_new && std::find(first, names_.end(), entry) != names_.end()) repeated_.push_back(entry);
    names_.push_back(entry);
}

std::string Archive::find(const std::string& path) const {
    const auto known = plain_.find(plain(path));
    if (known == plain_.end()) return "";
    const auto first = names_.begin() + static_cast<std::ptrdiff_t>(known->second);
    const auto exact = std::find(first, names_.end(), path);
    return exact != names_.end() ? *exact : *first;
}

std::uint32_t Archive::checksum(const std::string& entry) const {
    zip_stat_t stat;
    const bool known = zip_stat(zip_->handle, entry.c_str(), 0, &stat) == 0 && (stat.valid & ZIP_STAT_CRC);
    return known ? stat.crc : 0;
}

Result<std::vector<std::uint8_t>> Archive::read(const std::string& entry) {
    return read(entry, limits_.entry_bytes);
}

Result<std::vector<std::uint8_t>> Archive::read(const std::string& entry, std::uint64_t max_bytes) {
    const std::string where = name_ + ": " + entry;
    const zip_int64_t index = zip_name_locate(zip_->handle, entry.c_str(), 0);
    if (index < 0) return Error{"no such entry in the archive", where};
    const auto place = static_cast<zip_uint64_t>(index);
    zip_stat_t stat;
    if (zip_stat_index(zip_->handle, place, 0, &stat) != 0 || !(stat.valid & ZIP_STAT_SIZE))
        return Error{"the zip does not say how large this entry is", where};
    if ((stat.valid & ZIP_STAT_COMP_METHOD) && stat.comp_method != ZIP_CM_STORE &&
        stat.comp_method != ZIP_CM_DEFLATE)
        return Error{"zip method " + std::to_string(stat.comp_method) +
                         " is not supported, expected 0 (stored) or 8 (deflate)",
                     where};
    const std::uint64_t allowed = std::min(max_bytes, limits_.entry_bytes);
    if (stat.size > allowed)
        return Error{"unpacks to " + std::to_string(stat.size) + " bytes, at most " +
                         std::to_string(allowed) + " are allowed",
                     where};
    if (stat.size > limits_.total_bytes - total_read_)
        return Error{"the archive unpacks to more than the " + std::to_string(limits_.total_bytes) +
                         " bytes that are allowed",
                     where};
    if (stat.size > 1 << 20 && (stat.valid & ZIP_STAT_COMP_SIZE) &&
        stat.size / limits_.ratio > stat.comp_size)
        return Error{"unpacks to " + std::to_string(stat.size) + " bytes from " +
                         std::to_string(stat.comp_size) + ", more than " + std::to_string(limits_.ratio) +
                         " for one: taken for a zip bomb",
                     where};
    zip_file_t* file = zip_fopen_index(zip_->handle, place, 0);
    if (!file) return Error{std::string("cannot unpack: ") + zip_strerror(zip_->handle), where};
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(stat.size));
    std::size_t done = 0;
    while (done < bytes.size()) {
        const zip_int64_t got = zip_fread(file, bytes.data() + done, bytes.size() - done);
        if (got <= 0) break;
        done += static_cast<std::size_t>(got);
    }
    // One more byte makes libzip compare the checksum, and shows an entry that is longer than it claims.
    std::uint8_t extra = 0;
    const bool complete = done == bytes.size() && zip_fread(file, &extra, 1) == 0;
    zip_fclose(file);
    total_read_ += stat.size;
    if (!complete) return Error{"the entry is damaged or cut short", where};
    return bytes;
}

} // namespace ghost::fixture
