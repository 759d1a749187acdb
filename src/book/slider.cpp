// SPDX-License-Identifier: Apache-2.0
#include "book/private/slider.h"

#include "print/html.h"

#include <string_view>

namespace ghost::scene {
namespace {

// What the slider covers is cut away; a page from file:// loads no modules.
constexpr std::string_view kSliderScript = R"(<script>
for (const range of document.querySelectorAll('.slide + input')) {
  const old = range.previousElementSibling.querySelector('.old');
  const cut = () => { old.style.clipPath = 'inset(0 ' + (100 - range.value) + '% 0 0)'; };
  range.addEventListener('input', cut);
  cut();
  const button = range.nextElementSibling;
  let turns = 0;
  button.addEventListener('click', () => {
    clearInterval(turns);
    turns = turns ? 0 : setInterval(() => { range.value = range.value > 50 ? 0 : 100; cut(); }, 500);
    button.setAttribute('aria-pressed', String(turns > 0));
  });
}
</script>
)";

std::string image_html(const SlidPicture& picture, const std::string& size, bool is_covering) {
    return std::string("<img") + (is_covering ? " class=\"old\"" : "") +
           (picture.id.empty() ? "" : " id=\"" + picture.id + "\"") + " loading=\"lazy\" src=\"" +
           html_text(picture.file) + "\"" + size + " alt=\"" + html_text(picture.alt) + "\">";
}

} // namespace

std::string slider_html(const SlidPicture& covered, const SlidPicture& covering, const std::string& size,
                        const std::string& label, const PrintStyle& style) {
    return "<div class=\"slide\">" + image_html(covered, size, false) + image_html(covering, size, true) +
           "</div><input type=\"range\" min=\"0\" max=\"100\" value=\"50\" aria-label=\"" + html_text(label) +
           "\"><button type=\"button\" aria-pressed=\"false\">" + style("By turns") + "</button>";
}

std::string size_of(const Book& book) {
    return " width=\"" + std::to_string(book.width) + "\" height=\"" + std::to_string(book.height) + "\"";
}

std::string slider_script() {
    return std::string(kSliderScript);
}

} // namespace ghost::scene
