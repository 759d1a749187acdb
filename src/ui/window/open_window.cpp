// SPDX-License-Identifier: Apache-2.0
#include "ui/window/open_window.h"

#include "base/log.h"
#include "base/memory.h"
#include "disk/files.h"
#include "show/show.h"
#include "ui/actions/script.h"
#include "ui/language/language.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/whole_paint.h"
#include "ui/window/window.h"

#include <QApplication>
#include <QLocale>
#include <QSettings>
#include <QTimer>

#include <clocale>
#include <cstdlib>
#include <utility>

namespace ghost::ui {
namespace {

constexpr int kAsk_ms = 100;
constexpr std::uintmax_t kMostScriptBytes = 1 << 20;

bool is_set(const char* name) {
    const char* const value = std::getenv(name);
    return value && *value;
}

// Qt ends the program where it finds no display; it shall say what to do first.
void take_message(QtMsgType type, const QMessageLogContext&, const QString& text) {
    if (type == QtFatalMsg) {
        log_error(text.toStdString());
        if (is_set("WAYLAND_DISPLAY") && !is_set("DISPLAY"))
            log_error(
                "this display speaks Wayland alone, and Qt's part for it is not here or does not serve: "
                "install it (on Debian qt6-wayland; the bundle cannot use it), or let "
                "Xwayland run");
        log_error("the window needs a display (DISPLAY or WAYLAND_DISPLAY); without one, 'ghostlight render' "
                  "writes pictures and films");
        std::_Exit(1);
    }
    // Qt says so and ends the program, on X11 and on Wayland, by exit(), whose destructors take away what
    // other threads draw with. The draft is on disk by then.
    if (type == QtWarningMsg && text.contains("connection broke")) {
        log_error("the display is gone: " + text.toStdString() +
                  " The window ends; changes that were not saved are offered when the show is opened again");
        std::_Exit(1);
    }
    if (type == QtCriticalMsg)
        log_error(text.toStdString());
    else
        log_debug(text.toStdString());
}

QString language_for(const WindowOptions& options) {
    const QString kept = options.remembers ? QSettings().value("language").toString() : QString();
    for (const QString& code : {QString::fromStdString(options.language), kept})
        for (const LanguageChoice& one : kLanguages)
            if (code == one.code) return code;
    return language_of_system();
}

// A script's lines in their order; the first that fails ends it, and the window.
Result<void> run_script(const std::string& file, Window& window, Result<void>& outcome) {
    TRY(const std::string text, read_text_file(file, kMostScriptBytes));
    auto* script = new Script(window.actions(), window.app(), &window);
    auto line = std::make_shared<int>(0);
    script->on_line = [file, line, script, &window, &outcome](const Result<void>& done) {
        ++*line;
        if (done.ok() || !outcome.ok()) return;
        outcome = Error{done.error().text(), file + ":" + std::to_string(*line)};
        script->stop();
        window.close();
    };
    for (const QString& one : QString::fromStdString(text).split('\n')) script->add(one);
    return {};
}

} // namespace

bool has_display() {
#if defined(__linux__)
    for (const char* const name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        if (is_set(name)) return true;
    return false;
#else
    return true;
#endif
}

Result<void> open_window(Link& link, const WindowOptions& options) {
    if (!options.draws_into_memory && !has_display())
        return Error{"there is no display (DISPLAY and WAYLAND_DISPLAY are empty): the window needs one; "
                     "'ghostlight render' writes pictures and films without",
                     ""};
    return_large_blocks(); // each size of the picture has memory of its own
    qInstallMessageHandler(take_message);
    char name[] = "ghostlight", platform[] = "-platform", memory[] = "offscreen";
    char* argv[] = {name, platform, memory, nullptr};
    int argc = options.draws_into_memory ? 3 : 1;
    if (argc == 1) argv[1] = nullptr;
    QApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C"); // Qt has set the desktop's: files and messages would say "0,5"
    QApplication::setApplicationName("ghostlight");
    QApplication::setOrganizationName("ghostlight");
    set_language(language_for(options));
    QLocale::setDefault(QLocale::c()); // "0.5" in every language, as desks, scripts and files have it
    set_theme(application);
    WholePaint whole_paint;
    application.installEventFilter(&whole_paint);

    Result<void> outcome;
    Window window(link, options);
    RemoteControl remote(window.actions(), window.app(), &window);
    if (!options.socket.empty()) TRY_VOID(remote.listen(QString::fromStdString(options.socket)));
    if (!options.script.empty()) TRY_VOID(run_script(options.script, window, outcome));
    QTimer ask;
    QObject::connect(&ask, &QTimer::timeout, &window, [&] {
        if (!options.should_close || !options.should_close()) return;
        ask.stop();
        if (!window.close())
            log_error(
                "not closed: changes are not saved and can be kept nowhere; interrupt again to lose them");
    });
    ask.start(kAsk_ms);
    const std::shared_ptr<void> engine = options.begin(); // goes before the window does
    if (!options.show.empty()) window.app().open(options.show);
    window.show();
    if (options.full_screen) TRY_VOID(window.actions().run("full-screen"));
    QApplication::exec();
    return outcome;
}

} // namespace ghost::ui
