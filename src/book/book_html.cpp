// SPDX-License-Identifier: Apache-2.0
#include "book/book_html.h"

#include "book/private/entry_text.h"
#include "book/quantities.h"

#include <cstdio>

namespace ghost::scene {
namespace {

// What the slider covers is cut away; a page from file:// loads no modules.
constexpr std::string_view kScript = R"(<script>
for (const range of document.querySelectorAll('.slide + input')) {
  const old = range.previousElementSibling.querySelector('.old');
  const cut = () => { old.style.clipPath = 'inset(0 ' + (100 - range.value) + '% 0 0)'; };
  range.addEventListener('input', cut);
  cut();
}
</script>
)";

std::string list_of(const std::vector<std::string>& sentences, const std::string& style) {
    if (sentences.empty()) return "";
    std::string text = "<ul" + (style.empty() ? "" : " class=\"" + style + "\"") + ">\n";
    for (const std::string& sentence : sentences) text += "<li>" + html_name(sentence) + "</li>\n";
    return text + "</ul>\n";
}

std::string size_of(const Book& book) {
    return " width=\"" + std::to_string(book.width) + "\" height=\"" + std::to_string(book.height) + "\"";
}

std::string changes_of_entry(const BookEntry& entry, bool is_first) {
    std::string text = is_first ? "<h3>From the dark</h3>\n" : "<h3>What changes</h3>\n";
    if (entry.changes.empty()) return text + "<p class=\"of\">nothing that is seen</p>\n";
    return text + list_of(change_lines(entry), "");
}

std::string anchor(std::size_t entry) {
    return "e" + std::to_string(entry + 1);
}

std::string section_of(const Book& book, std::size_t index) {
    const BookEntry& entry = book.entries[index];
    std::string text = "<article class=\"entry\" id=\"" + anchor(index) + "\">\n<h2>" +
                       std::to_string(index + 1) + ". " + html_name(entry.name) + "</h2>\n";
    if (const std::string times = times_text(entry); !times.empty())
        text += "<p class=\"of\">" + html_name(times) + "</p>\n";
    if (!entry.notes.empty()) text += "<p>" + html_name(entry.notes) + "</p>\n";
    text += "<div class=\"pictures\">\n";
    for (const BookPicture& picture : entry.pictures)
        text += "<figure><img loading=\"lazy\" src=\"" + html_text(picture.file) + "\"" + size_of(book) +
                " alt=\"" + html_text(entry.name + " from " + picture.camera) + "\"><figcaption>" +
                html_name(picture.camera) + "</figcaption></figure>\n";
    text += "</div>\n" + list_of(entry.unknown, "unknown");
    text += changes_of_entry(entry, index == 0);
    return text + "<p class=\"pencil\"></p><p class=\"pencil\"></p>\n</article>\n";
}

std::string figure_text(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3f", value);
    return text;
}

std::string rows_of(const BookDifference& difference) {
    std::string text =
        "<table>\n<thead><tr><th>entry</th><th>camera</th><th>difference</th><th>mean</th>"
        "<th>p99</th><th>largest</th><th>of the picture above 0.1</th></tr></thead>\n<tbody>\n";
    for (const ComparedPicture& picture : difference.pictures) {
        text += "<tr><td>" + html_name(picture.name) + "</td><td>" + html_name(picture.camera) + "</td>";
        if (const auto& d = picture.difference)
            text += "<td>" + words_of(d->seen) + "</td><td class=\"n\">" + figure_text(d->mean) +
                    "</td><td class=\"n\">" + figure_text(d->p99) + "</td><td class=\"n\">" +
                    figure_text(d->max) + "</td><td class=\"n\">" +
                    number_text(static_cast<float>(100.0 * d->share), 1) + " %</td>";
        else
            text += "<td colspan=\"5\">" + html_name(picture.why_not) + "</td>";
        text += "</tr>\n";
    }
    return text + "</tbody></table>\n";
}

std::string slider_of(const Book& book, const ComparedPicture& picture) {
    const std::string name = html_text(picture.name + " from " + picture.camera);
    return "<h3>" + html_name(picture.name) + ", " + html_name(picture.camera) +
           "</h3>\n<div class=\"pictures\">\n<figure><div class=\"slide\"><img loading=\"lazy\" src=\"" +
           html_text(picture.file) + "\"" + size_of(book) + " alt=\"" + name +
           ", now\"><img class=\"old\" loading=\"lazy\" src=\"" + html_text(picture.old_file) + "\"" +
           size_of(book) + " alt=\"" + name + ", before\"></div><input type=\"range\" min=\"0\" max=\"100\"" +
           " value=\"50\" aria-label=\"how much of the older picture covers " + name +
           "\"><figcaption>left: before, right: now</figcaption></figure>\n<figure><img loading=\"lazy\" " +
           "src=\"" + html_text(picture.map_file) + "\"" + size_of(book) + " alt=\"where " + name +
           " differs\"><figcaption>where they differ: black not at all, yellow most</figcaption></figure>\n"
           "</div>\n";
}

std::string difference_section(const Book& book, const BookDifference& difference) {
    std::string text = "<section id=\"difference\">\n<h2>Since " + html_name(difference.old_name) +
                       "</h2>\n" + list_of(difference.unknown, "unknown") + "<h3>Entries</h3>\n";
    const std::string nothing = "<p class=\"of\">no change</p>\n";
    text += difference.entries.empty() ? nothing : list_of(difference.entries, "");
    text += "<h3>Fixtures</h3>\n";
    text += difference.fixtures.empty() ? nothing : list_of(difference.fixtures, "");
    text += "<h3>Pictures</h3>\n";
    text += difference.pictures.empty() ? "<p class=\"of\">none can be compared</p>\n" : rows_of(difference);
    for (const ComparedPicture& picture : difference.pictures)
        if (!picture.map_file.empty()) text += slider_of(book, picture);
    return text + "</section>\n";
}

} // namespace

std::string html_of(const Book& book, const BookDifference* difference, PaperSize paper) {
    std::string page = html_begin(book.show + ": cue book", paper);
    page += "<h1>" + html_name(book.show) +
            "</h1>\n<p class=\"of\">Cue book: " + std::to_string(book.entries.size()) + " " +
            (book.entries.size() == 1 ? "entry" : "entries") + " (" + html_text(book.kind) + "), " +
            std::to_string(book.fixtures.size()) + " fixtures, pictures of " + std::to_string(book.width) +
            "x" + std::to_string(book.height) + " at exposure " + number_text(book.ev100, 2) + ", drawn by " +
            html_name(book.device) + "</p>\n" + list_of(book.unknown, "unknown");
    page += "<nav aria-label=\"entries\">\n";
    if (difference) page += "<a href=\"#difference\">what changed since the older one</a>\n";
    for (std::size_t i = 0; i < book.entries.size(); ++i)
        page += "<a href=\"#" + anchor(i) + "\">" + std::to_string(i + 1) + ". " +
                html_name(book.entries[i].name) + "</a>\n";
    page += "</nav>\n";
    if (difference) page += difference_section(book, *difference);
    page += "<section>\n";
    for (std::size_t i = 0; i < book.entries.size(); ++i) page += section_of(book, i);
    page += "</section>\n";
    if (difference) page += kScript;
    return page + html_end();
}

} // namespace ghost::scene
