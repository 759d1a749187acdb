// SPDX-License-Identifier: Apache-2.0
#include "bounce/bounce_parts.h"

#include "disk/crc32.h"
#include "disk/files.h"
#include "disk/own_folder.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>

namespace ghost::scene {
namespace {

constexpr char kPartMagic[] = "ghostlight bounce part 3\n";
constexpr std::uintmax_t kMostPartsBytes = std::uintmax_t{256} << 20; // of one set of links
constexpr const char* kSizePart = "size";

std::string rows_part(bool is_coarse, std::size_t first) {
    return (is_coarse ? "far-" : "near-") + std::to_string(first);
}

std::size_t node_of_slot(const BounceLevel& level, std::uint32_t slot) {
    const std::size_t in_cells = level.cells.size() * kBounceBins;
    return slot < in_cells ? slot / kBounceBins : level.cells.size() + (slot - in_cells);
}

} // namespace

BounceParts::BounceParts(const std::filesystem::path& links, const std::filesystem::path& home,
                         const std::string& key)
    : links_(links), home_(home), key_(key) {
    const auto folder = OwnFolder::open(links_.parent_path(), home_);
    if (!folder.ok()) return;
    for (const OwnFolder::File& file : folder->entries().files) there_.insert(file.name);
}

float BounceParts::cell_m() {
    const auto body = read(kSizePart);
    float cell_m = 0;
    if (!body || body->size() != sizeof cell_m) return 0;
    std::memcpy(&cell_m, body->data(), sizeof cell_m);
    return cell_m;
}

void BounceParts::keep_cell_m(float cell_m) {
    std::vector<std::uint8_t> body(sizeof cell_m);
    std::memcpy(body.data(), &cell_m, sizeof cell_m);
    write(kSizePart, body);
}

bool BounceParts::take(const BounceLevel& level, bool is_coarse, std::size_t first, FoundRows rows,
                       std::span<float> far_share) {
    const std::string part = rows_part(is_coarse, first);
    const auto body = read(part);
    if (!body) return false;
    const auto damaged = [&] {
        for (auto& row : rows) row.clear();
        std::fill(far_share.begin(), far_share.end(), 0.0f);
        fail({"is damaged; that part of the links of bounced light is made again", file_of(part).string()});
        return false;
    };
    std::size_t at = 0;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        std::uint32_t count = 0;
        if (body->size() - at < sizeof count) return damaged();
        std::memcpy(&count, body->data() + at, sizeof count);
        at += sizeof count;
        if (count > (body->size() - at) / sizeof(FoundLink)) return damaged();
        rows[k].resize(count);
        if (count > 0) std::memcpy(rows[k].data(), body->data() + at, count * sizeof(FoundLink));
        at += count * sizeof(FoundLink);
        for (const FoundLink& link : rows[k])
            if (node_of_slot(level, link.receiver) != first + k || link.emitter >= level.slots() ||
                !(link.weight > 0) || !(link.distance_m >= 0) ||
                !std::isfinite(link.weight + link.distance_m))
                return damaged();
    }
    if (body->size() - at != far_share.size_bytes()) return damaged();
    if (!far_share.empty()) std::memcpy(far_share.data(), body->data() + at, far_share.size_bytes());
    return std::all_of(far_share.begin(), far_share.end(), is_share) || damaged();
}

void BounceParts::keep(bool is_coarse, std::size_t first, FoundRows rows, std::span<const float> far_share) {
    std::vector<std::uint8_t> body;
    const auto add = [&](const void* data, std::size_t size) {
        const auto* from = static_cast<const std::uint8_t*>(data);
        body.insert(body.end(), from, from + size);
    };
    for (const auto& row : rows) {
        const auto count = static_cast<std::uint32_t>(row.size());
        add(&count, sizeof count);
        add(row.data(), row.size() * sizeof(FoundLink));
    }
    add(far_share.data(), far_share.size_bytes());
    write(rows_part(is_coarse, first), body);
}

void BounceParts::remove_all() {
    const auto folder = OwnFolder::open(links_.parent_path(), home_);
    if (!folder.ok()) return;
    for (const OwnFolder::File& file : folder->entries().files)
        if (file.name.starts_with(links_.stem().string() + ".") && file.name.ends_with(".part"))
            folder->remove_file(file.name);
}

std::optional<Error> BounceParts::take_failure() {
    const std::lock_guard lock(mutex_);
    return std::exchange(failure_, std::nullopt);
}

std::filesystem::path BounceParts::file_of(const std::string& part) const {
    return links_.parent_path() / (links_.stem().string() + "." + part + ".part");
}

void BounceParts::fail(Error error) {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::move(error);
}

std::optional<std::vector<std::uint8_t>> BounceParts::read(const std::string& part) {
    const std::filesystem::path file = file_of(part);
    if (!there_.contains(file.filename().string())) return std::nullopt;
    std::error_code code;
    std::uintmax_t size = std::filesystem::file_size(file, code);
    if (code) size = 0;
    {
        const std::lock_guard lock(mutex_);
        if (size > kMostPartsBytes - std::min(bytes_, kMostPartsBytes)) {
            if (!failure_)
                failure_ =
                    Error{"is " + std::to_string(size) + " bytes, and all parts together have at most " +
                              std::to_string(kMostPartsBytes) +
                              "; that part of the links of bounced light is made again",
                          file.string()};
            return std::nullopt;
        }
        bytes_ += size;
    }
    auto body = read_reserved(file, size);
    if (!body) {
        const std::lock_guard lock(mutex_);
        bytes_ -= size;
    }
    return body;
}

std::optional<std::vector<std::uint8_t>> BounceParts::read_reserved(const std::filesystem::path& file,
                                                                    std::uintmax_t size) {
    auto bytes = read_file(file, size);
    if (!bytes.ok()) {
        fail(bytes.error());
        return std::nullopt;
    }
    const std::string head = kPartMagic + key_;
    std::uint32_t check = 0;
    // Of another stage or version: it is written anew.
    if (bytes->size() < head.size() + sizeof check ||
        std::memcmp(bytes->data(), head.data(), head.size()) != 0)
        return std::nullopt;
    const Bytes whole(bytes->data(), bytes->size() - sizeof check);
    std::memcpy(&check, whole.data() + whole.size(), sizeof check);
    if (check != crc32(whole)) {
        fail({"is damaged; that part of the links of bounced light is made again", file.string()});
        return std::nullopt;
    }
    return std::vector<std::uint8_t>(whole.begin() + static_cast<std::ptrdiff_t>(head.size()), whole.end());
}

void BounceParts::write(const std::string& part, const std::vector<std::uint8_t>& body) {
    std::string head = kPartMagic + key_;
    std::vector<std::uint8_t> bytes(head.begin(), head.end());
    bytes.insert(bytes.end(), body.begin(), body.end());
    const std::uint32_t check = crc32(bytes);
    const auto* const last = reinterpret_cast<const std::uint8_t*>(&check);
    bytes.insert(bytes.end(), last, last + sizeof check);
    {
        const std::lock_guard lock(mutex_);
        if (!keeps_ || bytes_ + bytes.size() > kMostPartsBytes) return;
        bytes_ += bytes.size();
    }
    const auto folder = OwnFolder::open(links_.parent_path(), home_, OwnFolder::Missing::is_made);
    Result<void> written =
        folder.ok() ? write_file_atomic(file_of(part), Bytes(bytes)) : Result<void>(folder.error());
    if (written.ok()) return;
    fail({written.error().what + "; links of bounced light that are stopped would begin anew",
          written.error().where});
    const std::lock_guard lock(mutex_);
    keeps_ = false;
}

} // namespace ghost::scene
