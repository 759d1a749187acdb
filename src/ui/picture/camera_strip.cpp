// SPDX-License-Identifier: Apache-2.0
#include "ui/picture/camera_strip.h"

#include "show/show.h"
#include "ui/language/language.h"
#include "ui/widgets/following.h"

#include <QPixmap>
#include <QSignalBlocker>

#include <vector>

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

CameraStrip::CameraStrip(AppModel& app, Actions& actions, QWidget* parent)
    : QListWidget(parent), app_(app), actions_(actions) {
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
    setToolTip(translated("Picture",
                          "A click goes there. F2: another name. The pictures are made while nothing "
                          "moves."));
    setEditTriggers(QAbstractItemView::EditKeyPressed);
    connect(this, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
        if (follows_) return;
        if (item->text() != item->data(Qt::UserRole).toString())
            actions_.choose(QString("camera-rename %1 ").arg(row(item) + 1) + quoted(item->text()));
        // What was refused is not left standing; the list is not filled while it tells of a change.
        QMetaObject::invokeMethod(this, &CameraStrip::list_cameras, Qt::QueuedConnection);
    });
    const auto go = [this](QListWidgetItem* item) {
        actions_.choose(QString("camera %1").arg(row(item) + 1));
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

void CameraStrip::fill_menu(QMenu& menu) {
    if (!currentItem()) return;
    const QString which = QString::number(currentRow() + 1);
    const auto add = [&](const QString& text, const QString& line) {
        connect(menu.addAction(text), &QAction::triggered, this, [this, line] { actions_.choose(line); });
    };
    add(translated("Picture", "Go to this"), "camera " + which);
    menu.addSeparator();
    connect(menu.addAction(translated("Picture", "Rename")), &QAction::triggered, this,
            [this, row = currentRow()] {
                setCurrentRow(row);
                editItem(currentItem());
            });
    add(translated("Picture", "Remove"), "camera-remove " + which);
}

// Where it is the same list, who types a name goes on.
void CameraStrip::list_cameras() {
    const Following following(follows_);
    const std::vector<scene::Camera>& cameras = app_.show()->cameras;
    bool stays = app_.opened().is_edit && count() == static_cast<int>(cameras.size());
    for (int row = 0; stays && row < count(); ++row)
        stays = item(row)->text() == QString::fromStdString(cameras[static_cast<std::size_t>(row)].name);
    if (stays) {
        for (int row = 0; row < count(); ++row) item(row)->setData(Qt::UserRole, item(row)->text());
        mark_current();
        return;
    }
    clear();
    for (const scene::Camera& camera : cameras) {
        auto* item = new QListWidgetItem(empty_icon(), QString::fromStdString(camera.name), this);
        item->setData(Qt::UserRole, item->text());
        item->setFlags(item->flags() | Qt::ItemIsEditable);
        item->setSizeHint({kPicture_px.width() + 6, kPicture_px.height() + fontMetrics().height() + 8});
    }
    show_pictures();
    mark_current();
}

void CameraStrip::show_pictures() {
    const Following following(follows_);
    const QSignalBlocker quiet(model()); // a field that is open over one would have its old name again
    for (const NamedPicture& one : app_.camera_pictures())
        for (QListWidgetItem* const item :
             findItems(QString::fromStdString(one.name), Qt::MatchExactly | Qt::MatchCaseSensitive))
            item->setIcon(icon_of(*one.image));
    viewport()->update();
}

void CameraStrip::mark_current() {
    if (state() == EditingState) return; // it would end there
    const std::optional<std::size_t> camera = app_.stored_camera();
    const int at = camera ? static_cast<int>(*camera) : -1;
    if (at != currentRow()) setCurrentRow(at);
}

} // namespace ghost::ui
