#pragma once
// SPDX-License-Identifier: Apache-2.0
// BookDifference: what became of an older book: entries and fixtures added, gone, changed, moved, patched
// elsewhere, and how far each picture is from the older one. Entries match by number, else by name,
// fixtures by the plot's UUID, else by name. Pure, any thread.

#include "base/result.h"
#include "book/book.h"
#include "image/image.h"

#include <optional>
#include <string>
#include <vector>

namespace ghost::scene {

// FLIP (image/flip.h), 0..1.
struct PictureDifference {
    enum class Seen { same_pixels, not_seen, seen, large };
    Seen seen = Seen::same_pixels;
    double mean = 0;
    double p99 = 0;
    double max = 0;
    double share = 0; // of the picture, where it is above 0.1
};
std::string words_of(PictureDifference::Seen seen, const PrintStyle& style);

struct ComparedPicture {
    std::string name; // of the entry
    std::string camera;
    std::string file, old_file, map_file;        // below the folder; "": there is none, or none is needed
    std::optional<PictureDifference> difference; // none: not compared
    std::string why_not;
};

struct BookDifference {
    std::string old_name;
    std::vector<std::string> entries;      // sentences: "'Verse' is new"
    std::vector<std::string> fixtures;     // "Spot 1 moved by 0.40 m"
    std::vector<ComparedPicture> pictures; // those that differ most come first
    std::vector<std::string> unknown;
};

// Without the pictures.
BookDifference difference_of(const Book& old, const Book& now, const PrintStyle& style = {});
// For each entry of now its place in the older book: that of its number, else that of its name.
std::vector<std::optional<std::size_t>> older_entries(const Book& old, const Book& now);

// map: gets a picture of where they differ, if they do. Error: of other sizes.
Result<PictureDifference> compare_pictures(const image::Image8& old, const image::Image8& now,
                                           image::Image8& map);
// Those that differ most first; of equal ones the order stays.
void sort_by_difference(std::vector<ComparedPicture>& pictures);

} // namespace ghost::scene
