// SPDX-License-Identifier: Apache-2.0
#include "dmx/wire/universes.h"

#include <algorithm>

namespace ghost::dmx {

namespace {

const std::shared_ptr<const Levels>& dark() {
    static const auto levels = std::make_shared<const Levels>();
    return levels;
}

bool before(const Universe& universe, std::uint16_t number) {
    return universe.number < number;
}

} // namespace

const Universe* Universes::find(std::uint16_t number) const {
    const auto found = std::lower_bound(list.begin(), list.end(), number, before);
    return found != list.end() && found->number == number ? &*found : nullptr;
}

std::uint8_t Universes::level(std::uint16_t number, int address) const {
    const Universe* universe = find(number);
    if (!universe || address < 1 || address > static_cast<int>(kSlots)) return 0;
    return (*universe->levels)[static_cast<std::size_t>(address - 1)];
}

Universe& Universes::at(std::uint16_t number) {
    auto found = std::lower_bound(list.begin(), list.end(), number, before);
    if (found == list.end() || found->number != number) {
        Universe universe;
        universe.number = number;
        universe.levels = dark();
        found = list.insert(found, std::move(universe));
    }
    return *found;
}

} // namespace ghost::dmx
