// SPDX-License-Identifier: Apache-2.0
#include "print/html.h"

#include "base/print.h"

namespace ghost::scene {
namespace {

// No request leaves the page, whatever a name holds.
constexpr std::string_view kHead = R"(<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src 'self' file:; media-src 'self' file:; style-src 'unsafe-inline'; script-src 'unsafe-inline'">
)";

constexpr std::string_view kStyle = R"(:root{color-scheme:light}
body{font:16px/1.45 system-ui,sans-serif;color:#1a1a1a;background:#fff;margin:1.5rem auto;max-width:72rem;padding:0 1rem;overflow-wrap:anywhere}
h1{font-size:1.7rem;margin:0 0 .3rem}h2{font-size:1.25rem;margin:0}h3{font-size:1rem;margin:.6rem 0 .2rem}
p{margin:.2rem 0}ul{margin:.3rem 0;padding-left:1.2rem}.of{color:#555}.unknown{color:#8a3b00}
nav{margin:.8rem 0;columns:14rem}nav a{display:block;color:#0b5394}
.entry{border-top:2px solid #1a1a1a;padding:.7rem 0 1rem;break-inside:avoid}
.pictures{display:flex;flex-wrap:wrap;gap:.6rem;margin:.5rem 0}figure{margin:0;flex:1 1 20rem;max-width:40rem}
img{display:block;width:100%;height:auto;background:#000}figcaption{color:#555;font-size:.85rem}
.pencil{display:none}
.grid{display:grid;grid-template-columns:repeat(auto-fill,minmax(14rem,1fr));gap:0 .8rem}.grid h2{font-size:1rem}
.wide figure{max-width:none;flex-basis:100%}.chosen{display:flex;flex-wrap:wrap;gap:1rem;margin:.6rem 0}
.chosen label{min-width:0;max-width:100%}.chosen select{font:inherit;min-height:44px;max-width:100%}video{display:block;width:100%;height:auto;background:#000}
.slide{position:relative}.slide .old{position:absolute;inset:0}.slide+input{width:100%;height:44px;margin:0}
button{font:inherit;color:inherit;background:none;border:1px solid;border-radius:4px;min-height:44px;padding:0 1em}button[aria-pressed=true]{border-width:3px}
.table{overflow-x:auto;margin:.4rem 0 1rem}table{border-collapse:collapse;width:100%;font-size:.85rem}thead{display:table-header-group}
th,td{border:1px solid #999;padding:.15rem .4rem;text-align:left;vertical-align:top;overflow-wrap:break-word}
th{background:#eee;white-space:nowrap}td{max-width:16rem}.w{white-space:nowrap}
.n{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}.free td{background:#f3f7f0;color:#3b5b22}
section{margin:1.2rem 0}
@media print{body{font-size:9.5pt;margin:0;max-width:none;padding:0}.table{overflow:visible}table{font-size:7.5pt}td{max-width:8rem}nav{display:none}section+section{break-before:page}
tr{break-inside:avoid}.slide .old,.slide+input,button{display:none}figure{flex-basis:0;max-width:47%}
.grid{grid-template-columns:repeat(3,1fr)}.grid figure{max-width:none}.grid .entry{padding:2mm 0;min-height:54mm}
.pencil{display:block;border-bottom:1px solid #999;height:1.6em}}
)";

} // namespace

std::string html_text(std::string_view text) {
    std::string result;
    for (const char letter : one_line(text)) {
        if (letter == '&')
            result += "&amp;";
        else if (letter == '<')
            result += "&lt;";
        else if (letter == '>')
            result += "&gt;";
        else if (letter == '"')
            result += "&quot;";
        else if (letter == '\'')
            result += "&#39;";
        else
            result += letter;
    }
    return result;
}

std::string html_name(std::string_view name) {
    return "<bdi>" + html_text(name) + "</bdi>";
}

std::string html_begin(std::string_view title, PaperSize paper, Language language, bool is_wide) {
    std::string page = std::string("<!doctype html>\n<html lang=\"") +
                       (language == Language::english ? "en" : "de") + "\">\n<head>\n";
    page += kHead;
    page += "<title>" + html_text(title) + "</title>\n<style>\n";
    page += kStyle;
    page += "@page{size:" + std::string(format_of(paper).name) + (is_wide ? " landscape" : "") +
            ";margin:" + (is_wide ? "10mm" : "14mm") + "}\n";
    page += "</style>\n</head>\n<body>\n";
    return page;
}

std::string html_end() {
    return "</body>\n</html>\n";
}

} // namespace ghost::scene
