// SPDX-License-Identifier: Apache-2.0
#include "bounce/bounce_file.h"

#include "disk/crc32.h"
#include "disk/files.h"
#include "show/show.h"

#include <algorithm>
#include <cstring>
#include <type_traits>

namespace ghost::scene {
namespace {

namespace fs = std::filesystem;

constexpr char kMagic[] = "ghostlight bounce 4\n";
constexpr std::size_t kVersionAt = sizeof kMagic - 3; // its digit
constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 30;
constexpr std::size_t kKeyDigits = 32;

class Writer {
public:
    template <class T>
    void list(const std::vector<T>& items) {
        static_assert(std::is_trivially_copyable_v<T>);
        const std::uint64_t count = items.size();
        raw(&count, sizeof count);
        raw(items.data(), items.size() * sizeof(T));
    }
    void raw(const void* data, std::size_t size) {
        const auto* from = static_cast<const std::uint8_t*>(data);
        bytes.insert(bytes.end(), from, from + size);
    }
    std::vector<std::uint8_t> bytes;
};

class Reader {
public:
    explicit Reader(Bytes bytes) : bytes_(bytes) {}
    template <class T>
    void list(std::vector<T>& items) {
        std::uint64_t count = 0;
        raw(&count, sizeof count);
        if (!ok || count > bytes_.size() / sizeof(T)) {
            ok = false;
            return;
        }
        items.resize(static_cast<std::size_t>(count));
        raw(items.data(), items.size() * sizeof(T));
    }
    void raw(void* data, std::size_t size) {
        if (!ok || size > bytes_.size()) {
            ok = false;
            return;
        }
        if (size > 0) std::memcpy(data, bytes_.data(), size);
        bytes_ = bytes_.subspan(size);
    }
    bool at_end() const { return ok && bytes_.empty(); }
    bool ok = true;

private:
    Bytes bytes_;
};

template <class File, class Bounces>
void all(File& file, Bounces& bounce) {
    file.raw(&bounce.grid, sizeof bounce.grid);
    file.list(bounce.cell_of);
    for (auto* level : {&bounce.fine, &bounce.coarse}) {
        file.list(level->cells);
        file.list(level->surfels);
    }
    for (auto* rows : {&bounce.near, &bounce.far}) {
        file.list(rows->start);
        file.list(rows->links);
    }
    file.list(bounce.far_share);
    file.list(bounce.cell_parents);
    file.list(bounce.surfel_parents);
}

bool fits(const BounceRows& rows, std::size_t slots) {
    return rows.start.size() == slots + 1 && rows.start.front() == 0 &&
           std::is_sorted(rows.start.begin(), rows.start.end()) && rows.start.back() == rows.links.size() &&
           std::all_of(rows.links.begin(), rows.links.end(),
                       [&](const BounceLink& link) { return link.emitter < slots; });
}

bool fits(const std::vector<BounceParents>& parents, std::size_t children, std::size_t nodes) {
    return parents.size() == children &&
           std::all_of(parents.begin(), parents.end(), [&](const BounceParents& one) {
               return std::all_of(one.node.begin(), one.node.end(),
                                  [&](std::uint32_t node) { return node == kNoNode || node < nodes; });
           });
}

// Whether all numbers of nodes are of nodes that are there.
bool is_whole(const Bounce& bounce) {
    const BounceGrid& grid = bounce.grid;
    constexpr int kMostSubs = 1 << 16;
    if (!(grid.sub_m > 0)) return false;
    for (int k = 0; k < 3; ++k)
        if (grid.subs[k] < kSubsOfBlock || grid.subs[k] > kMostSubs || grid.subs[k] % kSubsOfBlock != 0)
            return false;
    if (grid.count() > kMostBounceSubs) return false;
    const auto voxels = [&](int of_subs) {
        const glm::ivec3 count = grid.voxels(of_subs);
        return static_cast<std::size_t>(count.x) * static_cast<std::size_t>(count.y) *
               static_cast<std::size_t>(count.z);
    };
    const std::size_t cells = bounce.fine.cells.size(), blocks = bounce.coarse.cells.size();
    return bounce.cell_of.size() == grid.count() && std::max(cells, blocks) <= kMostBounceCells &&
           std::all_of(bounce.cell_of.begin(), bounce.cell_of.end(),
                       [&](std::uint32_t cell) { return cell == kNoNode || cell < cells; }) &&
           std::all_of(bounce.fine.cells.begin(), bounce.fine.cells.end(),
                       [&](const BounceCell& cell) {
                           return cell.block < blocks && cell.volume_m3 > 0 &&
                                  cell.voxel < voxels(kSubsOfCell);
                       }) &&
           std::all_of(bounce.coarse.cells.begin(), bounce.coarse.cells.end(),
                       [&](const BounceCell& cell) { return cell.volume_m3 > 0; }) &&
           std::all_of(bounce.fine.surfels.begin(), bounce.fine.surfels.end(),
                       [&](const BounceSurfel& surfel) {
                           return surfel.cluster < bounce.coarse.surfels.size() && surfel.cell < cells &&
                                  surfel.side < 6 && surfel.area_m2 > 0 &&
                                  surfel.voxel < voxels(kSubsOfSurfel);
                       }) &&
           std::all_of(bounce.coarse.surfels.begin(), bounce.coarse.surfels.end(),
                       [](const BounceSurfel& surfel) { return surfel.area_m2 > 0; }) &&
           fits(bounce.near, bounce.fine.slots()) && fits(bounce.far, bounce.coarse.slots()) &&
           bounce.far_share.size() == bounce.fine.slots() &&
           std::all_of(bounce.far_share.begin(), bounce.far_share.end(), is_share) &&
           fits(bounce.cell_parents, cells, blocks) &&
           fits(bounce.surfel_parents, bounce.fine.surfels.size(), bounce.coarse.surfels.size());
}

} // namespace

fs::path bounce_file(const Show& show, BounceDetail level) {
    return show.cache_folder() / "bounce" /
           (std::string(kBounceDetails[static_cast<std::size_t>(level)]) + ".bin");
}

Result<void> write_bounce(const fs::path& file, const std::string& key, const Bounce& bounce) {
    Writer writer;
    writer.raw(kMagic, sizeof kMagic - 1);
    writer.raw(key.data(), key.size());
    all(writer, bounce);
    const std::uint32_t check = crc32(writer.bytes);
    writer.raw(&check, sizeof check);
    return write_file_atomic(file, Bytes(writer.bytes));
}

Result<std::optional<Bounce>> read_bounce(const fs::path& file, const std::string& key) {
    std::error_code code;
    if (!fs::exists(file, code)) return std::optional<Bounce>();
    TRY(const std::vector<std::uint8_t> bytes, read_file(file, kMostBytes));
    constexpr std::size_t kHead = sizeof kMagic - 1 + kKeyDigits;
    const auto damaged = [&] {
        return Error{"is damaged; the links of bounced light are made again", file.string()};
    };
    std::uint32_t check = 0;
    if (bytes.size() < kHead + sizeof check) return damaged();
    if (std::memcmp(bytes.data(), kMagic, kVersionAt) != 0) return damaged();
    if (std::memcmp(bytes.data(), kMagic, sizeof kMagic - 1) != 0)
        return Error{"is of another version of Ghostlight; the links of bounced light are made again, once",
                     file.string()};
    if (key.size() != kKeyDigits ||
        std::memcmp(bytes.data() + sizeof kMagic - 1, key.data(), kKeyDigits) != 0)
        return std::optional<Bounce>();
    const Bytes body(bytes.data(), bytes.size() - sizeof check);
    std::memcpy(&check, body.data() + body.size(), sizeof check);
    if (check != crc32(body)) return damaged();
    Reader reader(body.subspan(kHead));
    std::optional<Bounce> bounce(std::in_place);
    all(reader, *bounce);
    if (!reader.at_end() || !is_whole(*bounce)) return damaged();
    return bounce;
}

} // namespace ghost::scene
