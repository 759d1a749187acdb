// SPDX-License-Identifier: Apache-2.0
#include "render/relight/light_tree.h"

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
    changes_.resize(static_cast<std::size_t>(light_count));
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
    const bool is_above_branches = making_ == Making::by_branches && index < kBranches - 1;
    if (index < leaf_base_ &&
        (making_ == Making::one_by_one || is_above_branches || has_image_below(index))) {
        for (const int child : {tightest(2 * index + 1), tightest(2 * index + 2)}) {
            if (keep(child, plan))
                sum.addends.push_back(addend_of(child));
            else
                add_lights_below(child, sum.lights);
        }
    } else {
        add_lights_below(index, sum.lights);
        sum.at_unit = index >= leaf_base_;
    }
    const int slot = take_slot();
    if (slot < 0) return false;
    node.slot = slot;
    sum.target = slot;
    plan.sums.push_back(std::move(sum));
    return true;
}

// Changes, or did so twice a short while ago.
bool LightTree::is_moving(int light) const {
    const Changes& changes = changes_[static_cast<std::size_t>(light)];
    return changes.last == frame_ ||
           (changes.last - changes.before <= kSoon && frame_ - changes.last <= kSoon);
}

Addend LightTree::addend_of(int node) const {
    return {nodes_[static_cast<std::size_t>(node)].slot, node >= leaf_base_ ? node - leaf_base_ : -1};
}

void LightTree::add_moving(int light, Plan& plan, ImageSum& frame) {
    if (!is_changed_[static_cast<std::size_t>(light)] && keep(leaf_base_ + light, plan))
        frame.addends.push_back(addend_of(leaf_base_ + light));
    else
        frame.lights.push_back(light);
}

void LightTree::visit(int node, const std::vector<bool>& dirty, Plan& plan, ImageSum& frame) {
    node = tightest(node);
    if (!dirty[static_cast<std::size_t>(node)]) {
        if (keep(node, plan))
            frame.addends.push_back(addend_of(node));
        else
            add_lights_below(node, frame.lights);
        return;
    }
    if (node >= leaf_base_) return; // it moves
    visit(2 * node + 1, dirty, plan, frame);
    visit(2 * node + 2, dirty, plan, frame);
}

void LightTree::add_around_rest(Plan& plan, ImageSum& frame) {
    frame.addends.push_back({rest_slot(), -1});
    for (int light = 0; light < light_count_; ++light)
        if (!changes_[static_cast<std::size_t>(light)].in_rest) add_moving(light, plan, frame);
}

void LightTree::add_all(Plan& plan, ImageSum& frame) {
    std::vector<bool> dirty(nodes_.size(), false);
    bool goes_on = true; // what changes now did so a short while ago
    for (int light = 0; light < light_count_; ++light) {
        Changes& changes = changes_[static_cast<std::size_t>(light)];
        changes.in_rest = !is_moving(light);
        goes_on = goes_on && (changes.last != frame_ || changes.last - changes.before <= kSoon);
        for (int node = leaf_base_ + light; !changes.in_rest; node = (node - 1) / 2) {
            dirty[static_cast<std::size_t>(node)] = true;
            if (node == 0) break;
        }
    }
    frame.base = true;
    if (light_count_ > 0) visit(0, dirty, plan, frame);
    // What goes on will go on: what rests is kept as one image, unless there was no room for some of it.
    if (goes_on && frame.lights.empty() && frame.addends.size() > 1) {
        ImageSum rest;
        rest.target = rest_slot();
        rest.base = true;
        rest.addends = std::exchange(frame.addends, {{rest_slot(), -1}});
        frame.base = false;
        plan.sums.push_back(std::move(rest));
        rest_valid_ = true;
    }
    for (int light = 0; light < light_count_; ++light)
        if (!changes_[static_cast<std::size_t>(light)].in_rest) add_moving(light, plan, frame);
}

void LightTree::drop(int node) {
    int& slot = nodes_[static_cast<std::size_t>(node)].slot;
    if (slot >= 0) free_slots_.push_back(std::exchange(slot, -1));
}

Plan LightTree::plan(std::span<const int> changed, std::span<const int> dimmed, Making making) {
    Plan plan;
    making_ = making;
    ++frame_;
    if (changed.empty() && dimmed.empty() && frame_valid_) return plan;

    is_changed_.assign(static_cast<std::size_t>(light_count_), false);
    const auto change = [&](int light, int node) {
        CHECK(light >= 0 && light < light_count_);
        Changes& changes = changes_[static_cast<std::size_t>(light)];
        changes.before = std::exchange(changes.last, frame_);
        rest_valid_ = rest_valid_ && !changes.in_rest;
        for (; node >= 0; node = node > 0 ? (node - 1) / 2 : -1) drop(node);
    };
    for (const int light : changed) {
        change(light, leaf_base_ + light);
        is_changed_[static_cast<std::size_t>(light)] = true;
    }
    for (const int light : dimmed) change(light, leaf_base_ > 0 ? (leaf_base_ + light - 1) / 2 : -1);
    // Lights that came to rest belong to it again.
    for (const Changes& changes : changes_)
        rest_valid_ = rest_valid_ && (changes.in_rest || frame_ - changes.last <= 4 * kSoon);

    ImageSum frame;
    if (making == Making::by_branches && light_count_ > 0) {
        rest_valid_ = false;
        frame.base = true;
        visit(0, std::vector<bool>(nodes_.size(), false), plan, frame);
    } else if (rest_valid_) {
        add_around_rest(plan, frame);
    } else {
        add_all(plan, frame);
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

void LightTree::unmake(std::span<const ImageSum> sums) {
    for (const ImageSum& sum : sums) {
        if (sum.target == rest_slot()) rest_valid_ = false;
        for (std::size_t node = 0; node < nodes_.size(); ++node)
            if (sum.target >= 0 && nodes_[node].slot == sum.target) drop(static_cast<int>(node));
    }
    frame_valid_ = false;
}

void LightTree::invalidate_all() {
    for (Node& node : nodes_)
        if (node.slot >= 0) free_slots_.push_back(std::exchange(node.slot, -1));
    frame_valid_ = false;
    rest_valid_ = false;
}

} // namespace ghost::render
