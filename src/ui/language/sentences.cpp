// SPDX-License-Identifier: Apache-2.0
// Sentences of rooms without Qt are read by people, scripts and files, so they are made in English; where the
// window shows one it is found again by its pattern, and so are the parts that it is made of.
#include "ui/language/language.h"
#include "ui/language/private/sentence_list.h"

#include <QHash>
#include <QRegularExpression>

#include <algorithm>
#include <vector>

namespace ghost::ui {
namespace {

constexpr int kDeepest = 12; // parts of parts
constexpr qsizetype kLongest = 4000;
constexpr qsizetype kKept = 1000; // sentences: the same ones are shown again and again

struct Pattern {
    QString part;        // of it, the longest; what lacks it needs no closer look
    qsizetype fixed = 0; // characters outside of its places
    QRegularExpression english;
    QString german;               // or whatever the language is
    std::vector<int> numbers;     // of the %1 that each group stands for
    std::vector<bool> are_quoted; // names of files, fixtures: stay as they are
};

// "'%1' is no %2 from %3 to %4" -> ^'(.*?)' is no (.*?) from ...$
Pattern pattern_of(const QString& source, const QString& text) {
    static const QRegularExpression kPlace("%([1-9])");
    Pattern pattern{.german = text};
    QString form;
    qsizetype from = 0;
    for (auto places = kPlace.globalMatch(source); places.hasNext();) {
        const QRegularExpressionMatch place = places.next();
        const QString fixed = source.mid(from, place.capturedStart() - from);
        pattern.fixed += fixed.size();
        if (fixed.size() > pattern.part.size()) pattern.part = fixed;
        form += QRegularExpression::escape(fixed);
        const QChar before = place.capturedStart() > 0 ? source[place.capturedStart() - 1] : QChar();
        pattern.numbers.push_back(place.captured(1).toInt());
        pattern.are_quoted.push_back(before == '\'');
        form += before == '\'' ? "([^'\\n]*?)" : "(.+?)";
        from = place.capturedEnd();
    }
    const QString last = source.mid(from);
    pattern.fixed += last.size();
    if (last.size() > pattern.part.size()) pattern.part = last;
    form += QRegularExpression::escape(last);
    pattern.english =
        QRegularExpression("\\A" + form + "\\z", QRegularExpression::DotMatchesEverythingOption);
    return pattern;
}

struct Patterns {
    QString language;
    std::vector<Pattern> all;
    QHash<QString, QString> whole; // those without a place, which are most
    QHash<QString, QString> known;
};

Patterns& patterns() {
    static Patterns now;
    if (now.language == language()) return now;
    now = {.language = language()};
    for (const char* const source : sentence_list()) {
        const QString english = QString::fromUtf8(source), text = translated("Sentence", source);
        if (text == english) continue;
        if (english.contains('%') && QRegularExpression("%[1-9]").match(english).hasMatch())
            now.all.push_back(pattern_of(english, text));
        else
            now.whole[english] = text;
    }
    // What says more by itself is tried first, wherever it stands in the list.
    std::stable_sort(now.all.begin(), now.all.end(),
                     [](const Pattern& a, const Pattern& b) { return a.fixed > b.fixed; });
    return now;
}

QString in_language(const QString& english, int depth) {
    const Patterns& known = patterns();
    if (const auto found = known.whole.find(english); found != known.whole.end()) return *found;
    if (depth == kDeepest || english.size() > kLongest) return english;
    for (const Pattern& pattern : known.all) {
        if (!english.contains(pattern.part)) continue;
        const QRegularExpressionMatch match = pattern.english.match(english);
        if (!match.hasMatch()) continue;
        // At once, for a name may hold "%2".
        QString text;
        for (qsizetype i = 0; i < pattern.german.size(); ++i) {
            const int number = pattern.german[i] == '%' && i + 1 < pattern.german.size()
                                   ? pattern.german[i + 1].digitValue()
                                   : -1;
            const auto group = std::find(pattern.numbers.begin(), pattern.numbers.end(), number);
            if (group == pattern.numbers.end()) {
                text += pattern.german[i];
                continue;
            }
            const auto index = static_cast<std::size_t>(group - pattern.numbers.begin());
            const QString part = match.captured(static_cast<int>(index) + 1);
            text += pattern.are_quoted[index] ? part : in_language(part, depth + 1);
            ++i;
        }
        return text;
    }
    // "show.toml:12: expected a number", "save: no show is open": what stands before is a place.
    for (qsizetype colon = english.indexOf(": "); colon > 0; colon = english.indexOf(": ", colon + 1)) {
        const QString rest = english.mid(colon + 2), text = in_language(rest, depth + 1);
        if (text != rest) return english.left(colon + 2) + text;
    }
    return english;
}

} // namespace

QString said(const QString& english) {
    if (language() == "en" || english.isEmpty()) return english;
    QHash<QString, QString>& known = patterns().known;
    if (const auto found = known.find(english); found != known.end()) return *found;
    if (known.size() >= kKept) known.clear();
    return known[english] = in_language(english, 0);
}

QString said(const char* english) {
    return said(QString::fromUtf8(english));
}

QString said(const std::string& english) {
    return said(QString::fromStdString(english));
}

} // namespace ghost::ui
