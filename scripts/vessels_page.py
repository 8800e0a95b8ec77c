# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the docs' page of the vessels' figures.

PYTHONPATH=build/release/python:samples python3 scripts/vessels_page.py FOLDER NAME ...

of what draw_vessels.py left in FOLDER/NAME/: small copies in docs/images/vessels, and
docs/vessels.md of all vessels that have copies.
"""

import sys
from pathlib import Path

import hull_native as hn
import vessels
from figures import paper
from hull_native.drawings.figure_form import FigureForm

DOCS = vessels.ROOT / "docs"
IMAGES = DOCS / "images" / "vessels"
# Name, width of the small copy in dots, what it shows.
FIGURES = {
    "rendering": (600, "{} with sections and waterlines"),
    "reflection": (600, "Reflection lines of {}, from ahead and from astern"),
    "control_mesh": (600, "Control mesh of {}: creases bold, hidden edges faded"),
    "lines_plan": (960, "Lines plan of {}"),
    "sections_plan": (600, "Sections plan of {}"),
}
HEAD = """# The sample vessels

Each is one control mesh, `samples/NAME.hull.json`; `samples/sources/NAME.py` makes it and tells why
its points are where they are. `./hull figures [NAME...]` makes these pictures, as PNG and PDF in
`out/figures/NAME`, and this page. *Reflection*: the hull as a mirror of light lines along the ship;
where a band runs smooth, so does the surface. `./hull fairness` counts what is not fair on their
lines: [fairness.md](fairness.md#what-is-seen).
"""


def finish(name, folder):
    """Small copies of all figures."""
    IMAGES.mkdir(parents=True, exist_ok=True)
    for figure, (width, _) in FIGURES.items():
        made = folder / f"{name}-{figure.replace('_', '-')}.png"
        paper.make_small(made, IMAGES / f"{name}_{figure}.png", width)


def particulars(vessel):
    """Pairs (name, text) of a vessel's main dimensions and what it displaces."""
    given = vessel.data.particulars
    body = hn.HullBody(vessel.surface, mirrored=vessel.data.half)
    dimensions = given.length_pp, given.beam, given.draft, given.depth
    return FigureForm(body, vessel.data.name, *dimensions).particulars()


def section(vessel):
    """The page's part on a vessel."""
    data, name = vessel.data, vessel.name
    counts = f"{len(data.points)} control points" + (" to one side" if data.half else "")
    table = [("Control mesh", f"{counts}, {len(data.faces)} faces")]
    lines = [f"## {data.name}", "", f"`{name}`: {data.source}.", "", "| | |", "|---|---|"]
    lines += [f"| {label} | {text} |" for label, text in particulars(vessel) + table]
    features = getattr(vessel.source, "FEATURES", {})
    if features:
        lines += ["", *(f"- *{feature}*: {how}" for feature, how in features.items())]
    for figure, (_, caption) in FIGURES.items():
        alt = caption.format(data.name)
        lines += ["", f"![{alt}](images/vessels/{name}_{figure}.png)"]
    return "\n".join(lines)


def main():
    folder, *names = sys.argv[1:]
    for name in names:
        finish(name, Path(folder) / name)
    shown = [name for name in vessels.names() if (IMAGES / f"{name}_rendering.png").exists()]
    parts = [HEAD, *(section(vessels.vessel(name)) + "\n" for name in shown)]
    (DOCS / "vessels.md").write_text("\n".join(parts), encoding="utf-8")


if __name__ == "__main__":
    main()
