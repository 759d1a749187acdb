// SPDX-License-Identifier: Apache-2.0
#include "ui/actions/actions.h"

#include "base/suggest.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

#include <cmath>
#include <utility>

namespace ghost::ui {

void Actions::add(Action action) {
    auto* item = new QAction(action.text, &window_);
    QList<QKeySequence> keys;
    for (const QString& key : action.key.split("; ", Qt::SkipEmptyParts))
        keys.append(QKeySequence(key, QKeySequence::PortableText));
    item->setShortcuts(keys);
    item->setShortcutContext(Qt::WindowShortcut);
    item->setCheckable(static_cast<bool>(action.is_on));
    items_[action.name] = item;
    window_.addAction(item);
    QObject::connect(item, &QAction::triggered, &window_, [this, name = action.name] { choose(name); });
    actions_.push_back(std::move(action));
}

QAction* Actions::item(const QString& name) const {
    const auto found = items_.find(name);
    return found == items_.end() ? nullptr : found->second;
}

Result<const Action*> Actions::find(const QString& line, QStringList& arguments) const {
    TRY(arguments, split_line(line));
    if (arguments.isEmpty()) return nullptr;
    const QString name = arguments.takeFirst();
    std::vector<std::string> names;
    for (const Action& action : actions_) {
        if (action.name == name) return &action;
        names.push_back(action.name.toStdString());
    }
    return Error{"there is no action '" + name.toStdString() + "'" + did_you_mean(name.toStdString(), names),
                 ""};
}

Result<void> Actions::run(const QString& line) {
    QStringList arguments;
    TRY(const Action* const action, find(line, arguments));
    return action == nullptr ? Result<void>() : run(*action, arguments);
}

void Actions::choose(const QString& line) {
    QStringList arguments;
    const Result<const Action*> action = find(line, arguments);
    const Result<void> done = !action.ok()         ? Result<void>(action.error())
                              : *action == nullptr ? Result<void>()
                                                   : choose(**action, arguments);
    if (!done.ok() && complain) complain(done.error());
}

QString Actions::ask_file(const FileQuestion& asks, QWidget* over) {
    const QDir of_show(show_folder ? show_folder() : QString());
    const QString last = asks.begins == Begins::where_last ? last_folders_[asks.title] : QString();
    const QDir folder(!last.isEmpty()                      ? last
                      : asks.begins == Begins::beside_show ? QFileInfo(of_show.absolutePath()).path()
                                                           : of_show.absolutePath());
    QWidget* const parent = over ? over : &window_;
    QString file =
        asks.proposed.isEmpty()
            ? QFileDialog::getOpenFileName(parent, asks.title, folder.path(), asks.endings)
            : QFileDialog::getSaveFileName(parent, asks.title, folder.filePath(asks.proposed), asks.endings);
    if (!file.isEmpty()) last_folders_[asks.title] = QFileInfo(file).absolutePath();
    return file;
}

Result<void> Actions::choose(const Action& action, QStringList arguments) {
    const FileQuestion& asks = action.asks;
    if (arguments.isEmpty() && !asks.title.isEmpty()) {
        const QString file = ask_file(asks);
        if (file.isEmpty()) return {};
        arguments.append(file);
    }
    const bool before = std::exchange(by_hand_, true);
    const Result<void> done = run(action, arguments);
    by_hand_ = before;
    return done;
}

namespace {

// Whether a switch is to be turned with these words; one that names no arguments of its own takes on and off.
Result<bool> turns(const Action& action, const QStringList& arguments) {
    if (arguments.isEmpty() || !action.arguments.isEmpty()) return true;
    const std::string word = arguments[0].toStdString();
    if (!action.is_on) return Error{"takes no arguments, so what is '" + word + "'?", ""};
    if (arguments.size() > 1 || (word != "on" && word != "off"))
        return Error{"'" + arguments.join(' ').toStdString() + "' is neither on nor off", ""};
    return action.is_on() != (word == "on");
}

} // namespace

Result<void> Actions::run(const Action& action, const QStringList& arguments) {
    const Result<bool> turned = turns(action, arguments);
    const bool lacks_file = arguments.isEmpty() && !action.asks.title.isEmpty();
    const std::size_t before = count_steps ? count_steps() : 0;
    const Result<void> done = lacks_file     ? Result<void>(Error{"it needs the name of a file", ""})
                              : !turned.ok() ? Result<void>(turned.error())
                              : *turned      ? action.run(arguments)
                                             : Result<void>();
    refresh();
    if (done.ok()) {
        if (on_done) on_done(action, count_steps && count_steps() != before);
        return {};
    }
    return Error{done.error().text(), action.name.toStdString()};
}

void Actions::refresh() {
    for (const Action& action : actions_)
        if (action.is_on) items_[action.name]->setChecked(action.is_on());
}

Result<QStringList> split_line(const QString& line) {
    QStringList words;
    QString word;
    bool quoted = false, in_word = false;
    for (const QChar letter : line) {
        if (letter == '"') {
            quoted = !quoted;
            in_word = true;
        } else if (letter.isSpace() && !quoted) {
            if (in_word) words.append(word);
            word.clear();
            in_word = false;
        } else {
            word.append(letter);
            in_word = true;
        }
    }
    if (quoted) return Error{"a quote \" without its end", line.toStdString()};
    if (in_word) words.append(word);
    return words;
}

QString quoted(const QString& words) {
    return "\"" + QString(words).remove('"') + "\"";
}

Result<double> number_of(const QStringList& arguments, int index, const char* what, double low, double high) {
    bool is_number = false;
    const double value = index < arguments.size() ? arguments[index].toDouble(&is_number) : 0.0;
    if (is_number && std::isfinite(value) && value >= low && value <= high) return value;
    const std::string given = index < arguments.size() ? "'" + arguments[index].toStdString() + "' is no "
                                                       : std::string("it needs a ");
    return Error{given + what + " from " + QString::number(low).toStdString() + " to " +
                     QString::number(high).toStdString(),
                 ""};
}

} // namespace ghost::ui
