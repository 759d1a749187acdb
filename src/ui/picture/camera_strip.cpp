// SPDX-License-Identifier: Apache-2.0
#include "ui/picture/camera_strip.h"

#include "show/show.h"
#include "ui/language/language.h"

#include <QPixmap>

namespace ghost::ui {
namespace {

constexpr QSize kPicture_px(112, 63);

QIcon icon_of(const QPixmap& pixmap) {
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected); // not tinted
    return icon;
}

QIcon empty_icon() {
    QPixmap pixmap(kPicture_px);
    pixmap.fill(QColor(20, 20, 22));
    return icon_of(pixmap);
}

QIcon icon_of(const image::Image8& picture) {
    const QImage image(picture.samples.data(), picture.width, picture.height, 4 * picture.width,
                       QImage::Format_RGBX8888);
    return icon_of(QPixmap::fromImage(
        image.scaled(kPicture_px, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation)));
}

} // namespace

CameraStrip::CameraStrip(AppModel& app, Actions& actions, QWidget* parent) : QListWidget(parent), app_(app) {
    setAccessibleName(translated("Picture", "Cameras"));
    setViewMode(QListView::IconMode);
    setFlow(QListView::LeftToRight);
    setWrapping(false);
    setMovement(QListView::Static);
    setIconSize(kPicture_px);
    setSpacing(3);
    setUniformItemSizes(true);
    setFrameShape(QFrame::NoFrame);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setTextElideMode(Qt::ElideRight);
    setFixedHeight(kPicture_px.height() + fontMetrics().height() + 18);
    setToolTip(translated("Picture", "A click goes there. The pictures are made while nothing moves."));
    const auto go = [this, &actions](QListWidgetItem* item) {
        actions.choose(QString("camera %1").arg(row(item) + 1));
    };
    for (const auto signal : {&QListWidget::itemClicked, &QListWidget::itemActivated})
        connect(this, signal, this, go);
    connect(&app_, &AppModel::opened_show, this, &CameraStrip::list_cameras);
    connect(&app_, &AppModel::camera_pictures_came, this, &CameraStrip::show_pictures);
    connect(&app_, &AppModel::request_changed, this, &CameraStrip::mark_current);
}

void CameraStrip::showEvent(QShowEvent* event) {
    QListWidget::showEvent(event);
    app_.change_request([](ViewRequest& request) { request.wants_camera_pictures = true; });
}

void CameraStrip::hideEvent(QHideEvent* event) {
    QListWidget::hideEvent(event);
    app_.change_request([](ViewRequest& request) { request.wants_camera_pictures = false; });
}

void CameraStrip::list_cameras() {
    clear();
    for (const scene::Camera& camera : app_.show()->cameras) {
        auto* item = new QListWidgetItem(empty_icon(), QString::fromStdString(camera.name), this);
        item->setSizeHint({kPicture_px.width() + 6, kPicture_px.height() + fontMetrics().height() + 8});
    }
    show_pictures();
    mark_current();
}

void CameraStrip::show_pictures() {
    for (const NamedPicture& one : app_.camera_pictures())
        for (QListWidgetItem* const item :
             findItems(QString::fromStdString(one.name), Qt::MatchExactly | Qt::MatchCaseSensitive))
            item->setIcon(icon_of(*one.image));
}

void CameraStrip::mark_current() {
    const std::optional<std::size_t> camera = app_.stored_camera();
    const int at = camera ? static_cast<int>(*camera) : -1;
    if (at != currentRow()) setCurrentRow(at);
}

} // namespace ghost::ui
