// SPDX-License-Identifier: Apache-2.0
#include "ui/actions/script.h"
#include "show/show.h"

#include <QDir>
#include <QFileInfo>
#include <QLocalSocket>
#include <QPointer>

#include <filesystem>
#include <system_error>

namespace ghost::ui {
namespace {

constexpr int kPoll_ms = 15;
constexpr double kLongestWait_s = 900; // for something that may never come
constexpr double kPatience_s = 0.3;    // a window that was resized tells the engine after a moment
constexpr qint64 kLongestLine = 65536;
constexpr int kLongestSocket = 107; // bytes of its path, as Linux has it
constexpr int kAnswers_ms = 300;

// Empty: it can. Asked before Qt makes one, which takes the place of whatever has that name, be it somebody's
// file or the socket of another window. What a killed window left behind answers nobody.
std::string why_no_socket(const QString& place) {
    const QFileInfo folder(QFileInfo(place).path());
    const auto bytes = place.toUtf8().size();
    if (bytes > kLongestSocket)
        return "its path has " + std::to_string(bytes) + " bytes, expected at most " +
               std::to_string(kLongestSocket);
    if (!folder.isDir()) return "there is no folder " + folder.filePath().toStdString();
    if (!folder.isWritable()) return "nothing can be written into " + folder.filePath().toStdString();
    std::error_code code;
    const std::filesystem::file_status there = std::filesystem::status(place.toStdString(), code);
    if (!std::filesystem::exists(there)) return "";
    if (!std::filesystem::is_socket(there)) return "a file has that name";
    QLocalSocket asks;
    asks.connectToServer(place);
    return asks.waitForConnected(kAnswers_ms) ? "another window listens there, expected another name" : "";
}

} // namespace

Script::Script(Actions& actions, AppModel& app, QObject* parent)
    : QObject(parent), actions_(actions), app_(app) {
    timer_.setInterval(kPoll_ms);
    connect(&timer_, &QTimer::timeout, this, &Script::step);
}

void Script::add(const QString& line) {
    lines_.push_back(line.trimmed());
    if (!timer_.isActive()) timer_.start();
}

void Script::step() {
    while (!lines_.empty() && !runs_) {
        const QString line = lines_.front();
        if (line.startsWith("wait ")) {
            if (!waits_) waited_.start();
            waits_ = true;
            const auto words = split_line(line);
            const Result<bool> over = words.ok() ? is_over(*words) : Result<bool>(words.error());
            if (over.ok() && !*over) return;
            waits_ = false;
            lines_.pop_front();
            if (on_line) on_line(over.ok() ? Result<void>() : Result<void>(over.error()));
            continue;
        }
        lines_.pop_front();
        if (line.isEmpty() || line.startsWith('#')) {
            if (on_line) on_line({});
            continue;
        }
        runs_ = true;
        const QPointer<Script> self(this); // who sent it may hang up while it is done
        const Result<void> done = actions_.run(line);
        if (!self) return;
        runs_ = false;
        if (on_line) on_line(done);
    }
    if (lines_.empty()) timer_.stop();
}

Result<bool> Script::is_over(const QStringList& words) {
    const QString what = words.size() == 2 ? words[1] : QString();
    const double waited_s = static_cast<double>(waited_.elapsed()) * 1e-3;
    if (what == "settled" && waited_s < kPatience_s) return false;
    if (what == "opened" && app_.open_error())
        return Error{"the show is not open: " + app_.open_error()->text(), "wait opened"};
    if (what == "opened" && !app_.show() && app_.request().show.empty())
        return Error{"no show is being opened", "wait opened"};
    if (what == "opened" || what == "settled") {
        const bool is_open = app_.show() && !app_.is_opening();
        if (what == "opened" ? is_open : app_.is_settled()) return true;
        if (waited_s < kLongestWait_s) return false;
        return Error{"a quarter of an hour went by without it", "wait " + what.toStdString()};
    }
    if (what == "picture") {
        if (app_.picture().image && !app_.is_opening()) return true;
        if (waited_s < kLongestWait_s) return false;
        return Error{"a quarter of an hour went by without it", "wait picture"};
    }
    if (what == "jobs") return !app_.jobs().is_busy();
    if (what == "saved") {
        if (app_.saved() == app_.request().save_frame.number) return true;
        if (waited_s < kLongestWait_s) return false;
        return Error{"a quarter of an hour went by without it", "wait saved"};
    }
    TRY(const double wanted_s,
        number_of(words, 1, "number of seconds, 'opened', 'picture', 'settled', 'saved' or 'jobs'", 0, 3600));
    return waited_s >= wanted_s;
}

RemoteControl::RemoteControl(Actions& actions, AppModel& app, QObject* parent)
    : QObject(parent), actions_(actions), app_(app) {
    connect(&server_, &QLocalServer::newConnection, this, &RemoteControl::accept);
}

Result<void> RemoteControl::listen(const QString& name) {
    server_.setSocketOptions(QLocalServer::UserAccessOption);
    // A name without a folder is one among the temporary files.
    const QString place = QDir::isAbsolutePath(name) ? name : QDir::tempPath() + "/" + name;
    if (QFileInfo(place).isDir())
        return Error{"is a folder; expected the name of a socket that is made there, like " +
                         name.toStdString() + "/window",
                     place.toStdString()};
    const std::string cannot = "no socket can be made there: ";
    if (const std::string why = why_no_socket(place); !why.empty())
        return Error{cannot + why, place.toStdString()};
    if (server_.listen(name)) return {};
    return Error{cannot + server_.errorString().toStdString(), place.toStdString()};
}

void RemoteControl::accept() {
    while (QLocalSocket* socket = server_.nextPendingConnection()) {
        auto* script = new Script(actions_, app_, socket);
        script->on_line = [socket](const Result<void>& done) {
            const std::string answer = done.ok() ? "ok\n" : "error: " + done.error().text() + "\n";
            socket->write(answer.data(), static_cast<qint64>(answer.size()));
        };
        connect(socket, &QLocalSocket::disconnected, socket, &QObject::deleteLater);
        connect(socket, &QLocalSocket::readyRead, script, [socket, script] {
            while (socket->canReadLine()) script->add(QString::fromUtf8(socket->readLine(kLongestLine)));
            if (socket->bytesAvailable() > kLongestLine) socket->abort(); // no line is that long
        });
    }
}

} // namespace ghost::ui
