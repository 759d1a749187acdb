// SPDX-License-Identifier: Apache-2.0
#include "ui/picture/private/chips.h"

#include "ui/actions/bounce_edit.h"
#include "ui/actions/programmer_actions.h"
#include "ui/language/language.h"
#include "ui/widgets/shortened.h"
#include "ui/widgets/theme.h"

#include <QFontMetricsF>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

namespace ghost::ui {
namespace {

constexpr double kGap_px = 6, kEdge_px = 8;
constexpr double kLoud = 1.5; // times the letters of the others
constexpr int kMostLetters = 50;

QString clock_of(double seconds) {
    const int whole = static_cast<int>(std::floor(std::max(seconds, 0.0)));
    return QString("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QChar('0'));
}

// A look that is only held must not pass for one that a desk sends.
Chip of_desk(const std::vector<dmx::Universe>& universes) {
    std::chrono::nanoseconds newest{0};
    int lost = 0;
    for (const dmx::Universe& universe : universes) {
        lost += universe.lost ? 1 : 0;
        newest = std::max(newest, universe.arrival);
    }
    if (lost == 0) return {translated("Chips", "LIVE DESK"), good()};
    if (lost < static_cast<int>(universes.size()))
        return {translated("Chips", "LIVE DESK, %n universe(s) silent", nullptr, lost), accent()};
    const auto silent = std::chrono::steady_clock::now().time_since_epoch() - newest;
    return {
        translated("Chips", "DESK SILENT %1 s").arg(std::chrono::floor<std::chrono::seconds>(silent).count()),
        bad()};
}

Chip of_input(const AppModel& app) {
    const RigNow& rig = app.rig();
    if (rig.from_desk && !rig.universes.list.empty()) return of_desk(rig.universes.list);
    if (rig.recording_s > 0) return {translated("Chips", "REC %1").arg(clock_of(app.moment_s())), {}};
    return {translated("Chips", "NO DESK YET"), {}};
}

// What a remote control asks for is nobody's here: no key of the window gives it back.
void add_remote(const RemoteNow& remote, std::vector<Chip>& chips) {
    if (remote.master < 1)
        chips.push_back(
            {translated("Chips", "MASTER %1 % (remote)").arg(std::lround(100 * remote.master)), accent()});
    if (remote.haze != 1.0f)
        chips.push_back(
            {translated("Chips", "HAZE x %1 (remote)").arg(static_cast<double>(remote.haze), 0, 'g', 3),
             accent()});
    if (remote.tone)
        chips.push_back({translated("Chips", "TONE %1 (remote)")
                             .arg(QString::fromStdString(image::name_of(*remote.tone))),
                         accent()});
}

} // namespace

std::vector<Chip> chips_of(const AppModel& app) {
    const Picture& picture = app.picture();
    const ViewRequest& request = app.request();
    std::vector<Chip> chips;
    // The show before is seen until then.
    if (app.is_opening() && !app.activity().empty())
        chips.push_back({shortened(said(app.activity()), kMostLetters), accent(), true});
    const RemoteNow& remote = app.rig().remote;
    if (request.black_out) chips.push_back({translated("Chips", "BLACK-OUT"), bad(), true});
    if (remote.black_out) chips.push_back({translated("Chips", "BLACK-OUT (remote)"), bad(), true});
    if (request.frozen) chips.push_back({translated("Chips", "FROZEN"), QColor(110, 190, 255), true});
    chips.push_back(of_input(app));
    if (app.rig().recorded_s >= 0)
        chips.push_back({translated("Chips", "RECORDING %1").arg(clock_of(app.rig().recorded_s)), bad()});
    if (picture.has_work_light) chips.push_back({translated("Chips", "WORK LIGHT"), QColor(255, 236, 190)});
    const QString ev = QString("EV %1").arg(static_cast<double>(picture.ev100), 0, 'f', 1);
    chips.push_back(remote.ev100 ? Chip{translated("Chips", "%1 (remote)").arg(ev), accent()} : Chip{ev, {}});
    if (request.master < 1)
        chips.push_back(
            {translated("Chips", "MASTER %1 %").arg(std::lround(100 * request.master)), accent()});
    add_remote(remote, chips);
    if (!app.look().is_empty())
        chips.push_back({translated("Chips", "by hand: %1").arg(words_of(app.look())), accent()});
    if (picture.left_dark > 0)
        chips.push_back(
            {translated("Chips", "%n head(s) that nobody asks left dark", nullptr, picture.left_dark), {}});
    if (picture.missing_shadows > 0)
        chips.push_back(
            {translated("Chips", "%n light(s) throw no shadows yet", nullptr, picture.missing_shadows), {}});
    if (!app.is_opening() && !app.activity().empty())
        chips.push_back({shortened(said(app.activity()), kMostLetters), {}});
    if (app.bounce().state == BounceNow::State::makes_links)
        chips.push_back({translated("Chips", "bounced light: %1").arg(words_of(app.bounce())), {}});
    return chips;
}

void paint_chips(QPainter& painter, const QSizeF& widget, const std::vector<Chip>& chips, double lift_px) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const QFont usual = painter.font();
    double x = kEdge_px, bottom = widget.height() - kEdge_px - lift_px;
    for (const Chip& chip : chips) {
        QFont font = usual;
        font.setPointSizeF(usual.pointSizeF() * (chip.is_loud ? kLoud : 0.9));
        font.setBold(chip.is_loud);
        painter.setFont(font);
        const QFontMetricsF metrics(font);
        const QSizeF size(metrics.horizontalAdvance(chip.text) + 16, metrics.height() + 6);
        if (x > kEdge_px && x + size.width() > widget.width() - kEdge_px) { // another row
            x = kEdge_px;
            bottom -= metrics.height() + 6 + kGap_px;
        }
        const QRectF box(x, bottom - size.height(), size.width(), size.height());
        painter.setPen(Qt::NoPen);
        painter.setBrush(chip.ground.isValid() ? chip.ground : QColor(0, 0, 0, 150));
        painter.drawRoundedRect(box, 4, 4);
        painter.setPen(chip.ground.isValid() ? QColor(15, 15, 15) : QColor(225, 225, 225));
        painter.drawText(box, Qt::AlignCenter, chip.text);
        x += size.width() + kGap_px;
    }
    painter.restore();
}

} // namespace ghost::ui
