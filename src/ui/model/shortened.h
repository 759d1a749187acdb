#pragma once
// SPDX-License-Identifier: Apache-2.0
// Sentences for a line that is too short for them: paths lose their folders but the last, the reason behind
// them stays.
// Pure.

#include <QRegularExpression>
#include <QString>

namespace ghost::ui {

// "/home/me/shows/tour/show.toml:12: expected a number" -> ".../tour/show.toml:12: expected a number", the
// longest path first, only as many as it takes.
inline QString shortened(const QString& sentence, int most_letters) {
    // All folders of a path but the one of the file, whose name tells one show.toml from another.
    static const QRegularExpression kFolders(R"rx([^\s:'"(]*/(?:[^\s:'"/]+/)+)rx");
    QString words = sentence;
    while (words.size() > most_letters) {
        QString longest;
        qsizetype at = -1;
        for (auto found = kFolders.globalMatch(words); found.hasNext();) {
            const QRegularExpressionMatch folders = found.next();
            if (folders.capturedLength() <= longest.size() || folders.captured().startsWith("...")) continue;
            longest = folders.captured();
            at = folders.capturedStart();
        }
        const QString last = ".../" + longest.section('/', -2);
        if (at < 0 || last.size() >= longest.size()) break;
        words.replace(at, longest.size(), last);
    }
    return words;
}

} // namespace ghost::ui
