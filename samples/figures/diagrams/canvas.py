# SPDX-License-Identifier: Apache-2.0
"""A canvas for SVG figures, with the palette, the line widths and the type sizes that all figures share.

Points are complex numbers in pixels: x points right, y points down. A color is the name of a role in PALETTE, and is
written as a CSS class, so that a figure follows the light or the dark mode of its reader.
"""
import re
from xml.sax.saxutils import escape

WIDTH = 840  # of every figure, which is the width of a column of text, so that texts have the same size in all figures
MARGIN = 24  # empty space around the content of a figure

# Line widths.
FILM = 2.5
THIN = 1.25
DASH = "5 4"

# Type sizes. Every text has one of these two sizes.
LABEL = 16
NOTE = 13
SUBSCRIPT = 0.72  # size of a subscript, as a fraction of the size of the text

ARROW_HEAD = 10  # length of an arrow head

# Each role has a color for the light mode and a color for the dark mode.
PALETTE = {
    "card": ("#ffffff", "#161b22"),
    "border": ("#d0d7de", "#30363d"),
    "ink": ("#1f2328", "#e6edf3"),
    "muted": ("#59636e", "#9da7b3"),
    "faint": ("#c3cad1", "#4a525c"),
    "neutral": ("#f1f3f5", "#21262d"),
    "blue": ("#0a5fbf", "#79b8ff"),
    "orange": ("#bc4c00", "#ffa657"),
    "green": ("#1a7f37", "#56d364"),
    "pink": ("#a8327a", "#f48fc6"),
    "blue-tint": ("#d6e8fc", "#16345a"),
    "orange-tint": ("#fde5cc", "#45301c"),
    "green-tint": ("#d4f0db", "#17412a"),
    "pink-tint": ("#f8dcea", "#4e2540"),
}


def number(value):
    """Returns a number with at most two decimals."""
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def pair(point):
    return f"{number(point.real)} {number(point.imag)}"


def polyline(points, closed=False):
    """Returns the path data of straight lines through points."""
    return "M" + "L".join(pair(point) for point in points) + ("Z" if closed else "")


class Canvas:
    """Collects the elements of one figure."""

    def __init__(self, height, title, description):
        self.height = height
        self.title = title
        self.description = description
        self.elements = []
        self.roles = set()
        self.rect(0.5 + 0.5j, WIDTH - 1, height - 1, fill="card", stroke="border", width=1, radius=8)

    def color(self, fill, stroke):
        """Returns the attribute with the classes of a fill and a stroke."""
        names = [f"{kind}-{role}" for kind, role in (("f", fill), ("s", stroke)) if role]
        self.roles.update(names)
        return f'class="{" ".join(names)}"'

    def shape(self, element, fill=None, stroke=None, width=FILM, dash=None, clip=None):
        """Adds an element. `element` is its name followed by its geometric attributes."""
        attributes = [element, self.color(fill, stroke)]
        if stroke:
            attributes.append(f'stroke-width="{number(width)}"')
        if dash:
            attributes.append(f'stroke-dasharray="{dash}"')
        if clip:
            attributes.append(f'clip-path="url(#{clip})"')
        self.elements.append(f"<{' '.join(attributes)}/>")

    def path(self, data, **style):
        self.shape(f'path d="{data}"', **style)

    def line(self, a, b, stroke="ink", **style):
        self.path(polyline([a, b]), stroke=stroke, **style)

    def circle(self, center, radius, **style):
        self.shape(f'circle cx="{number(center.real)}" cy="{number(center.imag)}" r="{number(radius)}"', **style)

    def dot(self, center, color="ink", radius=4):
        self.circle(center, radius, fill=color)

    def rect(self, corner, width_of, height_of, radius=0, **style):
        place = f'x="{number(corner.real)}" y="{number(corner.imag)}"'
        size = f'width="{number(width_of)}" height="{number(height_of)}"'
        self.shape(f'rect {place} {size} rx="{number(radius)}"', **style)

    def arrow_head(self, tip, direction, color="ink", length=ARROW_HEAD):
        """Draws an arrow head at `tip` that points along `direction`."""
        along = length * direction / abs(direction)
        side = 0.38j * along
        self.path(polyline([tip, tip - along + side, tip - 0.75 * along, tip - along - side], closed=True), fill=color)

    def arrow(self, a, b, color="ink", both=False, **style):
        """Draws a straight arrow from a to b, or with a head at each end."""
        inset = 0.75 * ARROW_HEAD * (b - a) / abs(b - a)
        self.line(a + inset if both else a, b - inset, stroke=color, **{"width": THIN, **style})
        self.arrow_head(b, b - a, color)
        if both:
            self.arrow_head(a, a - b, color)

    def text(self, at, markup, size=LABEL, anchor="middle", color="ink", bold=False):
        """Writes a line of text. Its vertical middle is at `at`.

        *word* is italic, for symbols. x_{word} is a subscript.
        """
        baseline = at + 0.35j * size
        weight = ' font-weight="600"' if bold else ""
        self.elements.append(
            f'<text x="{number(baseline.real)}" y="{number(baseline.imag)}" font-size="{size}" '
            f'text-anchor="{anchor}"{weight} {self.color(color, None)}>{spans(markup, size)}</text>')

    def lines(self, at, texts, size=NOTE, spacing=18, **style):
        """Writes lines of text below each other. The vertical middle of the first line is at `at`."""
        for index, text in enumerate(texts):
            self.text(at + 1j * index * spacing, text, size=size, **style)

    def clip_circle(self, name, center, radius):
        """Defines a circle for the argument `clip` of other elements."""
        self.elements.append(f'<clipPath id="{name}"><circle cx="{number(center.real)}" cy="{number(center.imag)}" '
                             f'r="{number(radius)}"/></clipPath>')

    def clip_rect(self, name, corner, width_of, height_of):
        """Defines a rectangle for the argument `clip` of other elements."""
        self.elements.append(f'<clipPath id="{name}"><rect x="{number(corner.real)}" y="{number(corner.imag)}" '
                             f'width="{number(width_of)}" height="{number(height_of)}"/></clipPath>')

    def style_sheet(self):
        """Returns the CSS rules of the colors in use, for the light and for the dark mode."""
        def rules(mode):
            return "".join(f".{name}{{{'fill' if name[0] == 'f' else 'stroke'}:{PALETTE[name[2:]][mode]}}}"
                           for name in sorted(self.roles))

        return f"{rules(0)}\n@media (prefers-color-scheme:dark){{{rules(1)}}}"

    def svg(self):
        """Returns the text of the figure."""
        size = f'viewBox="0 0 {WIDTH} {number(self.height)}" width="{WIDTH}" height="{number(self.height)}"'
        head = (f'<svg xmlns="http://www.w3.org/2000/svg" {size} role="img" aria-labelledby="title desc" '
                'fill="none" stroke-linecap="round" stroke-linejoin="round" font-family="sans-serif">')
        return "\n".join([head,
                          f'<title id="title">{escape(self.title)}</title>',
                          f'<desc id="desc">{escape(self.description)}</desc>',
                          f"<style>\n{self.style_sheet()}\n</style>",
                          *self.elements,
                          "</svg>\n"])


def spans(markup, size):
    """Returns the SVG of a text with *italics* and subscripts_{like this}."""
    result, lowered = [], False
    for part in re.split(r"(\*[^*]+\*|_\{[^}]*\})", markup):
        if not part:
            continue
        is_subscript = part.startswith("_{")
        is_italic = part.startswith("*") and len(part) > 1
        content = part[2:-1] if is_subscript else part[1:-1] if is_italic else part
        result.append(span(content, size, is_italic, is_subscript, lowered))
        lowered = is_subscript
    return "".join(result)


def span(content, size, is_italic, is_subscript, is_after_subscript):
    attributes = ""
    if is_italic:
        attributes += ' font-style="italic"'
    if is_subscript:
        attributes += f' font-size="{number(SUBSCRIPT * size)}" dy="{number(0.25 * size)}"'
    elif is_after_subscript:
        attributes += f' dy="{number(-0.25 * size)}"'
    text = escape(content)
    return f"<tspan{attributes}>{text}</tspan>" if attributes else text
