// SPDX-License-Identifier: Apache-2.0
#include "ui/window/private/print_preview.h"

#include "ui/language/language.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace ghost::ui {
namespace {

constexpr qint64 kMostTableBytes = 256 * 1024, kMostBookBytes = 4 * 1024 * 1024,
                 kMostPageBytes = 16 * 1024 * 1024;
constexpr std::size_t kMostRowsShown = 200;

QByteArray beginning_of(const QString& path, qint64 most) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.read(most) : QByteArray();
}

QString between(const QString& text, const char* begin, const char* end) {
    const qsizetype from = text.indexOf(begin);
    if (from < 0) return {};
    const qsizetype after = from + static_cast<qsizetype>(qstrlen(begin));
    return text.mid(after, text.indexOf(end, after) - after);
}

// Of html_name() and html_text() (print/html.h).
QString plain(QString html) {
    html.remove("<bdi>").remove("</bdi>");
    constexpr std::pair<const char*, const char*> kLetters[] = {
        {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"}, {"&amp;", "&"}};
    for (const auto& [mark, letter] : kLetters) html.replace(mark, letter);
    return html;
}

QStringList sentences_of(const QString& section) {
    QStringList sentences = between(section, "<ul class=\"unknown\">", "</ul>").split("<li>");
    sentences.removeFirst();
    for (QString& sentence : sentences) sentence = plain(sentence.section("</li>", 0, 0));
    return sentences;
}

} // namespace

std::vector<PrintedTable> printed_tables(const QString& folder) {
    std::vector<PrintedTable> tables;
    QStringList files = QDir(folder).entryList({"*.csv"}, QDir::Files, QDir::Name);
    const QString page = QString::fromUtf8(beginning_of(QDir(folder).filePath("index.html"), kMostPageBytes));
    for (const QString& section : page.split("<section ").mid(1)) {
        const QString file = between(section, "id=\"", "\"") + ".csv";
        if (files.removeAll(file) == 0) continue;
        const QString head = section.left(section.indexOf("<table"));
        tables.push_back(
            {plain(between(head, "<h2>", "</h2>")), QDir(folder).filePath(file), sentences_of(head)});
    }
    for (const QString& file : files)
        tables.push_back({file == "focus.csv" ? translated("Print", "Focus charts") : file,
                          QDir(folder).filePath(file),
                          {}});
    return tables;
}

// RFC 4180.
PrintedRows printed_rows(const QString& csv_file) {
    const QByteArray bytes = beginning_of(csv_file, kMostTableBytes);
    const QString csv = QString::fromUtf8(bytes).remove(QChar(0xFEFF));
    std::vector<QStringList> rows(1);
    QString cell;
    bool is_quoted = false;
    qsizetype k = 0;
    for (; k < csv.size() && rows.size() <= kMostRowsShown + 1; ++k) {
        const QChar letter = csv[k];
        if (letter == '"' && is_quoted && k + 1 < csv.size() && csv[k + 1] == '"') {
            cell += letter;
            ++k;
        } else if (letter == '"') {
            is_quoted = !is_quoted;
        } else if (!is_quoted && letter == ',') {
            rows.back() << cell;
            cell.clear();
        } else if (!is_quoted && letter == '\n') {
            rows.back() << cell;
            cell.clear();
            rows.emplace_back();
        } else if (letter != '\r') {
            cell += letter;
        }
    }
    rows.pop_back(); // what is cut
    return {std::move(rows), k == csv.size() && bytes.size() < kMostTableBytes};
}

PrintedBook printed_book(const QString& folder) {
    const QString file = QDir(folder).filePath("book.json");
    const QByteArray bytes = beginning_of(file, kMostBookBytes + 1);
    if (bytes.size() > kMostBookBytes)
        return {{},
                {translated("Print", "The book is larger than what is shown here: open it in the browser.")}};
    const QJsonDocument book = QJsonDocument::fromJson(bytes);
    if (!book.isObject()) return {{}, {translated("Print", "The book cannot be read: %1").arg(file)}};
    return {book["entries"].toArray(), book["unknown"].toVariant().toStringList()};
}

} // namespace ghost::ui
