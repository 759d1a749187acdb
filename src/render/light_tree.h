#pragma once
// SPDX-License-Identifier: Apache-2.0
// LightTree: the binary tree of summed images (Screen Space Re-Rendering, section 3) as bookkeeping: which
// images to make, which to add, which to keep. No pixels in here, so the counts can be tested without a GPU.
// Main thread.
//
// Leaves are lights; an inner node is the sum below it. Lights that change in a frame are drawn straight into
// the frame, and the largest clean subtrees beside them are added: one changed light of n costs ceil(log2 n)
// additions or less. While the same lights go on changing, the sum of all others is kept as one more image,
// and a frame costs one addition. A light that rests again gets its images back lazily. Only a limited number
// of images is kept; past that, the least recently used one goes, and lights without an image are drawn into
// the frame like changed ones.

#include <cstdint>
#include <span>
#include <vector>

namespace ghost::render {

// Make an image: the sum of some lights, drawn, and of some kept images.
struct ImageSum {
    int target = -1;          // slot of a kept image; -1: the frame
    bool base = false;        // with the picture without lights
    std::vector<int> lights;  // to draw
    std::vector<int> addends; // slots to add
};

struct Plan {
    std::vector<ImageSum> sums; // in this order; the last one is the frame; empty: the frame stands as it is
    int drawn = 0;              // lights drawn
    int additions = 0;          // additions of two images, over all sums
};

class LightTree {
public:
    // slot_count: images that may be kept.
    LightTree(int light_count, int slot_count);

    // Slot of the image of all lights that rest, beside the slot_count others.
    int rest_slot() const { return slot_count_; }

    // changed: lights that differ from the last frame, any order, each once.
    Plan plan(std::span<const int> changed);
    // The frame must be made again, from the images that are kept.
    void invalidate_frame() { frame_valid_ = false; }
    // Forget every image (haze, camera or steps changed).
    void invalidate_all();
    int light_count() const { return light_count_; }

private:
    struct Node {
        int slot = -1; // kept image, -1: none
        std::uint64_t used = 0;
    };
    bool exists(int node) const;
    int tightest(int node) const; // the lowest node with the same lights
    bool has_image_below(int node) const;
    void add_lights_below(int node, std::vector<int>& lights) const;
    int take_slot();
    bool keep(int node, Plan& plan);
    void visit(int node, const std::vector<bool>& dirty, Plan& plan, ImageSum& frame);

    int light_count_;
    int slot_count_;
    int leaf_base_; // nodes are a heap: children of i are 2i+1, 2i+2
    std::vector<Node> nodes_;
    std::vector<int> free_slots_;
    std::uint64_t frame_ = 0;
    bool frame_valid_ = false;
    bool rest_valid_ = false;       // the image of all that did not change
    std::vector<int> last_changed_; // sorted
};

} // namespace ghost::render
