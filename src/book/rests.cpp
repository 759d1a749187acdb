// SPDX-License-Identifier: Apache-2.0
#include "book/rests.h"

#include <algorithm>
#include <utility>

namespace ghost::scene {
namespace {

bool are_equal(const dmx::Universes& a, const dmx::Universes& b) {
    return std::equal(a.list.begin(), a.list.end(), b.list.begin(), b.list.end(),
                      [](const dmx::Universe& one, const dmx::Universe& other) {
                          return one.number == other.number &&
                                 (one.levels == other.levels || *one.levels == *other.levels);
                      });
}

} // namespace

void RestFinder::feed(double at_s, const dmx::Universes& levels) {
    if (since_s_ && are_equal(levels, now_)) return;
    close(at_s);
    since_s_ = at_s;
    now_ = levels;
}

std::vector<double> RestFinder::finish(double end_s) {
    close(end_s);
    return std::move(rests_s_);
}

void RestFinder::close(double until_s) {
    if (!since_s_ || until_s - *since_s_ < kRest_s || (rested_ && are_equal(*rested_, now_))) return;
    rests_s_.push_back(*since_s_);
    rested_ = now_;
}

} // namespace ghost::scene
