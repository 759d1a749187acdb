#pragma once
// SPDX-License-Identifier: Apache-2.0
// Actions: everything that a person can do, in one table: a name for scripts, words for menus, a key, and the
// function. Menus, keys, the shortcut sheet and scripts all read this table, so none of them can do what the
// others cannot. Window thread.

#include "base/result.h"

#include <QAction>
#include <QStringList>
#include <QWidget>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace ghost::ui {

// Where its dialog begins, for the folder of the terminal is none that a person has in mind: where the same
// was asked last, at first with the show that is open; always with that show; or beside its folder.
enum class Begins { where_last, with_show, beside_show };

// What a person is asked in a dialog who chose an action without its file; a script has to name it.
struct FileQuestion {
    QString title;
    QString endings;  // as QFileDialog takes them: "Pictures (*.png *.exr)"
    QString proposed; // a name to save by; empty: an existing file is chosen
    Begins begins = Begins::where_last;
};

struct Action {
    QString name;      // for scripts: "black-out"
    QString menu;      // "View"; empty: for scripts, and for lists of its own
    QString text;      // "Black-out"
    QString key;       // "B"; empty: none. Several with "; " between them
    QString arguments; // of a script line, for people: "FILE"; empty: none, a switch takes "on" and "off"
    std::function<Result<void>(const QStringList& arguments)> run;
    std::function<bool()> is_on; // where it is a switch: its state, for the tick in the menu
    FileQuestion asks = {};      // no title: nothing is asked
};

class Actions {
public:
    // Keys work in the whole of that window.
    explicit Actions(QWidget& window) : window_(window) {}

    void add(Action action);
    const std::vector<Action>& all() const { return actions_; }
    // For menus and tool bars; null where there is none of that name.
    QAction* item(const QString& name) const;
    // One line of a script: the name and its arguments, those with blanks in "quotes". Error: no such action
    // (with a near name), a word behind the last argument that it knows, or what it said itself.
    Result<void> run(const QString& line);
    // The same by a person's hand: what lacks its file is asked for (no answer: nothing happens), and what
    // went wrong goes to `complain`.
    void choose(const QString& line);
    // Asks a person. Empty: no answer.
    QString ask_file(const FileQuestion& asks, QWidget* over = nullptr);
    // While an action runs: whether a person chose it.
    bool is_by_hand() const { return by_hand_; }
    // Sets the ticks of all switches.
    void refresh();

    // The folder of the show that is open, else one to begin with.
    std::function<QString()> show_folder;
    // Where what went wrong is said when a person did it, not a script.
    std::function<void(const Error&)> complain;
    // A word that a person is asked for who chose an action without it: what, what is proposed, and what
    // takes it.
    std::function<void(const QString& what, const QString& value,
                       std::function<Result<void>(const QString&)> done)>
        ask_word;
    // After each action that was done, whoever asked for it. made_step: it did something that can be undone.
    std::function<void(const Action&, bool made_step)> on_done;
    // How often something was done or undone so far that can be undone.
    std::function<std::size_t()> count_steps;

private:
    // Null: the line is empty. Error: no such action.
    Result<const Action*> find(const QString& line, QStringList& arguments) const;
    Result<void> run(const Action& action, const QStringList& arguments);
    Result<void> choose(const Action& action, QStringList arguments);

    QWidget& window_;
    std::vector<Action> actions_;
    std::map<QString, QAction*> items_;
    std::map<QString, QString> last_folders_; // by title of the question
    bool by_hand_ = false;
};

// "a "b c"" -> a, b c. A quote that is meant has a \ before it; a \ is one everywhere else, and before a
// quote that is none where there are two of them. Error: a quote without its end.
Result<QStringList> split_line(const QString& line);
// As one argument of a line, with whatever stands in it.
QString quoted(const QString& words);

// A finite number in a range; the error names the argument.
Result<double> number_of(const QStringList& arguments, int index, const char* what, double low, double high);

} // namespace ghost::ui
