// SPDX-License-Identifier: Apache-2.0
#include "ui/actions/actions.h"

#include "base/suggest.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QRegularExpression>

#include <cmath>
#include <optional>
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

namespace {

// Where all files of it end alike a name that is typed without that ending gets it before it is asked whether
// the file of that name is to go.
QString ask_name(QWidget* over, const FileQuestion& asks, const QDir& folder) {
    QFileDialog dialog(over, asks.title, folder.path(), asks.endings);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setFileMode(QFileDialog::AnyFile);
    static const QRegularExpression kOneEnding("\\(\\*\\.([^ )]+)\\)$");
    dialog.setDefaultSuffix(kOneEnding.match(asks.endings).captured(1));
    dialog.selectFile(asks.proposed);
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

} // namespace

QString Actions::ask_file(const FileQuestion& asks, QWidget* over) {
    const QDir of_show(show_folder ? show_folder() : QString());
    const QString last = asks.begins == Begins::where_last ? last_folders_[asks.title] : QString();
    const QDir folder(!last.isEmpty()                      ? last
                      : asks.begins == Begins::beside_show ? QFileInfo(of_show.absolutePath()).path()
                                                           : of_show.absolutePath());
    QWidget* const parent = over ? over : &window_;
    QString file = asks.proposed.isEmpty()
                       ? QFileDialog::getOpenFileName(parent, asks.title, folder.path(), asks.endings)
                       : ask_name(parent, asks, folder);
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

// Of a line, by what is said of them to people: "FROM TO|off" are two. Nothing: as many as one likes.
std::optional<qsizetype> most_arguments(const Action& action) {
    for (const char* const many : {"...", "NUMBERS", "OPTIONS"})
        if (action.arguments.contains(many)) return std::nullopt;
    return action.arguments.split(' ', Qt::SkipEmptyParts).size();
}

// Whether a switch is to be turned with these words; one that names no arguments of its own takes on and off.
Result<bool> turns(const Action& action, const QStringList& arguments) {
    if (arguments.isEmpty()) return true;
    if (!action.arguments.isEmpty()) {
        const std::optional<qsizetype> most = most_arguments(action);
        if (!most || arguments.size() <= *most) return true;
        return Error{"'" + arguments[*most].toStdString() + "' is a word too many: it takes " +
                         action.arguments.toStdString(),
                     ""};
    }
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
    for (qsizetype i = 0; i < line.size(); ++i) {
        const QChar letter = line[i];
        qsizetype before_quote = i;
        while (before_quote < line.size() && line[before_quote] == '\\') ++before_quote;
        const qsizetype slashes = before_quote - i;
        if (slashes > 0 && before_quote < line.size() && line[before_quote] == '"') {
            word.append(QString(slashes / 2, '\\'));
            in_word = true;
            i = before_quote - 1;
            if (slashes % 2 == 0) continue; // the quote is one
            word.append('"');
            ++i;
        } else if (letter == '"') {
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
    QString line = "\"";
    qsizetype slashes = 0; // that stand before a quote, be it the last one, would be its own
    for (const QChar letter : words) {
        if (letter == '"') line += QString(slashes + 1, '\\');
        slashes = letter == '\\' ? slashes + 1 : 0;
        line += letter;
    }
    return line + QString(slashes, '\\') + "\"";
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
