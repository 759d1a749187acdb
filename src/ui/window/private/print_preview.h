#pragma once
// SPDX-License-Identifier: Apache-2.0
// What the window shows of paperwork and of a cue book that were made, read from their folder: its beginning,
// for the whole of it is in the folder. Window thread.

#include <QJsonArray>
#include <QString>
#include <QStringList>

#include <vector>

namespace ghost::ui {

struct PrintedTable {
    QString title;
    QString file;        // .csv
    QStringList unknown; // sentences
};
// As the page has them, then those that are beside it only.
std::vector<PrintedTable> printed_tables(const QString& folder);

struct PrintedRows {
    std::vector<QStringList> rows; // the first: names of the columns
    bool is_whole = true;
};
PrintedRows printed_rows(const QString& csv_file);

struct PrintedBook {
    QJsonArray entries;
    QStringList unknown; // sentences; why there are no entries, too
};
PrintedBook printed_book(const QString& folder);

} // namespace ghost::ui
