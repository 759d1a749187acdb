// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/slot_picture.h"

#include "image/colour.h"
#include "ui/actions/programmer_actions.h"

#include <QPainter>
#include <QPainterPath>
#include <QPixmap>

#include <algorithm>

namespace ghost::ui {
namespace {

constexpr std::size_t kMostPictures = 2000; // of all shows that were open; then they are made again

// How bright a filter is does not tell it from others, for in a small list all would be dark.
QColor filter_on_screen(const fixture::ColorCie& colour) {
    glm::vec3 rgb = glm::max(image::xyy_to_rec2020({colour.x, colour.y, 1}), glm::vec3(0));
    if (colour.Y <= 0) rgb = glm::vec3(0);
    rgb /= std::max({rgb.x, rgb.y, rgb.z, 1e-6f});
    return screen_colour(rgb);
}

QImage square_of(const fixture::Media& media) {
    const QImage whole(media.rgba.data(), media.width, media.height, 4 * media.width,
                       QImage::Format_RGBA8888);
    const int side = std::min(media.width, media.height);
    return whole.copy((media.width - side) / 2, (media.height - side) / 2, side, side);
}

} // namespace

QImage slot_picture(const fixture::Type& type, const fixture::Slot& slot, int side_px) {
    const fixture::Media* const media =
        slot.media >= 0 ? &type.media[static_cast<std::size_t>(slot.media)] : nullptr;
    const bool has_picture = media && !media->rgba.empty() && media->width > 0 && media->height > 0;
    if (side_px <= 0 || (!has_picture && !slot.facets.empty())) return {};
    QImage picture(side_px, side_px, QImage::Format_ARGB32_Premultiplied);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    const QRectF disc = QRectF(picture.rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    QPainterPath round;
    round.addEllipse(disc);
    if (has_picture) {
        painter.fillPath(round, Qt::black); // what it blocks
        painter.setClipPath(round);
        painter.drawImage(picture.rect(), square_of(*media).scaled(picture.size(), Qt::IgnoreAspectRatio,
                                                                   Qt::SmoothTransformation));
        painter.setClipping(false);
    } else {
        painter.fillPath(round, filter_on_screen(slot.color));
    }
    painter.setPen(QColor(128, 128, 128)); // seen on any ground
    painter.drawPath(round);
    return picture;
}

QIcon SlotPictures::of(const std::shared_ptr<const fixture::Type>& type, int wheel, int slot, int side_px) {
    if (!type || wheel < 0 || slot < 0 || static_cast<std::size_t>(wheel) >= type->wheels.size()) return {};
    const std::vector<fixture::Slot>& slots = type->wheels[static_cast<std::size_t>(wheel)].slots;
    if (static_cast<std::size_t>(slot) >= slots.size()) return {};
    if (made_.size() >= kMostPictures) made_.clear();
    const auto [entry, is_new] = made_.try_emplace({type, wheel, slot, side_px});
    if (is_new)
        if (const QImage picture = slot_picture(*type, slots[static_cast<std::size_t>(slot)], side_px);
            !picture.isNull())
            entry->second = QIcon(QPixmap::fromImage(picture));
    return entry->second;
}

} // namespace ghost::ui
