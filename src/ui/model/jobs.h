#pragma once
// SPDX-License-Identifier: Apache-2.0
// Jobs: long work in the background: commands of this very program (bake, render, sheet), one after the
// other, each a process of its own, so that neither its cores nor its faults stop the picture. Their progress
// is read from what they print. Window thread.

#include <QObject>
#include <QProcess>
#include <QString>
#include <QStringList>
#include <QTimer>

#include <deque>
#include <memory>
#include <optional>

namespace ghost::ui {

struct Job {
    enum class State { waits, runs, done, failed, cancelled };

    int number = 0; // grows
    QString title;
    QStringList arguments; // of the program
    State state = State::waits;
    double share = 0;           // of the work that is done
    QString left;               // "1:05", time that it still takes; empty: not known yet
    QString doing;              // "baking", and what of
    QString last_said;          // that is no progress
    QStringList remarks;        // the first warnings and errors
    int remark_count = 0;       // of all of them
    bool is_incomplete = false; // done, but the show lacks something; the first remark says what
    bool is_given_up = false;   // somebody cancelled it; it may take a while to end

    bool is_over() const { return state != State::waits && state != State::runs; }
};
const char* state_name(Job::State state);
// How one that is over went, in words.
QString outcome_words(const Job& job);

// A line of progress as base/progress.h prints it: "baking  42 % [####   ] 0:12 left  foh".
struct ProgressLine {
    QString doing;
    double share = 0;
    QString left;
};
std::optional<ProgressLine> progress_of(const QString& line);

class Jobs : public QObject {
    Q_OBJECT
public:
    // program: this one, as a rule.
    explicit Jobs(QString program);
    ~Jobs() override; // ends what runs; a bake keeps what is finished

    int start(const QString& title, const QStringList& arguments);
    void cancel(int number);
    void cancel_all();
    void forget_finished();
    const std::deque<Job>& all() const { return jobs_; }
    bool is_busy() const;

Q_SIGNALS:
    void changed();
    void ended(const Job& job);

private:
    void begin_next();
    void read();
    void take_line(const QString& line);
    void end(Job::State state);
    Job* running();

    QString program_;
    std::deque<Job> jobs_;
    int last_number_ = 0;
    std::unique_ptr<QProcess> process_; // of the job that runs
    QByteArray unread_;
    QTimer patience_; // a job that is cancelled and does not end is killed
};

} // namespace ghost::ui
