"""The chart of a student's methods beside recorded ones, time against error, from the table that build/points prints
(points/README.md): for the page of make study and for that of make showcase."""
import csv
import html
import math

WIDTH, HEIGHT, MARGIN = 640, 430, 74
LEAST = 1e-5  # errors below are drawn at it
COLORS = ["#2a78d6", "#e2703a", "#3f9b5f", "#b0478f", "#8b6fc0", "#a07b2c", "#2f9aa0", "#c24b4b", "#6b7a89", "#4d59c4"]


def scenes_of(table):
    """The rows of each scene, by its title."""
    scenes = {}
    with open(table, encoding="utf-8") as file:
        for row in csv.DictReader(file):
            scenes.setdefault(row["title"], []).append(row)
    return scenes


def is_drawn(point):
    return not point["message"] and 0 < float(point["ms"]) < math.inf and 0 <= float(point["error"]) < math.inf


def words(points):
    """A student's most accurate setting beside ours, in a sentence; "" when nothing of his was drawn."""
    pairs = [(mine, ours) for ours, mine in zip(points[0::2], points[1::2]) if is_drawn(mine)]
    if not pairs:
        return ""
    mine, ours = min(pairs, key=lambda pair: float(pair[0]["error"]))
    says = lambda p: f'{100 * float(p["error"]):.3g} % in {float(p["ms"]):.3g} ms'
    return f'Most accurate: {mine["method"]}, {mine["setting"]}, {says(mine)} (the solution: {says(ours)}).'


def colors(points):
    """A colour for each method."""
    families = {}
    for point in points:
        families.setdefault(point["method"], COLORS[len(families) % len(COLORS)])
    return families


def legend(families):
    rows = (f'<li><svg width="12" height="12" aria-hidden="true"><path d="M1 1h10v10H1z" fill="{color}"/></svg> {html.escape(name)}</li>'
            for name, color in families.items())
    return f'<ul class="legend">{"".join(rows)}</ul>'


def axis(values, start, end):
    low, high = math.log10(min(values)) - 0.1, math.log10(max(values)) + 0.1
    place = lambda value: start + (math.log10(value) - low) / (high - low) * (end - start)
    ticks = [m * 10.0**e for e in range(math.floor(low), math.ceil(high) + 1) for m in (1, 2, 5) if low <= math.log10(m * 10.0**e) <= high]
    return place, ticks


def mark(x, y, color, mine, title):
    shape = (f'<circle cx="{x:.1f}" cy="{y:.1f}" r="6" fill="none" stroke="{color}" stroke-width="2.5"/>' if mine
             else f'<path d="M{x - 4:.1f} {y - 4:.1f}h8v8h-8z" fill="{color}"/>')
    return f"<g>{shape}<title>{html.escape(title)}</title></g>"


def chart(points, families):
    """The points of a scene that were drawn, as SVG: rings are the student's, squares were recorded."""
    points = [p for p in points if is_drawn(p)]
    if not points:
        return ""
    times, errors = [float(p["ms"]) for p in points], [max(float(p["error"]), LEAST) for p in points]
    across, x_ticks = axis(times, MARGIN, WIDTH - 20)
    down, y_ticks = axis(errors, HEIGHT - MARGIN, 20)
    parts = [f'<svg viewBox="0 0 {WIDTH} {HEIGHT}" class="points" role="img" aria-label="time against error" font-size="14" fill="currentColor">']
    for tick in x_ticks:
        parts.append(f'<path d="M{across(tick):.1f} 20V{HEIGHT - MARGIN}" stroke="currentColor" opacity="0.15"/>'
                     f'<text x="{across(tick):.1f}" y="{HEIGHT - MARGIN + 18}" text-anchor="middle">{tick:g}</text>')
    for tick in y_ticks:
        parts.append(f'<path d="M{MARGIN} {down(tick):.1f}H{WIDTH - 20}" stroke="currentColor" opacity="0.15"/>'
                     f'<text x="{MARGIN - 6}" y="{down(tick) + 4:.1f}" text-anchor="end">{100 * tick:g}</text>')
    parts.append(f'<text x="{WIDTH / 2}" y="{HEIGHT - 14}" text-anchor="middle">time of a frame, ms</text>'
                 f'<text transform="translate(14 {HEIGHT / 2}) rotate(-90)" text-anchor="middle">error, %</text>')
    for point, time, error in zip(points, times, errors):
        mine = point["whose"] == "yours"
        title = f'{point["whose"]}: {point["method"]}, {point["setting"]}: {100 * float(point["error"]):.3g} %, {time:.3g} ms'
        parts.append(mark(across(time), down(error), families[point["method"]], mine, title))
    return "".join(parts) + "</svg>"
