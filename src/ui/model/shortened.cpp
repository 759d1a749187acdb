// SPDX-License-Identifier: Apache-2.0
#include "ui/model/shortened.h"

#include <QRegularExpression>

namespace ghost::ui {

QString shortened(const QString& sentence, int most_letters) {
    // All folders of a path, not its last name. One of a single folder is short enough.
    static const QRegularExpression kFolders(R"rx([^\s:'"(]*/(?:[^\s:'"/]+/)+)rx");
    QString words = sentence;
    while (words.size() > most_letters) {
        qsizetype longest = 4, at = -1; // longer than what stands for them
        for (auto found = kFolders.globalMatch(words); found.hasNext();) {
            const QRegularExpressionMatch folders = found.next();
            if (folders.capturedLength() <= longest) continue;
            longest = folders.capturedLength();
            at = folders.capturedStart();
        }
        if (at < 0) break;
        words.replace(at, longest, QString(".../"));
    }
    return words;
}

} // namespace ghost::ui
