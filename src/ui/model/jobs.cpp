// SPDX-License-Identifier: Apache-2.0
#include "ui/model/jobs.h"

#include "base/progress.h"
#include "disk/whole_folder.h"
#include "ui/language/language.h"

#include <QRegularExpression>
#include <QStandardPaths>

#include <algorithm>
#include <utility>

namespace ghost::ui {
namespace {

constexpr int kPatience_ms = 20000;     // a bake finishes its batch of lights
constexpr int kLastPatience_ms = 10000; // the window is gone already: a book takes its folder away
constexpr int kKilled_ms = 3000;
constexpr std::size_t kMostKept = 50; // that are over
constexpr qsizetype kLongestLine = 4096;
constexpr qsizetype kMostRemarks = 100;
const char* const kProgressEvery_s = "0.25";

// What it was killed out of, which it could not take away itself.
void tidy_after(const QStringList& arguments) {
    const qsizetype at = arguments.indexOf("-o");
    if (at >= 0 && at + 1 < arguments.size()) WholeFolder::remove_leftovers(arguments[at + 1].toStdString());
}

} // namespace

const char* state_name(Job::State state) {
    switch (state) {
    case Job::State::waits:
        return QT_TRANSLATE_NOOP("Jobs", "waits");
    case Job::State::runs:
        return QT_TRANSLATE_NOOP("Jobs", "runs");
    case Job::State::done:
        return QT_TRANSLATE_NOOP("Jobs", "done");
    case Job::State::failed:
        return QT_TRANSLATE_NOOP("Jobs", "failed");
    case Job::State::cancelled:
        break;
    }
    return QT_TRANSLATE_NOOP("Jobs", "cancelled");
}

QString outcome_words(const Job& job) {
    QString words = translated("Jobs", state_name(job.state));
    if (job.state == Job::State::failed) words += ". " + said(job.last_said);
    if (job.state == Job::State::done && job.is_incomplete)
        words += ". " + translated("Jobs", "The show lacks something: %1").arg(said(job.remarks.first()));
    return words;
}

std::optional<ProgressLine> progress_of(const QString& line) {
    static const QRegularExpression kForm(
        "^(\\S.*?) +(\\d{1,3}) % \\[[# ]*\\](?: ([\\d:]+) left)?(?:  (.*))?$");
    const QRegularExpressionMatch match = kForm.match(line);
    if (!match.hasMatch()) return std::nullopt;
    ProgressLine progress;
    progress.doing = match.captured(1);
    if (!match.captured(4).isEmpty()) progress.doing += ": " + match.captured(4);
    progress.share = std::min(match.captured(2).toDouble() / 100, 1.0);
    progress.left = match.captured(3);
    return progress;
}

Jobs::Jobs(QString program) : program_(std::move(program)) {
    patience_.setSingleShot(true);
    connect(&patience_, &QTimer::timeout, this, [this] {
        if (process_) process_->kill();
    });
}

Jobs::~Jobs() {
    if (!process_) return;
    process_->disconnect(this);
    process_->terminate();
    if (!process_->waitForFinished(kLastPatience_ms)) {
        process_->kill();
        process_->waitForFinished(kKilled_ms);
    }
    if (const Job* job = running()) tidy_after(job->arguments);
}

bool Jobs::is_busy() const {
    return std::any_of(jobs_.begin(), jobs_.end(), [](const Job& job) { return !job.is_over(); });
}

Job* Jobs::running() {
    for (Job& job : jobs_)
        if (job.state == Job::State::runs) return &job;
    return nullptr;
}

int Jobs::start(const QString& title, const QStringList& arguments) {
    if (jobs_.size() >= kMostKept && jobs_.front().is_over()) jobs_.pop_front();
    Job& job = jobs_.emplace_back();
    job.number = ++last_number_;
    job.title = title;
    job.arguments = arguments;
    const int number = job.number; // the job may end at once
    begin_next();
    Q_EMIT changed();
    return number;
}

void Jobs::begin_next() {
    if (process_) return;
    const auto next = std::find_if(jobs_.begin(), jobs_.end(),
                                   [](const Job& job) { return job.state == Job::State::waits; });
    if (next == jobs_.end()) return;
    next->state = Job::State::runs;
    process_ = std::make_unique<QProcess>();
    process_->setProcessChannelMode(QProcess::MergedChannels);
    connect(process_.get(), &QProcess::readyRead, this, &Jobs::read);
    // Queued: it ends the process that says so.
    connect(
        process_.get(), &QProcess::finished, this,
        [this](int code, QProcess::ExitStatus status) {
            read();
            if (!unread_.isEmpty()) take_line(QString::fromUtf8(std::exchange(unread_, {})));
            Job* job = running();
            if (job)
                job->is_incomplete =
                    code == 1 && !job->remarks.isEmpty() && job->last_said.endsWith(kMadeButMissing);
            const bool is_made = code == 0 || (job && job->is_incomplete);
            end(status == QProcess::NormalExit && is_made ? Job::State::done : Job::State::failed);
        },
        Qt::QueuedConnection);
    connect(
        process_.get(), &QProcess::errorOccurred, this,
        [this](QProcess::ProcessError error) {
            if (error != QProcess::FailedToStart) return;
            if (Job* job = running()) job->last_said = process_->errorString();
            end(Job::State::failed);
        },
        Qt::QueuedConnection);
    QStringList arguments{"--progress-every", kProgressEvery_s};
    arguments += next->arguments;
    // The picture comes first.
    const QString nice = QStandardPaths::findExecutable("nice");
    if (nice.isEmpty()) {
        process_->start(program_, arguments);
    } else {
        arguments.prepend(program_);
        arguments = QStringList{"-n", "10"} + arguments;
        process_->start(nice, arguments);
    }
    process_->closeWriteChannel();
}

void Jobs::read() {
    if (!process_) return;
    unread_ += process_->readAll();
    for (qsizetype end = 0; (end = unread_.indexOf('\n')) >= 0;) {
        take_line(QString::fromUtf8(unread_.left(std::min(end, kLongestLine))));
        unread_.remove(0, end + 1);
    }
    if (unread_.size() > kLongestLine) unread_.clear(); // no line of ours is that long
    Q_EMIT changed();
}

void Jobs::take_line(const QString& line) {
    Job* job = running();
    if (!job) return;
    if (const auto progress = progress_of(line)) {
        job->doing = progress->doing;
        job->share = progress->share;
        job->left = progress->left;
    } else if (!line.trimmed().isEmpty()) {
        job->last_said = line.trimmed();
        static const QRegularExpression kForm("^(warning|error): (.*)$");
        const QRegularExpressionMatch remark = kForm.match(job->last_said);
        if (!remark.hasMatch()) return;
        ++job->remark_count;
        if (job->remarks.size() < kMostRemarks) job->remarks << remark.captured(2);
    }
}

void Jobs::end(Job::State state) {
    patience_.stop();
    Job* job = running();
    if (!job || !process_) return;
    job->state = job->is_given_up ? Job::State::cancelled : state;
    job->left.clear();
    if (job->state == Job::State::done) job->share = 1;
    process_.reset();
    unread_.clear();
    if (job->state != Job::State::done) tidy_after(job->arguments);
    const Job copy = *job;
    begin_next();
    Q_EMIT ended(copy);
    Q_EMIT changed();
}

void Jobs::cancel(int number) {
    const auto job =
        std::find_if(jobs_.begin(), jobs_.end(), [&](const Job& one) { return one.number == number; });
    if (job != jobs_.end() && job->state == Job::State::waits) {
        job->state = Job::State::cancelled;
        Q_EMIT ended(Job(*job)); // who hears of it may begin another one
    } else if (job != jobs_.end() && job->state == Job::State::runs && process_) {
        job->is_given_up = true;
        process_->terminate();
        patience_.start(kPatience_ms);
    }
    Q_EMIT changed();
}

void Jobs::cancel_all() {
    std::deque<int> numbers;
    for (const Job& job : jobs_)
        if (!job.is_over()) numbers.push_front(job.number); // those that wait first
    for (const int number : numbers) cancel(number);
}

void Jobs::forget_finished() {
    std::erase_if(jobs_, [](const Job& job) { return job.is_over(); });
    Q_EMIT changed();
}

} // namespace ghost::ui
