#pragma once
// SPDX-License-Identifier: Apache-2.0
// SlotPictures: small pictures of what a wheel holds in its slots, for lists: a gobo as its light falls on a
// wall, else the colour of a filter. Each is made once. Window thread.

#include "fixture/type.h"

#include <QIcon>
#include <QImage>

#include <map>
#include <memory>
#include <tuple>

namespace ghost::ui {

// Null: the slot has nothing that can be seen, as a prism.
QImage slot_picture(const fixture::Type& type, const fixture::Slot& slot, int side_px);

class SlotPictures {
public:
    // side_px: in pixels of the screen. Null: there is no such slot, or nothing to be seen of it.
    QIcon of(const std::shared_ptr<const fixture::Type>& type, int wheel, int slot, int side_px);

private:
    std::map<std::tuple<std::shared_ptr<const fixture::Type>, int, int, int>, QIcon> made_;
};

} // namespace ghost::ui
