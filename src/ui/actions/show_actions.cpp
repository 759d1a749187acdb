// SPDX-License-Identifier: Apache-2.0
#include "ui/actions/show_actions.h"

#include "disk/files.h"
#include "show/show.h"
#include "show_file/show_edit.h"
#include "ui/language/language.h"

#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QMessageBox>
#include <QUrl>

namespace ghost::ui {
namespace {

namespace fs = std::filesystem;

// A floor of 40 m and a deck of 14 by 8 m, 1 m high, so that a new show has something to be lit.
const char* const kStage = R"(# A floor and a deck. Metres, Z up-stage is -Z here: glTF and OBJ have Y up.
o floor
v -20 0 20
v 20 0 20
v 20 0 -20
v -20 0 -20
vn 0 1 0
f 1//1 2//1 3//1 4//1
o deck
v -7 1 0
v 7 1 0
v 7 1 -8
v -7 1 -8
v -7 0 0
v 7 0 0
v 7 0 -8
v -7 0 -8
vn 0 0 1
vn 1 0 0
vn 0 0 -1
vn -1 0 0
f 5//1 6//1 7//1 8//1
f 9//2 10//2 6//2 5//2
f 10//3 11//3 7//3 6//3
f 11//4 12//4 8//4 7//4
f 12//5 9//5 5//5 8//5
)";

const char* const kShow = R"(# docs/reference/show-file.md says what each key means.

[show]
stage = "stage.obj"
ambient_lux = 1.5

[[camera]]
name = "house"
position_m = [0, -18, 3]
target_m = [0, 2, 3]
fov_y_deg = 40
)";

Result<void> make_show(AppModel& app, const QString& folder) {
    const fs::path path = folder.toStdString();
    std::error_code code;
    if (fs::exists(path, code) && !(fs::is_directory(path, code) && fs::is_empty(path, code)))
        return Error{"is there already; a new show needs a name of its own", path.string()};
    fs::create_directories(path, code);
    if (code) return Error{"cannot be made: " + code.message(), path.string()};
    TRY_VOID(write_file_atomic(path / "stage.obj", kStage));
    TRY(const std::string text, scene::set_of_show(kShow, "name", path.filename().string()));
    TRY_VOID(write_file_atomic(path / "show.toml", text));
    app.open(path.string());
    return {};
}

// What a show names lies beside it, so it can only go on beside the file that is open. was_asked: a person
// was, whether the file of that name is to go.
Result<void> save_as(AppModel& app, ShowDocument& document, const QStringList& words, bool was_asked) {
    if (!app.show()) return Error{"no show is open", ""};
    fs::path file = words[0].toStdString();
    const bool over = words.value(1) == "over" || (was_asked && file.extension() == ".toml");
    if (file.extension() != ".toml") file += ".toml";
    if (file.is_relative()) file = app.show()->folder / file;
    std::error_code code;
    if (!fs::equivalent(file.parent_path(), app.show()->folder, code))
        return Error{"what a show names lies beside it, so under another name it stays in " +
                         app.show()->folder.string() +
                         "; a copy of the file alone: Save a copy of the show file",
                     file.string()};
    if (!over && fs::exists(file, code) && !fs::equivalent(file, app.show()->file, code))
        return Error{"is there already: another name, or over it (in a script: save-as FILE over)",
                     file.string()};
    TRY_VOID(document.save_as(file));
    app.open_copy(file.string());
    return {};
}

void about(QWidget& window, const AppModel& app) {
    const QString device = app.opened().device.empty() ? translated("Window", "nothing yet")
                                                       : QString::fromStdString(app.opened().device);
    auto* box = new QMessageBox(
        QMessageBox::NoIcon, translated("Action", "About Ghostlight"),
        "<h3>Ghostlight " GHOST_VERSION "</h3><p>" +
            translated("Window", "See your light show before the truck is unloaded.") + "</p><p>" +
            translated("Window", "Drawn on: %1").arg(device.toHtmlEscaped()) + "</p><p>Qt " + qVersion() +
            "</p><p>" +
            translated("Window", "Apache License 2.0. VARI*LITE and VL2500 are marks of their owners, who "
                                 "have no part in this.") +
            "</p>",
        QMessageBox::Close, &window);
    box->setTextFormat(Qt::RichText);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setModal(false);
    box->show();
}

} // namespace

QString folder_for_plot(const QString& plot) {
    const QFileInfo file(plot);
    return file.absolutePath() + "/" + file.completeBaseName();
}

Result<void> import_plot(AppModel& app, ShowDocument& document, const QString& plot) {
    if (!QFileInfo(plot).isFile()) return Error{"no such file", plot.toStdString()};
    if (QFileInfo(plot).suffix().toLower() != "mvr")
        return Error{"is no .mvr, as Vectorworks, Capture, grandMA3 and Production Assist export it",
                     plot.toStdString()};
    const QString folder = folder_for_plot(plot);
    const int number = app.jobs().start(translated("Jobs", "import %1").arg(QFileInfo(plot).fileName()),
                                        {"import", plot, "-o", folder});
    auto* const waits = new QObject(&app);
    QObject::connect(&app.jobs(), &Jobs::ended, waits,
                     [&app, &document, waits, number, plot, folder](const Job& job) {
                         if (job.number != number) return;
                         waits->deleteLater();
                         if (job.state != Job::State::done) return;
                         std::error_code code;
                         const scene::Show* const seen = app.show().get();
                         const bool is_plot = seen && seen->file == seen->plot_file;
                         if (is_plot && fs::equivalent(seen->file, plot.toStdString(), code))
                             app.open_made_of_plot(folder.toStdString());
                         else if (seen && !is_plot && !seen->plot_file.empty() && !app.is_opening() &&
                                  fs::equivalent(seen->folder, folder.toStdString(), code))
                             document.read_again(); // its plot has another version now
                         else
                             app.open(folder.toStdString());
                     });
    return {};
}

void add_show_actions(Actions& actions, AppModel& app, ShowDocument& document, const std::string& docs,
                      QWidget& window) {
    actions.add({"new",
                 "Show",
                 translated("Action", "New show..."),
                 "Ctrl+N",
                 "FOLDER",
                 [&app](const QStringList& words) { return make_show(app, words[0]); },
                 {},
                 {translated("Files", "A new show: its folder"), translated("Files", "Folders (*)"),
                  "My show", Begins::beside_show}});
    actions.add({"import-plot",
                 "Show",
                 translated("Action", "Import a plot..."),
                 "Ctrl+I",
                 "FILE.mvr",
                 [&app, &document](const QStringList& words) { return import_plot(app, document, words[0]); },
                 {},
                 {translated("Files", "A plot becomes a show"), translated("Files", "Plots (*.mvr)"), ""}});
    actions.add({"save-as",
                 "Show",
                 translated("Action", "Save as..."),
                 "",
                 "FILE [over]",
                 [&actions, &app, &document](const QStringList& words) {
                     return save_as(app, document, words, actions.is_by_hand());
                 },
                 {},
                 {translated("Files", "Save the show under another name beside it"),
                  translated("Files", "Show files (*.toml)"), "show-2.toml", Begins::with_show}});
    actions.add({"documentation",
                 "Help",
                 translated("Action", "Documentation"),
                 "",
                 "",
                 [docs](const QStringList&) -> Result<void> {
                     if (docs.empty()) return Error{"the guide is not installed beside this program", ""};
                     if (QDesktopServices::openUrl(QUrl::fromLocalFile(QString::fromStdString(docs))))
                         return {};
                     return Error{"no program was found that opens it", docs};
                 },
                 {}});
    actions.add({"about",
                 "Help",
                 translated("Action", "About Ghostlight"),
                 "",
                 "",
                 [&window, &app](const QStringList&) -> Result<void> {
                     about(window, app);
                     return {};
                 },
                 {}});
}

} // namespace ghost::ui
