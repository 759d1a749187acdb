#pragma once
// SPDX-License-Identifier: Apache-2.0
// LightTree: the binary tree of summed images (Screen Space Re-Rendering, section 3) as bookkeeping: which
// images to make, which to add, which to keep. No pixels in here, so the counts can be tested without a GPU.
// Main thread.
//
// Leaves are lights; an inner node is the sum below it. Lights that change in a frame are drawn straight into
// the frame, and the largest clean subtrees beside them are added: one changed light of n costs ceil(log2 n)
// additions or less. Light is linear: the image of one light holds it at a unit of its own, so a light of
// which only the intensity changed is that image, added with another weight. While lights go on changing, the
// sum of all that do not is kept as one more image. A light that rests again gets its images back lazily.
// Only a limited number of images is kept; past that, the least recently used one goes, and lights without an
// image are drawn into the frame like changed ones.

#include <cstdint>
#include <span>
#include <vector>

namespace ghost::render {

// A kept image to add.
struct Addend {
    int slot = -1;
    int light = -1; // whose image at its unit it is: weighed by what the light is now; -1: a sum, as it is
};

// Make an image: the sum of some lights, drawn, and of some kept images.
struct ImageSum {
    int target = -1;         // slot of a kept image; -1: the frame
    bool base = false;       // with the picture without lights
    bool at_unit = false;    // its one light is drawn at its unit
    std::vector<int> lights; // to draw
    std::vector<Addend> addends;
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

    static constexpr int kBranches = 8; // of the tree, at most

    // changed: lights that differ from the last frame; dimmed: those that differ in nothing but their weight.
    // Any order, each once. one_by_one: each light that is made into an image gets one of its own first, so
    // that little is lost where it is not made to the end. What changes rests for the next frames
    // (LightBudget): branches of the tree are made into images at once.
    enum class Making { as_needed, one_by_one, by_branches };
    Plan plan(std::span<const int> changed, std::span<const int> dimmed = {},
              Making making = Making::as_needed);
    // These sums of the last plan, the frame among them, were not made.
    void unmake(std::span<const ImageSum> sums);
    // The frame must be made again, from the images that are kept.
    void invalidate_frame() { frame_valid_ = false; }
    // Forget every image (haze, camera or steps changed).
    void invalidate_all();
    int light_count() const { return light_count_; }

private:
    // Frames in which a light that changes again counts as moving.
    static constexpr std::uint64_t kSoon = 6;

    struct Node {
        int slot = -1; // kept image, -1: none
        std::uint64_t used = 0;
    };
    struct Changes {
        std::uint64_t last = 0, before = 0; // frames
        bool in_rest = false;
    };
    bool exists(int node) const;
    int tightest(int node) const; // the lowest node with the same lights
    bool has_image_below(int node) const;
    void add_lights_below(int node, std::vector<int>& lights) const;
    void drop(int node);
    int take_slot();
    bool keep(int node, Plan& plan);
    bool is_moving(int light) const;
    Addend addend_of(int node) const;
    void add_moving(int light, Plan& plan, ImageSum& frame);
    void visit(int node, const std::vector<bool>& dirty, Plan& plan, ImageSum& frame);
    void add_around_rest(Plan& plan, ImageSum& frame);
    void add_all(Plan& plan, ImageSum& frame);

    int light_count_;
    int slot_count_;
    int leaf_base_; // nodes are a heap: children of i are 2i+1, 2i+2
    std::vector<Node> nodes_;
    std::vector<Changes> changes_; // of lights
    std::vector<bool> is_changed_; // of lights, in this frame
    std::vector<int> free_slots_;
    std::uint64_t frame_ = 2 * kSoon; // so that nothing seems to have changed before the first one
    Making making_ = Making::as_needed;
    bool frame_valid_ = false;
    bool rest_valid_ = false; // the image of all lights that are in_rest
};

} // namespace ghost::render
