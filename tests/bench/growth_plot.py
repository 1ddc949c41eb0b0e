#!/usr/bin/env python3
"""Draws docs/performance/growth.svg from the JSON of `make bench BENCH=growth`: the time of a picture against what the scene
has more of, both on logarithmic axes.

usage: tests/bench/growth_plot.py build/bench.json >docs/performance/growth.svg
"""
import json
import math
import sys
from xml.sax.saxutils import escape

THINGS = ["vertices", "lights", "pixels", "draws"]
COLORS = {"fixed": "#b35900", "shaders": "#0066b3", "reference": "#2a7f2a", "compare": "#7a3b8f"}
WIDTH, HEIGHT, LEFT, TOP = 190, 190, 46, 30  # of a panel, and of its margin


def series(seconds):
    """{thing: {way: [(count, seconds)]}}"""
    found = {thing: {} for thing in THINGS}
    for key, value in seconds.items():
        title, way = key.split(": ")
        count, thing = title.split(" ")
        found[thing].setdefault(way, []).append((int(count), value))
    return found


def panel(thing, ways, x0):
    points = [point for line in ways.values() for point in line]
    x_low, x_high = (f(math.log10(count) for count, _ in points) for f in (min, max))
    y_low, y_high = -4, 1  # 0.1 ms to 10 s

    def place(count, seconds):
        x = (math.log10(count) - x_low) / (x_high - x_low)
        y = (math.log10(seconds) - y_low) / (y_high - y_low)
        return f"{x0 + WIDTH * x:.1f},{TOP + HEIGHT * (1 - y):.1f}"

    yield f'<text x="{x0 + WIDTH / 2}" y="18" text-anchor="middle" font-weight="bold">{escape(thing)}</text>'
    for decade in range(y_low, y_high + 1):
        y = TOP + HEIGHT * (y_high - decade) / (y_high - y_low)
        yield f'<path d="M{x0},{y:.1f}h{WIDTH}" stroke="#8888" stroke-width="0.5"/>'
        name = f"{10 ** (decade + 3):g} ms" if decade < 0 else f"{10 ** decade:g} s"
        if x0 == LEFT:
            yield f'<text x="{x0 - 4}" y="{y + 4:.1f}" text-anchor="end">{name}</text>'
    for decade in range(math.ceil(x_low), math.floor(x_high) + 1):
        x = x0 + WIDTH * (decade - x_low) / (x_high - x_low)
        yield f'<text x="{x:.1f}" y="{TOP + HEIGHT + 15}" text-anchor="middle">10<tspan dy="-4" font-size="8">{decade}</tspan></text>'
    for way, line in ways.items():
        path = " ".join(place(*point) for point in sorted(line))
        yield f'<polyline points="{path}" fill="none" stroke="{COLORS[way]}" stroke-width="2"/>'


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        found = series(json.load(file)["seconds"])
    width, height = LEFT + len(THINGS) * (WIDTH + 28), TOP + HEIGHT + 50
    print(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="11">')
    print(f'<rect width="{width}" height="{height}" fill="#fff"/>')
    for i, thing in enumerate(THINGS):
        print("\n".join(panel(thing, found[thing], LEFT + i * (WIDTH + 28))))
    for i, (way, color) in enumerate(COLORS.items()):
        x, y = LEFT + i * 140, height - 10
        print(f'<path d="M{x},{y - 4}h24" stroke="{color}" stroke-width="2"/><text x="{x + 30}" y="{y}">{way}</text>')
    print("</svg>")


if __name__ == "__main__":
    main()
