// SPDX-License-Identifier: Apache-2.0
#include "book/tour_html.h"

#include "book/private/slider.h"
#include "print/html.h"

#include <string_view>

namespace ghost::scene {
namespace {

// Puts the chosen looks under the slider.
constexpr std::string_view kChoiceScript = R"(<script>
const by = id => document.getElementById(id);
const put = side => {
  const look = by('look-' + side).selectedOptions[0], camera = by('camera');
  by(side).src = look.dataset.files.split(' ')[camera ? camera.selectedIndex : 0];
  by(side).alt = look.textContent;
};
for (const select of document.querySelectorAll('.chosen select'))
  select.addEventListener('change', () => { put('left'); put('right'); });
</script>
)";

std::string files_of(const BookEntry& entry) {
    std::string files;
    for (const BookPicture& picture : entry.pictures) files += (files.empty() ? "" : " ") + picture.file;
    return files;
}

std::string look_choice(const Book& book, const std::string& label, const std::string& id,
                        std::size_t chosen) {
    std::string text = "<label>" + label + "<br><select id=\"" + id + "\">\n";
    for (std::size_t i = 0; i < book.entries.size(); ++i)
        text += "<option data-files=\"" + html_text(files_of(book.entries[i])) + "\"" +
                (i == chosen ? " selected" : "") + ">" + html_text(book.entries[i].name) + "</option>\n";
    return text + "</select></label>\n";
}

std::string looks_section(const Book& book, const PrintStyle& style) {
    const std::size_t second = book.entries.size() > 1 ? 1 : 0;
    const BookEntry &left = book.entries[0], &right = book.entries[second];
    std::string text = "<section id=\"looks\">\n<h2>" + style("Looks") + "</h2>\n<div class=\"chosen\">\n" +
                       look_choice(book, style("left"), "look-left", 0) +
                       look_choice(book, style("right"), "look-right", second);
    if (left.pictures.size() > 1) {
        text += "<label>" + style("camera") + "<br><select id=\"camera\">\n";
        for (const BookPicture& picture : left.pictures)
            text += "<option>" + html_text(picture.camera) + "</option>\n";
        text += "</select></label>\n";
    }
    text +=
        "</div>\n<div class=\"pictures wide\">\n<figure>" +
        slider_html({right.pictures[0].file, right.name, "right"}, {left.pictures[0].file, left.name, "left"},
                    size_of(book), style("how much of the left picture covers the right one"), style) +
        "</figure>\n</div>\n";
    return text + "</section>\n";
}

std::string gallery(const Book& book, const PrintStyle& style) {
    std::string text = "<section id=\"all\">\n<h2>" + style("All looks") + "</h2>\n";
    for (const BookEntry& entry : book.entries) {
        text += "<article class=\"entry\">\n<h3>" + html_name(entry.name) + "</h3>\n";
        if (!entry.notes.empty()) text += "<p>" + html_name(entry.notes) + "</p>\n";
        text += "<div class=\"pictures\">\n";
        for (const BookPicture& picture : entry.pictures)
            text += "<figure><img loading=\"lazy\" src=\"" + html_text(picture.file) + "\"" + size_of(book) +
                    " alt=\"" + html_text(style("%1 from %2", {entry.name, picture.camera})) +
                    "\"><figcaption>" + html_name(picture.camera) + "</figcaption></figure>\n";
        text += "</div>\n</article>\n";
    }
    return text + "</section>\n";
}

std::string versions(const Book& book, const BookDifference& difference, const PrintStyle& style) {
    std::string text =
        "<section id=\"since\">\n<h2>" + style("Since %1", {html_name(difference.old_name)}) + "</h2>\n";
    for (const std::string& sentence : difference.unknown)
        text += "<p class=\"unknown\">" + html_name(sentence) + "</p>\n";
    bool has_any = false;
    for (const ComparedPicture& picture : difference.pictures) {
        if (picture.map_file.empty()) continue;
        has_any = true;
        const std::string name = style("%1 from %2", {picture.name, picture.camera});
        text += "<h3>" + html_name(name) + "</h3>\n<div class=\"pictures wide\">\n<figure>" +
                slider_html({picture.file, style("%1, now", {name}), ""},
                            {picture.old_file, style("%1, before", {name}), ""}, size_of(book), name, style) +
                "<figcaption>" + style("left: before, right: now") + "</figcaption></figure>\n</div>\n";
    }
    if (!has_any) text += "<p class=\"of\">" + style("no picture differs") + "</p>\n";
    return text + "</section>\n";
}

} // namespace

Book for_client(Book book, bool has_notes) {
    book.is_for_client = true;
    book.fixtures.clear();
    for (BookEntry& entry : book.entries) {
        entry.changes.clear();
        entry.unknown.clear();
        if (!has_notes) entry.notes.clear();
    }
    return book;
}

std::string tour_html(const Book& book, const BookDifference* difference, const TourPage& page) {
    const std::string title = page.title.empty() ? book.show : page.title;
    std::string text = html_begin(title, PaperSize::a4, page.style.language);
    text += "<h1>" + html_name(title) + "</h1>\n";
    if (!page.note.empty()) text += "<p>" + html_name(page.note) + "</p>\n";
    for (const std::string& sentence : book.unknown)
        text += "<p class=\"unknown\">" + html_name(sentence) + "</p>\n";
    if (!book.entries.empty()) text += looks_section(book, page.style);
    if (!page.film.empty())
        text += "<section id=\"film\">\n<h2>" + page.style("Film") + "</h2>\n<video controls src=\"" +
                html_text(page.film) + "\"" + size_of(book) + "></video>\n</section>\n";
    if (difference) text += versions(book, *difference, page.style);
    text += gallery(book, page.style);
    return text + slider_script() + (book.entries.empty() ? "" : std::string(kChoiceScript)) + html_end();
}

} // namespace ghost::scene
