# SPDX-License-Identifier: GPL-3.0-or-later
"""Puts the vessels' pictures together, and makes the docs' page of them.

PYTHONPATH=build/release/python:samples python3 scripts/vessels_page.py FOLDER NAME ...

of what draw_vessels.py and picture_vessels.py left in FOLDER/NAME/: PDFs of the pictures there,
small copies of all in docs/images/vessels, and docs/vessels.md of all vessels that have copies.
"""

import sys
from pathlib import Path

import vessels
from figures import lines_plan, paper

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
    """PDFs of the pictures and small copies of all figures."""
    for picture in ("rendering", "reflection"):
        views = [folder / f"{picture}_{view}.png" for view in ("bow", "stern")]
        paper.put_below(views, folder / f"{picture}.png")
        for view in views:
            view.unlink()
        paper.picture_to_pdf(folder / f"{picture}.png", folder / f"{picture}.pdf")
    IMAGES.mkdir(parents=True, exist_ok=True)
    for figure, (width, _) in FIGURES.items():
        paper.make_small(folder / f"{figure}.png", IMAGES / f"{name}_{figure}.png", width)


def section(vessel):
    """The page's part on a vessel."""
    data, name = vessel.data, vessel.name
    counts = f"{len(data.points)} control points" + (" to one side" if data.half else "")
    table = [("Control mesh", f"{counts}, {len(data.faces)} faces")]
    lines = [f"## {data.name}", "", f"`{name}`: {data.source}.", "", "| | |", "|---|---|"]
    lines += [f"| {label} | {text} |" for label, text in lines_plan.particulars(vessel) + table]
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
