// SPDX-License-Identifier: Apache-2.0
#include "ui/model/recent_shows.h"
#include "show/show.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QImage>
#include <QSaveFile>
#include <QSettings>
#include <QStandardPaths>

#include <algorithm>
#include <utility>

namespace ghost::ui {
namespace {

constexpr int kWidth_px = 320, kHeight_px = 180;
constexpr int kLookEvery_px = 8;
constexpr std::uint8_t kSeen = 24; // of 255

// Whether there is light in it: a show is left in a black-out more often than not.
bool shows_something(const image::Image8& image) {
    for (int y = 0; y < image.height; y += kLookEvery_px)
        for (int x = 0; x < image.width; x += kLookEvery_px)
            if (const std::uint8_t* const pixel = image.at(x, y);
                std::max({pixel[0], pixel[1], pixel[2]}) >= kSeen)
                return true;
    return false;
}

QString picture_of(const QString& path) {
    const QByteArray name = QCryptographicHash::hash(path.toUtf8(), QCryptographicHash::Sha1).toHex();
    return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/shows/" + name + ".png";
}

} // namespace

RecentShows::RecentShows(AppModel& app, bool remembers) : app_(app), remembers_(remembers) {
    if (!remembers_) return;
    QSettings settings;
    const int count = std::min(settings.beginReadArray("recent shows"), kMost);
    for (int i = 0; i < count; ++i) {
        settings.setArrayIndex(i);
        const QString path = settings.value("path").toString();
        if (QFileInfo::exists(path))
            shows_.push_back({path, settings.value("name").toString(), picture_of(path)});
    }
    connect(&app_, &AppModel::opened_show, this, &RecentShows::take_opened);
    connect(&app_, &AppModel::picture_came, this, &RecentShows::take_picture);
}

RecentShows::~RecentShows() {
    keep_picture();
}

void RecentShows::take_opened() {
    if (app_.opened().is_edit) return;
    keep_picture(); // of the one before
    const scene::Show& show = *app_.show();
    open_ = QFileInfo(QString::fromStdString(show.file.string())).absoluteFilePath();
    std::erase_if(shows_, [this](const One& one) { return one.path == open_; });
    shows_.insert(shows_.begin(), {open_, QString::fromStdString(show.name), picture_of(open_)});
    if (shows_.size() > kMost) shows_.resize(kMost);
    QSettings settings;
    settings.beginWriteArray("recent shows", static_cast<int>(shows_.size()));
    for (std::size_t i = 0; i < shows_.size(); ++i) {
        settings.setArrayIndex(static_cast<int>(i));
        settings.setValue("path", shows_[i].path);
        settings.setValue("name", shows_[i].name);
    }
    settings.endArray();
    Q_EMIT changed();
}

void RecentShows::take_picture() {
    const auto& image = app_.picture().image;
    if (image && image->channels == 4 && image->width > 0 && shows_something(*image)) picture_ = image;
}

void RecentShows::keep_picture() {
    const auto image = std::exchange(picture_, nullptr);
    if (!remembers_ || open_.isEmpty() || !image) return;
    const QImage whole(image->samples.data(), image->width, image->height, 4 * image->width,
                       QImage::Format_RGBX8888);
    const QString file = picture_of(open_);
    QDir().mkpath(QFileInfo(file).path());
    // A cache: where it cannot be written there is no picture.
    QSaveFile out(file);
    if (out.open(QIODevice::WriteOnly) &&
        whole.scaled(kWidth_px, kHeight_px, Qt::KeepAspectRatio, Qt::SmoothTransformation)
            .convertToFormat(QImage::Format_RGB888)
            .save(&out, "PNG"))
        out.commit();
}

} // namespace ghost::ui
