// SPDX-License-Identifier: Apache-2.0
#include "dmx/record/changes.h"

#include <algorithm>

namespace ghost::dmx {

using std::chrono::microseconds;
using std::chrono::nanoseconds;

void Changes::look_at(const Universe& universe, nanoseconds now, std::vector<RecordedFrame>& out) {
    Known& known = known_[universe.number];
    const bool changed = !known.any || universe.revision != known.revision;
    const bool arrived = !known.any || universe.arrival != known.arrival;
    known.arrival = universe.arrival;
    if (!changed && universe.lost == known.lost) return;
    const std::uint16_t used = std::max(known.slots, universe.slot_count);
    known = {true, universe.lost, universe.revision, universe.arrival, used};
    out.push_back({std::chrono::floor<microseconds>(arrived ? universe.arrival : now), universe.number, used,
                   universe.lost, universe.levels});
}

void Changes::order(std::vector<RecordedFrame>& out, std::size_t first) {
    std::stable_sort(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(),
                     [](const RecordedFrame& a, const RecordedFrame& b) { return a.time < b.time; });
    for (std::size_t i = first; i < out.size(); ++i) last_ = out[i].time = std::max(out[i].time, last_);
}

void Changes::find(const Universes& universes, nanoseconds now, std::vector<RecordedFrame>& out) {
    const std::size_t first = out.size();
    for (const Universe& universe : universes.list) look_at(universe, now, out);
    order(out, first);
}

void Changes::find(const Universe& universe, nanoseconds now, std::vector<RecordedFrame>& out) {
    const std::size_t first = out.size();
    look_at(universe, now, out);
    order(out, first);
}

} // namespace ghost::dmx
