// SPDX-License-Identifier: Apache-2.0
#include "ui/actions/exporter.h"

#include "disk/files.h"
#include "show/camera_moves.h"
#include "show/looks.h"
#include "show/show.h"
#include "ui/language/language.h"
#include "ui/model/look_fade.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <filesystem>

namespace ghost::ui {
namespace {

const char* const kLookName = "window";
const char* const kLookFile = "window-look.toml";
constexpr int kHashLetters = 16;

// Without an exponent, which a command line takes for an option.
QString metres(float value) {
    return QString::number(static_cast<double>(value), 'f', 4);
}

std::string hash_of(const std::string& text) {
    return QCryptographicHash::hash(QByteArray::fromStdString(text), QCryptographicHash::Sha256)
        .toHex()
        .left(kHashLetters)
        .toStdString();
}

// Added to the words of a command and to the title of its job.
void give_to_farm(const QString& farm, QStringList& words, QString& title) {
    if (farm.isEmpty()) return;
    words << "--farm" << farm;
    title = translated("Jobs", "%1 on the farm").arg(title);
}

Result<void> check_file(const QString& file, const QStringList& endings) {
    const QFileInfo info(file);
    if (file.isEmpty()) return Error{"it needs the name of a file", ""};
    if (!endings.contains(info.suffix().toLower()))
        return Error{"the name must end in ." + endings.join(" or .").toStdString(), file.toStdString()};
    if (!info.absoluteDir().exists()) return Error{"no such folder", info.absoluteDir().path().toStdString()};
    return {};
}

} // namespace

bool is_on_farm(const Job& job) {
    return job.arguments.contains("--farm");
}

Exporter::Exporter(AppModel& app, ShowDocument& document) : app_(app), document_(document) {
    // Looks that were written for a job go with it; a farm's tasks may still read theirs.
    connect(&app_.jobs(), &Jobs::ended, this, [](const Job& job) {
        if (is_on_farm(job)) return;
        const auto at = job.arguments.indexOf("--looks");
        if (at >= 0 && at + 1 < job.arguments.size()) QFile::remove(job.arguments[at + 1]);
    });
}

Result<void> Exporter::check_saved() const {
    if (!app_.show()) return Error{"no show is open", ""};
    if (document_.is_changed() || document_.has_draft())
        return Error{"save the show first (Ctrl+S): what runs in the background reads its file",
                     app_.show()->file.string()};
    return {};
}

Result<QString> Exporter::show_file() const {
    TRY_VOID(check_saved());
    return QFileInfo(QString::fromStdString(app_.show()->file.string())).absoluteFilePath();
}

QStringList Exporter::tone_arguments() const {
    return {"--tone", QString::fromStdString(image::name_of(app_.request().tone))};
}

// A picture of another shape shows all that the window's frame holds, as the window itself does.
QStringList Exporter::eye_arguments(int width, int height) const {
    scene::Camera camera = app_.seen_camera();
    const glm::ivec2 frame(camera.width, camera.height);
    camera.width = width;
    camera.height = height;
    camera = scene::with_frame(camera, frame);
    // What was measured is of the picture, and that may be of the moment before a jump.
    const bool is_measured = camera.auto_exposure && app_.has_jumped();
    const float ev100 = is_measured ? app_.picture().ev100 : camera.ev100;
    QStringList words{"--eye"};
    for (int axis = 0; axis < 3; ++axis) words << metres(camera.position_m[axis]);
    words << "--target";
    for (int axis = 0; axis < 3; ++axis) words << metres(camera.target_m[axis]);
    words << "--fov" << metres(camera.fov_y_deg);
    if (camera.auto_exposure && !is_measured)
        words << "--auto-exposure";
    else
        words << "--ev" << metres(ev100);
    return words;
}

Result<QStringList> Exporter::look_arguments(bool for_farm) {
    Look look = app_.look();
    leave_solo(look, app_.show()->fixtures.size());
    scene::StoredLook stored;
    stored.name = kLookName;
    stored.scene = look.scene;
    for (const auto& [index, programmer] : look.fixtures)
        if (index < app_.show()->fixtures.size())
            stored.fixtures[app_.show()->fixtures[index].name] = programmer;
    for (const auto& [index, values] : look.movers)
        if (index < app_.show()->movers.size()) stored.movers[app_.show()->movers[index].name] = values;
    if (stored.fixtures.empty() && stored.movers.empty() && stored.scene == SceneLook{}) return QStringList{};
    const std::string text = scene::text_of({stored});
    const std::filesystem::path folder =
        for_farm ? app_.show()->cache_folder() / "farm" : app_.show()->cache_folder();
    TRY_VOID(make_folders(folder, app_.show()->cache_home()));
    // One for each job. For a farm the same look is the same file, and so the same plan.
    const std::filesystem::path file =
        for_farm ? folder / ("look-" + hash_of(text) + ".toml") : temporary_beside(folder / kLookFile);
    if (std::error_code code; !for_farm || !std::filesystem::exists(file, code))
        TRY_VOID(scene::write_looks(file, text));
    return QStringList{"--looks", QFileInfo(QString::fromStdString(file.string())).absoluteFilePath(),
                       "--look", kLookName};
}

Result<int> Exporter::bake(const BakeRequest& request) {
    TRY(const QString show, show_file());
    QStringList words{
        "bake", show, "--spp", QString::number(request.spp), "--bounces", QString::number(request.bounces)};
    if (!request.camera.isEmpty()) {
        TRY_VOID(app_.show()->find_camera(request.camera.toStdString()));
        words << "--view" << request.camera;
    }
    QString title = request.camera.isEmpty() ? translated("Jobs", "Bake all cameras")
                                             : translated("Jobs", "Bake %1").arg(request.camera);
    give_to_farm(request.farm, words, title);
    return app_.jobs().start(title, words);
}

Result<int> Exporter::render(const PictureRequest& request) {
    const bool is_film = request.from_s >= 0;
    TRY_VOID(
        check_file(request.file, is_film ? QStringList{"mp4", "png", "exr"} : QStringList{"png", "exr"}));
    TRY(const QString show, show_file());
    QStringList words{"render", show, "-o", QFileInfo(request.file).absoluteFilePath()};
    if (request.camera.isEmpty()) {
        words += eye_arguments(request.width, request.height);
        words << "--size" << QString("%1x%2").arg(request.width).arg(request.height) << "--supersample"
              << QString::number(request.supersample);
    } else {
        TRY_VOID(app_.show()->find_camera(request.camera.toStdString()));
        words << "--view" << request.camera;
    }
    words += tone_arguments();
    const std::string& played = app_.request().recording;
    const bool plays = !app_.show()->recording.empty() || !played.empty();
    if (!played.empty()) words << "--replay" << QString::fromStdString(played);
    if (is_film) {
        if (!plays) return Error{"a film shows the recording of the show, and it has none", ""};
        if (request.to_s <= request.from_s) return Error{"the film must end after it begins", ""};
        words << "--from" << QString::number(request.from_s) << "--to" << QString::number(request.to_s)
              << "--fps" << QString::number(request.fps);
    } else if (plays) {
        words << "--at" << QString::number(app_.moment_s());
    }
    TRY(const QStringList look, look_arguments(!request.farm.isEmpty()));
    if (!plays && look.isEmpty())
        return Error{"nothing lights the picture: the show has no recording and nothing is set by hand; "
                     "'save-picture' saves what a desk does now",
                     ""};
    words += look;
    QString title = (is_film ? translated("Jobs", "Film %1") : translated("Jobs", "Still %1"))
                        .arg(QFileInfo(request.file).fileName());
    give_to_farm(request.farm, words, title);
    return app_.jobs().start(title, words);
}

Result<int> Exporter::sheet(const QString& file, int width, int height) {
    TRY_VOID(check_file(file, {"png"}));
    TRY(const QString show, show_file());
    QStringList words{"sheet",  show,
                      "-o",     QFileInfo(file).absoluteFilePath(),
                      "--size", QString("%1x%2").arg(width).arg(height)};
    // What looks leave alone does what the window's recording does now.
    const bool plays = !app_.show()->recording.empty() && !app_.rig().from_desk;
    if (plays && app_.request().recording.empty()) words << "--at" << QString::number(app_.moment_s());
    words += tone_arguments();
    return app_.jobs().start(translated("Jobs", "Contact sheet %1").arg(QFileInfo(file).fileName()), words);
}

Result<int> Exporter::print(const QString& command, const QString& folder, const QStringList& options) {
    if (folder.isEmpty()) return Error{"it needs the name of a folder", ""};
    const QString absolute = QFileInfo(folder).absoluteFilePath();
    if (!QFileInfo(absolute).absoluteDir().exists())
        return Error{"no such folder", QFileInfo(absolute).absolutePath().toStdString()};
    TRY(const QString show, show_file());
    const QString title =
        (command == "book" ? translated("Jobs", "Cue book %1") : translated("Jobs", "Paperwork %1"))
            .arg(QFileInfo(absolute).fileName());
    return app_.jobs().start(title, QStringList{command, show, "-o", absolute} + options);
}

} // namespace ghost::ui
