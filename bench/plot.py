#!/usr/bin/env python3
"""Draws the results of bench/run as SVG: for every shape a bar for each call, one picture for each number type.

usage: bench/plot.py RESULTS.json FOLDER
"""

import json
import pathlib
import sys
from xml.sax.saxutils import escape

sys.dont_write_bytecode = True  # no folder of compiled modules among the sources
import tables

LEFT, BAR, GAP, WIDTH = 250, 14, 14, 760
COLORS = {"hit": "#b5453c", "record_hit": "#c9756d", "occluded": "#dd8f6e", "quick_hit": "#3d7a8a",
          "quick_occluded": "#8fb9c2", "hit_in_packs": "#7d2f55", "occluded_in_packs": "#b07a98"}
PEER = "#9aa5b1"


def text(x, y, content, anchor="start", size=11):
    return (f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" font-family="sans-serif" text-anchor="{anchor}" '
            f'fill="#222">{escape(content)}</text>')


def chart(measured, number, percent):
    rows = [(shape, call, measured[shape, call, number, percent][0])
            for shape in dict.fromkeys(key[0] for key in measured)
            for call in tables.calls(measured, shape) if (shape, call, number, percent) in measured]
    elements, y, last_shape, longest = [], 34.0, None, 1.0
    for shape, call, nanoseconds in rows:
        if shape != last_shape:
            y += GAP
            elements.append(text(8, y + BAR - 3, shape, size=12))
            longest = max(ns for other, _, ns in rows if other == shape)
            last_shape = shape
        length = nanoseconds / longest * (WIDTH - LEFT - 60)
        elements.append(text(LEFT - 6, y + BAR - 3, call, "end"))
        elements.append(f'<rect x="{LEFT}" y="{y:.1f}" width="{length:.1f}" height="{BAR - 2}" '
                        f'fill="{COLORS.get(call, PEER)}"/>')
        elements.append(text(LEFT + length + 5, y + BAR - 3, tables.shown(nanoseconds)))
        y += BAR
    title = f"ns per test, {number}, {percent} % hits; each shape has its own scale"
    height = y + GAP
    return "\n".join([f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{height:.0f}">',
                      '<rect width="100%" height="100%" fill="#fff"/>', text(8, 24, title, size=14), *elements,
                      "</svg>\n"])


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    measured = tables.medians(json.loads(pathlib.Path(sys.argv[1]).read_text()))
    for number in tables.NUMBERS:
        path = pathlib.Path(sys.argv[2]) / f"{number}.svg"
        path.write_text(chart(measured, number, "50"))
        print(path)


if __name__ == "__main__":
    main()
