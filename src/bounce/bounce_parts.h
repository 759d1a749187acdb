#pragma once
// SPDX-License-Identifier: Apache-2.0
// Links of bounced light as far as they were found when somebody stopped: the size of cells that fits, and
// rows of so many nodes each. Files beside the links, LEVEL.PART.part, whole or not at all, with the key of
// the stage; gone when the links are there. Errors: one is kept (take_failure), and the work goes on without.
// Any thread.

#include "base/result.h"
#include "bounce/bounce.h"

#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace ghost::scene {

struct FoundLink {
    std::uint32_t receiver; // slot
    std::uint32_t emitter;  // slot
    float weight, distance_m;
};
using FoundRows = std::span<std::vector<FoundLink>>; // of each node; cells come first, then surfels

class BounceParts {
public:
    // links: their file. home: the show's folder, from which it is reached without following a link.
    BounceParts(const std::filesystem::path& links, const std::filesystem::path& home,
                const std::string& key);

    // 0: it is not known.
    float cell_m();
    void keep_cell_m(float cell_m);
    // Of nodes of a level, from one on; false: they are not there.
    // far_share: that of Bounce, of the slots of these nodes; of the coarse level none.
    bool take(const BounceLevel& level, bool is_coarse, std::size_t first, FoundRows rows,
              std::span<float> far_share);
    void keep(bool is_coarse, std::size_t first, FoundRows rows, std::span<const float> far_share);
    void remove_all();
    std::optional<Error> take_failure();

private:
    std::filesystem::path file_of(const std::string& part) const;
    std::optional<std::vector<std::uint8_t>> read(const std::string& part);
    std::optional<std::vector<std::uint8_t>> read_reserved(const std::filesystem::path& file,
                                                           std::uintmax_t size);
    void write(const std::string& part, const std::vector<std::uint8_t>& body);
    void fail(Error error);

    const std::filesystem::path links_, home_;
    const std::string key_;
    std::set<std::string> there_; // plain files
    std::mutex mutex_;            // of all below
    std::uintmax_t bytes_ = 0;
    bool keeps_ = true;
    std::optional<Error> failure_;
};

} // namespace ghost::scene
