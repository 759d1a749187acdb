// SPDX-License-Identifier: Apache-2.0
#include "ui/actions/export_actions.h"
#include "show/show.h"
#include "ui/language/language.h"

#include <QRegularExpression>

namespace ghost::ui {
namespace {

using Run = std::function<Result<void>(const QStringList& words)>;

constexpr int kLeastPixels = 16, kMostPixels = 8192;
constexpr double kLongest_s = 1e7;

// The last word, where it names a farm: it is taken away.
QString farm_of(QStringList& words) {
    static const QStringList kFarms{"slurm", "local"};
    return !words.isEmpty() && kFarms.contains(words.last()) ? words.takeLast() : QString();
}

Result<void> bake(Exporter& exporter, QStringList words) {
    BakeRequest request;
    request.farm = farm_of(words);
    request.camera = words.value(0) == "all" ? QString() : words.value(0);
    if (words.size() > 1) {
        TRY(const double spp, number_of(words, 1, "number of samples per pixel", 1, 1024));
        request.spp = static_cast<int>(spp);
    }
    if (words.size() > 2) {
        TRY(const double bounces, number_of(words, 2, "number of bounces", 0, 16));
        request.bounces = static_cast<int>(bounces);
    }
    TRY_VOID(exporter.bake(request));
    return {};
}

Result<void> take_size_or_camera(const AppModel& app, const QString& words, PictureRequest& request) {
    TRY_VOID(check_picture_of(app, words));
    if (const Result<QSize> size = size_of(words); size.ok()) {
        request.width = size->width();
        request.height = size->height();
    } else {
        request.camera = words;
    }
    return {};
}

Result<void> still(const AppModel& app, Exporter& exporter, const QStringList& words) {
    PictureRequest request;
    request.file = words.value(0);
    if (words.size() > 1) TRY_VOID(take_size_or_camera(app, words[1], request));
    TRY_VOID(exporter.render(request));
    return {};
}

Result<void> film(const AppModel& app, Exporter& exporter, QStringList words) {
    PictureRequest request;
    request.farm = farm_of(words);
    request.file = words.value(0);
    TRY(request.from_s, number_of(words, 1, "first second", 0, kLongest_s));
    TRY(request.to_s, number_of(words, 2, "last second", 0, kLongest_s));
    if (words.size() > 3) {
        TRY(const double fps, number_of(words, 3, "number of pictures a second", 1, 240));
        request.fps = static_cast<int>(fps);
    }
    if (words.size() > 4) TRY_VOID(take_size_or_camera(app, words[4], request));
    TRY_VOID(exporter.render(request));
    return {};
}

} // namespace

Result<QSize> size_of(const QString& words) {
    const QStringList parts = words.split('x');
    bool has_width = false, has_height = false;
    const int width = parts.value(0).toInt(&has_width), height = parts.value(1).toInt(&has_height);
    if (parts.size() == 2 && has_width && has_height && width >= kLeastPixels && height >= kLeastPixels &&
        width <= kMostPixels && height <= kMostPixels)
        return QSize(width, height);
    return Error{"'" + words.toStdString() + "' is no size like 1920x1080, 16 to 8192 each way", ""};
}

Result<void> check_picture_of(const AppModel& app, const QString& words) {
    const Result<QSize> size = size_of(words);
    if (size.ok()) return {};
    static const QRegularExpression kLikeASize("^\\d+x");
    if (kLikeASize.match(words).hasMatch()) return size.error();
    if (!app.show() || app.show()->find_camera(words.toStdString()).ok()) return {};
    return Error{"'" + words.toStdString() +
                     "' is neither a size like 1920x1080, 16 to 8192 each way, nor a camera of the show",
                 ""};
}

void add_export_actions(Actions& actions, AppModel& app, Exporter& exporter) {
    const auto add = [&](const QString& name, const QString& arguments, const Run& run) {
        actions.add({name, "", name, "", arguments, run, {}});
    };
    add("bake", "[CAMERA|all] [SAMPLES] [BOUNCES] [slurm|local]",
        [&exporter](const QStringList& words) { return bake(exporter, words); });
    add("export-still", "FILE [WxH|CAMERA]",
        [&app, &exporter](const QStringList& words) { return still(app, exporter, words); });
    add("export-film", "FILE FROM TO [FPS] [WxH|CAMERA] [slurm|local]",
        [&app, &exporter](const QStringList& words) { return film(app, exporter, words); });
    add("export-sheet", "FILE [WxH]", [&exporter](const QStringList& words) -> Result<void> {
        TRY(const QSize size, size_of(words.value(1, "480x270")));
        TRY_VOID(exporter.sheet(words.value(0), size.width(), size.height()));
        return {};
    });
    for (const QString command : {"paper", "book"})
        add("export-" + command, "FOLDER [OPTIONS of ghostlight " + command + "]",
            [&exporter, command](const QStringList& words) -> Result<void> {
                TRY_VOID(exporter.print(command, words.value(0), words.mid(1)));
                return {};
            });
    actions.add({"cancel-jobs",
                 "Show",
                 translated("Action", "Cancel what runs in the background"),
                 "",
                 "",
                 [&app](const QStringList&) -> Result<void> {
                     if (!app.jobs().is_busy()) return Error{"nothing runs in the background", ""};
                     app.jobs().cancel_all();
                     return {};
                 },
                 {}});
}

} // namespace ghost::ui
