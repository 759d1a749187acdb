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

constexpr int kDeepest = 24;         // parts of parts
constexpr int kMostLookedFor = 2000; // in one sentence, which may hold what strangers send
constexpr qsizetype kLongest = 8000;
constexpr qsizetype kKept = 1000; // sentences: the same ones are shown again and again

struct Pattern {
    QString part;        // of it, the longest; what lacks it needs no closer look
    qsizetype fixed = 0; // characters outside of its places
    QRegularExpression english;
    QString german;               // or whatever the language is
    std::vector<int> numbers;     // of the %1 that each group stands for
    std::vector<bool> are_quoted; // names of files, fixtures: stay as they are
    bool is_part = false;
};

// What a place holds: a name whose place follows, "'Sound and Light' (10.0.0.2)", as one, whatever it says.
QString held_by(bool is_one_sentence) {
    const QString name = "'[^'\\n]*' \\(";
    return "(?:" + name + "|(?!" + name + ")" + (is_one_sentence ? "(?!(?:(?<!\\.)\\.|;) )" : "") + ".)";
}

// "'%1' is no %2 from %3 to %4" -> ^'(.*?)' is no (.*?) from ...$
Pattern pattern_of(const QString& source, const QString& text, bool is_part) {
    static const QRegularExpression kPlace("%([1-9])");
    Pattern pattern{.german = text, .is_part = is_part};
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
        from = place.capturedEnd();
        // Several sentences stand at the end of one, and before an end: of such the last one is meant.
        const QStringView after = QStringView(source).sliced(from);
        const bool is_ended = after.startsWith(u". ") || after.startsWith(u"; ");
        const QString held = held_by(is_part || !(is_ended || after.isEmpty()));
        form += before == '\'' ? "([^'\\n]*?)" : "(" + held + (is_ended ? "+)" : "+?)");
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
    const auto add = [](const char* source, bool is_part) {
        const QString english = QString::fromUtf8(source), text = translated("Sentence", source);
        if (text == english) return;
        if (english.contains('%') && QRegularExpression("%[1-9]").match(english).hasMatch())
            now.all.push_back(pattern_of(english, text, is_part));
        else
            now.whole[english] = text;
    };
    for (const char* const source : sentence_list()) add(source, false);
    for (const char* const source : part_list()) add(source, true);
    // What says more by itself is tried first, wherever it stands in the list.
    std::stable_sort(now.all.begin(), now.all.end(),
                     [](const Pattern& a, const Pattern& b) { return a.fixed > b.fixed; });
    return now;
}

// One sentence and what it is made of.
class Reader {
public:
    explicit Reader(const Patterns& known) : known_(known) {}

    // Parts are known inside of a sentence only: alone they would be found in what is none of ours.
    QString read(const QString& english, bool is_inside, int depth = 0) {
        QHash<QString, QString>& read_before = is_inside ? parts_ : sentences_;
        if (const auto found = read_before.find(english); found != read_before.end()) return *found;
        if (depth == kDeepest || looked_for_ == kMostLookedFor) return english;
        ++looked_for_;
        return read_before[english] = find(english, is_inside, depth);
    }

private:
    QString find(const QString& english, bool is_inside, int depth) {
        if (const auto found = known_.whole.find(english); found != known_.whole.end()) return *found;
        for (const Pattern& pattern : known_.all) {
            if ((pattern.is_part && !is_inside) || !english.contains(pattern.part)) continue;
            if (const auto match = pattern.english.match(english); match.hasMatch())
                return filled(pattern, match, depth);
        }
        // "the last look is held; the port is taken by ..": two that were put together.
        for (qsizetype end = english.lastIndexOf("; "); end > 0; end = english.lastIndexOf("; ", end - 1)) {
            const QString first = english.left(end), second = english.mid(end + 2),
                          second_text = read(second, is_inside, depth + 1);
            if (second_text == second) continue;
            if (const QString text = read(first, is_inside, depth + 1); text != first)
                return text + "; " + second_text;
        }
        // "show.toml:12: expected a number", "save: no show is open": what stands before is a place.
        for (qsizetype colon = english.indexOf(": "); colon > 0; colon = english.indexOf(": ", colon + 1)) {
            const QString rest = english.mid(colon + 2), text = read(rest, is_inside, depth + 1);
            if (text != rest) return english.left(colon + 2) + text;
        }
        return english;
    }

    // At once, for a name may hold "%2".
    QString filled(const Pattern& pattern, const QRegularExpressionMatch& match, int depth) {
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
            text += pattern.are_quoted[index] ? part : read(part, true, depth + 1);
            ++i;
        }
        return text;
    }

    const Patterns& known_;
    QHash<QString, QString> sentences_, parts_; // read before
    int looked_for_ = 0;
};

// Rooms without Qt write for terminals, too. What stands in quotes is a name.
QString with_signs(const QString& english) {
    if (!english.contains(" deg")) return english;
    static const auto kDegrees = QRegularExpression("(?<=\\d) deg\\b");
    QStringList parts = english.split('\'');
    for (qsizetype i = 0; i < parts.size(); i += 2) parts[i].replace(kDegrees, "\u00b0");
    return parts.join('\'');
}

} // namespace

QString said(const QString& english) {
    if (language() == "en" || english.isEmpty()) return with_signs(english);
    QHash<QString, QString>& known = patterns().known;
    if (const auto found = known.find(english); found != known.end()) return *found;
    if (known.size() >= kKept) known.clear();
    if (english.size() > kLongest) return english;
    return known[english] = Reader(patterns()).read(english, false);
}

QString said(const char* english) {
    return said(QString::fromUtf8(english));
}

QString said(const std::string& english) {
    return said(QString::fromStdString(english));
}

} // namespace ghost::ui
