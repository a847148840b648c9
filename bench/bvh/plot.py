#!/usr/bin/env python3
"""Draws the results of bench/run --bvh as SVG: how the trees compare on every scene, and how their cost grows.

usage: bench/bvh/plot.py RESULTS.json FOLDER
"""

import json
import math
import pathlib
import sys
from xml.sax.saxutils import escape

sys.dont_write_bytecode = True  # no folder of compiled modules among the sources
import tables

OURS, PEERS = ("#b5453c", "#dd8f6e"), ("#5f6b78", "#9aa5b1")


def text(x, y, content, anchor="start", size=11):
    return (f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" font-family="sans-serif" text-anchor="{anchor}" '
            f'fill="#222">{escape(content)}</text>')


def svg(width, height, elements):
    return "\n".join([f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height:.0f}">',
                      '<rect width="100%" height="100%" fill="#fff"/>', *elements, "</svg>\n"])


def color(name, position):
    return (OURS if name.startswith("raio") else PEERS)[position % 2]


def rates_chart(measured):
    """A bar for every tree, a group for every scene and kind of rays."""
    trees = ("raio", "raio_high", "embree_avx2", "embree_high_avx2", "embree_robust_avx2")
    left, bar, gap, width = 190, 10, 12, 760
    rates = {(scene, rays, tree): tables.millions(measured, "triangles", scene, rays, tree)
             for scene in tables.SCENES for rays in tables.RAYS for tree in trees}
    longest = max(rate for rate in rates.values() if rate)
    elements, y = [text(8, 24, "million rays per second, one thread", size=14)], 34
    for scene in tables.SCENES:
        for rays in tables.RAYS:
            if not rates[scene, rays, "raio"]:
                continue
            y += gap
            elements.append(text(8, y + 3 * bar, f"{scene}, {rays}"))
            for position, tree in enumerate(trees):
                rate = rates[scene, rays, tree] or 0
                length = rate / longest * (width - left - 170)
                elements.append(f'<rect x="{left}" y="{y}" width="{length:.1f}" height="{bar - 1}" '
                                f'fill="{color(tree, position)}"/>')
                elements.append(text(left + length + 5, y + bar - 2, f"{rate:.3g} {tree}", size=9))
                y += bar
    return svg(width, y + gap, elements)


def growth_chart(measured, titles):
    """Rates over the number of triangles, both on logarithmic axes; one panel for every (what, title)."""
    sizes = tables.names(measured, "growth", 1)
    trees = tables.names(measured, "growth", 3)
    panel, height, margin = 300, 300, 50
    elements = [text(8, 24, "a bumpy sphere of 1,000 to 10,000,000 triangles", size=14)]
    for number, (what, title) in enumerate(titles):
        points = {tree: [(math.log10(int(size)), math.log10(rate)) for size in sizes
                         if (rate := tables.millions(measured, "growth", size, what, tree))] for tree in trees}
        low = math.floor(min(y for line in points.values() for _, y in line))
        high = math.ceil(max(y for line in points.values() for _, y in line))
        x0, y0 = margin + number * (panel + margin), 50

        def place(x, y):
            return x0 + (x - 3) / 4 * panel, y0 + (high - y) / (high - low) * height
        elements.append(text(x0, y0 - 8, title, size=12))
        for power in range(low, high + 1):
            x, y = place(3, power)
            elements.append(f'<line x1="{x}" y1="{y:.1f}" x2="{x + panel}" y2="{y:.1f}" stroke="#ddd"/>')
            elements.append(text(x - 6, y + 4, f"{10.0 ** power:g}", "end"))
        for power in range(3, 8):
            elements.append(text(place(power, low)[0], y0 + height + 16, f"1e{power}", "middle"))
        for tree, line in points.items():
            path = " ".join(f"{x:.1f},{y:.1f}" for x, y in (place(*point) for point in line))
            elements.append(f'<polyline points="{path}" fill="none" stroke="{color(tree, 0)}" stroke-width="2"/>')
            elements.append(text(*place(*line[0]), tree))
    return svg(len(titles) * (panel + margin) + 2 * margin, height + 90, elements)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    measured = tables.medians(json.loads(pathlib.Path(sys.argv[1]).read_text()))
    charts = {"bvh.svg": rates_chart(measured),
              "growth.svg": growth_chart(measured, (("primary", "million primary rays per second"),
                                                    ("bounce", "million bounced rays per second"),
                                                    ("build", "million triangles built per second")))}
    for name, chart in charts.items():
        path = pathlib.Path(sys.argv[2]) / name
        path.write_text(chart)
        print(path)


if __name__ == "__main__":
    main()
