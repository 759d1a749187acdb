// SPDX-License-Identifier: Apache-2.0
#include "ui/window/recent_shows.h"
#include "show/show.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QImage>
#include <QSaveFile>
#include <QSettings>
#include <QStandardPaths>

#include <algorithm>
#include <set>
#include <utility>

namespace ghost::ui {
namespace {

constexpr int kWidth_px = 320, kHeight_px = 180;

QString picture_of(const QString& path) {
    const QByteArray name = QCryptographicHash::hash(path.toUtf8(), QCryptographicHash::Sha1).toHex();
    return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/shows/" + name + ".png";
}

} // namespace

bool RecentShows::exists(const std::filesystem::path& file) {
    std::error_code code;
    return std::filesystem::exists(file, code);
}

RecentShows::RecentShows(AppModel& app, bool remembers, const IsThere& is_there)
    : app_(app), remembers_(remembers) {
    if (!remembers_) return;
    QSettings settings;
    const int count = std::min(settings.beginReadArray("recent shows"), kMost);
    std::vector<std::filesystem::path> files;
    for (int i = 0; i < count; ++i) {
        settings.setArrayIndex(i);
        const QString path = settings.value("path").toString();
        shows_.push_back({path, settings.value("name").toString(), picture_of(path)});
        files.emplace_back(path.toStdString());
    }
    disk_.ask([this, files = std::move(files), is_there]() -> DiskLook::Then {
        std::set<QString> gone;
        for (const std::filesystem::path& file : files)
            if (!is_there(file)) gone.insert(QString::fromStdString(file.string()));
        return [this, gone = std::move(gone)] {
            const auto is_gone = [&](const One& one) { return gone.contains(one.path); };
            if (std::erase_if(shows_, is_gone) > 0) Q_EMIT changed();
        };
    });
    connect(&app_, &AppModel::opened_show, this, &RecentShows::take_opened);
    connect(&app_, &AppModel::picture_came, this, [this] { has_picture_ = true; });
}

RecentShows::~RecentShows() {
    keep_picture();
}

void RecentShows::take_opened() {
    if (app_.opened().is_edit) return;
    keep_picture(); // of the one before, which the model still has
    has_picture_ = false;
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

void RecentShows::keep_picture() {
    const auto image = app_.picture().image;
    if (!remembers_ || !has_picture_ || open_.isEmpty() || !image || image->channels != 4 ||
        image->width <= 0)
        return;
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
