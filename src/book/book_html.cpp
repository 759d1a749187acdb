// SPDX-License-Identifier: Apache-2.0
#include "book/book_html.h"

#include "book/private/entry_text.h"
#include "book/private/slider.h"
#include "print/quantities.h"

#include <cstdio>

namespace ghost::scene {
namespace {

std::string list_of(const std::vector<std::string>& sentences, const std::string& style) {
    if (sentences.empty()) return "";
    std::string text = "<ul" + (style.empty() ? "" : " class=\"" + style + "\"") + ">\n";
    for (const std::string& sentence : sentences) text += "<li>" + html_name(sentence) + "</li>\n";
    return text + "</ul>\n";
}

std::string changes_of_entry(const BookEntry& entry, bool is_first, const PrintStyle& style) {
    std::string text = "<h3>" + (is_first ? style("From the dark") : style("What changes")) + "</h3>\n";
    if (entry.changes.empty()) return text + "<p class=\"of\">" + style("nothing that is seen") + "</p>\n";
    return text + list_of(change_lines(entry, style), "");
}

// Book::kind is English, for programs read it.
std::string kind_text(const std::string& kind, const PrintStyle& style) {
    for (const Word known :
         {Word("cues"), Word("looks"), Word("marks"), Word("moments found"), Word("one moment")})
        if (known.in(Language::english) == kind) return style(known);
    return kind;
}

std::string anchor(std::size_t entry) {
    return "e" + std::to_string(entry + 1);
}

std::string title_of(const Book& book, std::size_t place) {
    return html_text(entry_number(book, place)) + html_name(book.entries[place].name);
}

std::string picture_of(const Book& book, const BookEntry& entry, const BookPicture& picture,
                       const PrintStyle& style) {
    return "<figure><img loading=\"lazy\" src=\"" + html_text(picture.file) + "\"" + size_of(book) +
           " alt=\"" + html_text(style("%1 from %2", {entry.name, picture.camera})) + "\"><figcaption>" +
           html_name(picture.camera) + "</figcaption></figure>\n";
}

std::string cell_of(const Book& book, std::size_t index, const PrintStyle& style) {
    const BookEntry& entry = book.entries[index];
    std::string text =
        "<article class=\"entry\" id=\"" + anchor(index) + "\">\n<h2>" + title_of(book, index) + "</h2>\n";
    if (const std::string times = times_text(entry, style); !times.empty())
        text += "<p class=\"of\">" + html_name(times) + "</p>\n";
    text += list_of(entry.unknown, "unknown");
    if (!entry.pictures.empty()) text += picture_of(book, entry, entry.pictures.front(), style);
    return text + "</article>\n";
}

std::string section_of(const Book& book, std::size_t index, const PrintStyle& style) {
    const BookEntry& entry = book.entries[index];
    std::string text =
        "<article class=\"entry\" id=\"" + anchor(index) + "\">\n<h2>" + title_of(book, index) + "</h2>\n";
    if (const std::string times = times_text(entry, style); !times.empty())
        text += "<p class=\"of\">" + html_name(times) + "</p>\n";
    if (!entry.notes.empty()) text += "<p>" + html_name(entry.notes) + "</p>\n";
    text += "<div class=\"pictures\">\n";
    for (const BookPicture& picture : entry.pictures) text += picture_of(book, entry, picture, style);
    text += "</div>\n" + list_of(entry.unknown, "unknown");
    text += changes_of_entry(entry, index == 0, style);
    return text + "<p class=\"pencil\"></p><p class=\"pencil\"></p>\n</article>\n";
}

std::string rows_of(const BookDifference& difference, const PrintStyle& style) {
    std::string text = "<div class=\"table\">\n<table>\n<thead><tr>";
    for (const Word head : {Word("entry"), Word("camera"), Word("difference"), Word("mean"), Word("p99"),
                            Word("largest"), Word("of the picture above 0.1")})
        text += "<th>" + style(head) + "</th>";
    text += "</tr></thead>\n<tbody>\n";
    for (const ComparedPicture& picture : difference.pictures) {
        text += "<tr><td>" + html_name(picture.name) + "</td><td>" + html_name(picture.camera) + "</td>";
        if (const auto& d = picture.difference)
            text += "<td>" + words_of(d->seen, style) + "</td><td class=\"n\">" + style.number(d->mean, 3) +
                    "</td><td class=\"n\">" + style.number(d->p99, 3) + "</td><td class=\"n\">" +
                    style.number(d->max, 3) + "</td><td class=\"n\">" + style.number(100.0 * d->share, 1) +
                    " %</td>";
        else
            text += "<td colspan=\"5\">" + html_name(picture.why_not) + "</td>";
        text += "</tr>\n";
    }
    return text + "</tbody></table>\n</div>\n";
}

std::string slider_of(const Book& book, const ComparedPicture& picture, const PrintStyle& style) {
    const std::string name = style("%1 from %2", {picture.name, picture.camera});
    return "<h3>" + html_name(picture.name) + ", " + html_name(picture.camera) +
           "</h3>\n<div class=\"pictures\">\n<figure>" +
           slider_html({picture.file, style("%1, now", {name}), ""},
                       {picture.old_file, style("%1, before", {name}), ""}, size_of(book),
                       style("how much of the older picture covers %1", {name}), style) +
           "<figcaption>" + style("left: before, right: now") +
           "</figcaption></figure>\n<figure><img loading=\"lazy\" src=\"" + html_text(picture.map_file) +
           "\"" + size_of(book) + " alt=\"" + html_text(style("where %1 differs", {name})) +
           "\"><figcaption>" + style("where they differ: black not at all, yellow most") +
           "</figcaption></figure>\n</div>\n";
}

std::string difference_section(const Book& book, const BookDifference& difference, const PrintStyle& style) {
    std::string text = "<section id=\"difference\">\n<h2>" +
                       style("Since %1", {html_name(difference.old_name)}) + "</h2>\n" +
                       list_of(difference.unknown, "unknown") + "<h3>" + style("Entries") + "</h3>\n";
    const std::string nothing = "<p class=\"of\">" + style("no change") + "</p>\n";
    text += difference.entries.empty() ? nothing : list_of(difference.entries, "");
    text += "<h3>" + style("Fixtures") + "</h3>\n";
    text += difference.fixtures.empty() ? nothing : list_of(difference.fixtures, "");
    text += "<h3>" + style("Pictures") + "</h3>\n";
    text += difference.pictures.empty() ? "<p class=\"of\">" + style("none can be compared") + "</p>\n"
                                        : rows_of(difference, style);
    for (const ComparedPicture& picture : difference.pictures)
        if (!picture.map_file.empty()) text += slider_of(book, picture, style);
    return text + "</section>\n";
}

} // namespace

std::string html_of(const Book& book, const BookDifference* difference, PaperSize paper,
                    const PrintStyle& style, BookLayout layout) {
    std::string page = html_begin(book.show + ": " + style("cue book"), paper, style.language);
    page += "<h1>" + html_name(book.show) + "</h1>\n<p class=\"of\">" +
            style(book.entries.size() == 1 ? Word("Cue book: 1 entry (%1), %2 fixtures.")
                                           : Word("Cue book: %3 entries (%1), %2 fixtures."),
                  {html_text(kind_text(book.kind, style)), std::to_string(book.fixtures.size()),
                   std::to_string(book.entries.size())}) +
            " " +
            style("Pictures of %1 at exposure %2, drawn by %3.",
                  {std::to_string(book.width) + "x" + std::to_string(book.height),
                   style.number(static_cast<double>(book.ev100), 2), html_name(book.device)}) +
            "</p>\n" + list_of(book.unknown, "unknown");
    page += "<nav aria-label=\"" + style("Entries") + "\">\n";
    if (difference) page += "<a href=\"#difference\">" + style("what changed since the older one") + "</a>\n";
    for (std::size_t i = 0; i < book.entries.size(); ++i)
        page += "<a href=\"#" + anchor(i) + "\">" + title_of(book, i) + "</a>\n";
    page += "</nav>\n";
    if (difference) page += difference_section(book, *difference, style);
    const bool is_grid = layout == BookLayout::grid;
    page += is_grid ? "<section class=\"grid\">\n" : "<section>\n";
    for (std::size_t i = 0; i < book.entries.size(); ++i)
        page += is_grid ? cell_of(book, i, style) : section_of(book, i, style);
    page += "</section>\n";
    if (difference) page += slider_script();
    return page + html_end();
}

} // namespace ghost::scene
