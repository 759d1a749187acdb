// SPDX-License-Identifier: Apache-2.0
#include "render/light_tree.h"

#include "base/check.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace ghost::render {

LightTree::LightTree(int light_count, int slot_count) : light_count_(light_count), slot_count_(slot_count) {
    CHECK(light_count >= 0 && slot_count >= 0);
    const auto leaves = static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(light_count, 1))));
    leaf_base_ = leaves - 1;
    nodes_.resize(static_cast<std::size_t>(leaf_base_ + leaves));
    for (int slot = slot_count - 1; slot >= 0; --slot) free_slots_.push_back(slot);
}

bool LightTree::exists(int node) const {
    while (node < leaf_base_) node = 2 * node + 1;
    return node - leaf_base_ < light_count_;
}

int LightTree::tightest(int node) const {
    while (node < leaf_base_ && !exists(2 * node + 2)) node = 2 * node + 1;
    return node;
}

bool LightTree::has_image_below(int node) const {
    if (node >= leaf_base_) return false;
    for (const int child : {2 * node + 1, 2 * node + 2})
        if (nodes_[static_cast<std::size_t>(child)].slot >= 0 || has_image_below(child)) return true;
    return false;
}

void LightTree::add_lights_below(int node, std::vector<int>& lights) const {
    if (!exists(node)) return;
    if (node >= leaf_base_) {
        lights.push_back(node - leaf_base_);
        return;
    }
    add_lights_below(2 * node + 1, lights);
    add_lights_below(2 * node + 2, lights);
}

// A free slot, or that of the image used longest ago before this frame; -1 where all are needed now.
int LightTree::take_slot() {
    if (!free_slots_.empty()) {
        const int slot = free_slots_.back();
        free_slots_.pop_back();
        return slot;
    }
    Node* oldest = nullptr;
    for (Node& node : nodes_)
        if (node.slot >= 0 && node.used < frame_ && (!oldest || node.used < oldest->used)) oldest = &node;
    if (!oldest) return -1;
    return std::exchange(oldest->slot, -1);
}

// Makes sure that a clean, tightest node has an image. False where there is no room for it.
bool LightTree::keep(int index, Plan& plan) {
    Node& node = nodes_[static_cast<std::size_t>(index)];
    node.used = frame_;
    if (node.slot >= 0) return true;

    ImageSum sum;
    if (has_image_below(index)) {
        for (const int child : {tightest(2 * index + 1), tightest(2 * index + 2)}) {
            if (keep(child, plan))
                sum.addends.push_back(nodes_[static_cast<std::size_t>(child)].slot);
            else
                add_lights_below(child, sum.lights);
        }
    } else {
        add_lights_below(index, sum.lights);
    }
    const int slot = take_slot();
    if (slot < 0) return false;
    node.slot = slot;
    sum.target = slot;
    plan.sums.push_back(std::move(sum));
    return true;
}

void LightTree::visit(int node, const std::vector<bool>& dirty, Plan& plan, ImageSum& frame) {
    node = tightest(node);
    if (!dirty[static_cast<std::size_t>(node)]) {
        if (keep(node, plan))
            frame.addends.push_back(nodes_[static_cast<std::size_t>(node)].slot);
        else
            add_lights_below(node, frame.lights);
        return;
    }
    if (node >= leaf_base_) {
        frame.lights.push_back(node - leaf_base_);
        return;
    }
    visit(2 * node + 1, dirty, plan, frame);
    visit(2 * node + 2, dirty, plan, frame);
}

Plan LightTree::plan(std::span<const int> changed) {
    ++frame_;
    Plan plan;
    if (changed.empty() && frame_valid_) return plan;

    std::vector<bool> dirty(nodes_.size(), false);
    for (const int light : changed) {
        CHECK(light >= 0 && light < light_count_);
        for (int node = leaf_base_ + light;; node = (node - 1) / 2) {
            dirty[static_cast<std::size_t>(node)] = true;
            int& slot = nodes_[static_cast<std::size_t>(node)].slot;
            if (slot >= 0) free_slots_.push_back(std::exchange(slot, -1));
            if (node == 0) break;
        }
    }
    std::vector<int> sorted(changed.begin(), changed.end());
    std::sort(sorted.begin(), sorted.end());
    const bool same_again = sorted == last_changed_;
    last_changed_ = sorted;

    ImageSum frame;
    if (same_again && rest_valid_) {
        frame.lights = std::move(sorted);
        frame.addends = {rest_slot()};
    } else {
        if (light_count_ > 0) visit(0, dirty, plan, frame);
        frame.base = true;
        // A pattern that repeats will go on: keep what rests as one image, unless there was no room for some
        // of it.
        rest_valid_ = same_again && frame.lights.size() == sorted.size() && frame.addends.size() > 1;
        if (rest_valid_) {
            ImageSum rest;
            rest.target = rest_slot();
            rest.base = true;
            rest.addends = std::exchange(frame.addends, {rest_slot()});
            frame.base = false;
            plan.sums.push_back(std::move(rest));
        }
    }
    plan.sums.push_back(std::move(frame));
    frame_valid_ = true;

    for (const ImageSum& sum : plan.sums) {
        plan.drawn += static_cast<int>(sum.lights.size());
        const int images = static_cast<int>(sum.addends.size()) + (sum.lights.empty() ? 0 : 1);
        plan.additions += std::max(images - 1, 0);
    }
    return plan;
}

void LightTree::invalidate_all() {
    for (Node& node : nodes_)
        if (node.slot >= 0) free_slots_.push_back(std::exchange(node.slot, -1));
    frame_valid_ = false;
    rest_valid_ = false;
}

} // namespace ghost::render
