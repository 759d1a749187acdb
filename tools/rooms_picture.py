# SPDX-License-Identifier: Apache-2.0
"""The rooms of src/ as a picture: what stands higher links what stands below it. A line is drawn where no other way says the same."""
from html import escape

BOX_W, BOX_H, GAP_X, GAP_Y, MARGIN = 150, 40, 14, 34, 20
MOST_IN_ROW = 8
COLOURS = {"ui": "#dbe7ff", "cli": "#ffe9d6", "bench": "#ffe9d6", "farm": "#ffe9d6", "live": "#e4dbff", "render": "#d9f2e3", "gpu": "#d9f2e3",
           "bake": "#d9f2e3", "trace": "#d9f2e3", "reference": "#d9f2e3", "dmx": "#fff6cc", "net": "#fff6cc", "rdm": "#fff6cc",
           "xchange": "#fff6cc"}


def reduced(rooms):
    """Room -> the links that do not follow from its others."""
    below = {}
    for name, (links, _) in rooms.items():
        below[name] = set(links).union(*(below[link] for link in links)) if links else set()
    return {name: [link for link in links if not any(link in below[other] for other in links)] for name, (links, _) in rooms.items()}


def rows_of(rooms, links):
    """Rows of rooms, lowest first: each as low as what it links allows, no row longer than a page is wide."""
    row_of, rows = {}, []
    for name in rooms:
        row = 1 + max((row_of[link] for link in links[name]), default=-1)
        while row < len(rows) and len(rows[row]) >= MOST_IN_ROW:
            row += 1
        if row == len(rows):
            rows.append([])
        rows[row].append(name)
        row_of[name] = row
    for row in rows[1:]:  # near what it stands on
        row.sort(key=lambda name: sum(rows[row_of[link]].index(link) / len(rows[row_of[link]]) for link in links[name]) / max(len(links[name]), 1))
    return rows


def draw(rooms):
    """rooms: name -> (links, purpose). The text of an SVG."""
    links = reduced(rooms)
    rows = rows_of(rooms, links)
    width = MOST_IN_ROW * (BOX_W + GAP_X) - GAP_X + 2 * MARGIN
    height = len(rows) * (BOX_H + GAP_Y) - GAP_Y + 2 * MARGIN
    places = {}
    for number, row in enumerate(rows):
        left = (width - len(row) * (BOX_W + GAP_X) + GAP_X) / 2
        for k, name in enumerate(row):
            places[name] = (left + k * (BOX_W + GAP_X), height - MARGIN - BOX_H - number * (BOX_H + GAP_Y))
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif">',
           f'<rect width="{width}" height="{height}" fill="white"/>']
    for name, targets in links.items():
        x, y = places[name]
        for target in targets:
            tx, ty = places[target]
            middle = (y + BOX_H + ty) / 2
            out.append(f'<path d="M{x + BOX_W / 2:.0f} {y + BOX_H:.0f} C{x + BOX_W / 2:.0f} {middle:.0f} {tx + BOX_W / 2:.0f} {middle:.0f} '
                       f'{tx + BOX_W / 2:.0f} {ty:.0f}" fill="none" stroke="#8a8f98" stroke-width="1"/>')
    for name, (x, y) in places.items():
        colour = COLOURS.get(name.split("/")[0], "#eef0f3")
        out.append(f'<g><title>{escape(rooms[name][1])}</title><rect x="{x:.0f}" y="{y:.0f}" width="{BOX_W}" height="{BOX_H}" rx="5" fill="{colour}" '
                   f'stroke="#555b66"/><text x="{x + BOX_W / 2:.0f}" y="{y + 25:.0f}" font-size="13" text-anchor="middle">{escape(name)}</text></g>')
    return "\n".join(out + ["</svg>", ""])


def table(rooms):
    """The same as a table of Markdown."""
    rows = [f"| `src/{name}` | {purpose} | {' '.join(links)} |" for name, (links, purpose) in rooms.items()]
    return "\n".join(["# The rooms of src/, lowest first", "", "![](rooms.svg)", "", "| room | what it is for | links |", "|---|---|---|", *rows, ""])
