# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands in the menus of FREE!ship Plus, by menu, as its users know them."""

COMMANDS = {
    "File": ("New", "Open", "Save", "Save as", "Recent files", "Exit"),
    "Import": (
        "FEF file", "Carene XYZ file", "Chines", "Carlson .hul file", "VRML", "PolyCad", "Surface",
        "Bodyplan", "Part", "Michlet waves", "Import results of Add_Mass",
    ),
    "Export": (
        "FEF file", "Part", "Coordinates", "DXF 2D Polylines", "DXF 3D Polylines", "DXF 3D mesh",
        "Offsets", "Archimedes", "GHS", "Michlet", "IGES", "Wavefront file (Obj)", "STL",
        "Add_Mass", "PAM",
    ),
    "Project": ("Project settings", "Preferences", "Linesplan"),
    "Edit": ("Undo", "Redo", "Browse", "Clear", "Delete", "Intersections"),
    "Selection": (
        "Select all", "Deselect all", "Select All Control Points", "Select all leakpoints",
        "Selection Dialog",
    ),
    "Point": (
        "Add", "Align", "Align Permanently", "Anchor", "Collapse", "Insert plane",
        "Plane intersection", "Intersect layers", "Lock points", "Unlock points",
        "Unlock all points", "Coincide points", "Extrude points", "Add Point To Group",
    ),
    "Edge": ("Edge › Extrude", "Edge › Split", "Edge › Collapse", "Edge › Insert", "Edge › Crease"),
    "Curve": ("Curve › New",),
    "Face": ("Face › New", "Face › Invert"),
    "Layer": (
        "Layer › Active layer color", "Layer › Auto group", "Layer › New", "Layer › Delete empty",
        "Layer › Dialog", "Layer visibility dialog", "Show free objects",
    ),
    "Visibility": (
        "Control net", "Control curves", "Interior edges", "Show both sides", "Grid",
        "Add grid panel", "Stations", "Buttocks", "Waterlines", "Diagonals",
        "Hydrostatic features", "Add flow line", "Flowlines", "Normals", "Curvature",
        "Incr. curvature scale", "Decr. curvature scale", "Markers", "Split Section location",
        "Split Section middle location", "Precision", "font size",
    ),
    "Tools": (
        "Check model", "Remove negative", "Remove unused points", "Delete all markers",
        "Import (markers)", "Develop plates", "Keel and rudder wizard", "Add cylinder",
    ),
    "Transform": ("Scale", "Move", "Rotate", "Mirror", "Lackenby", "Heeling and/or trimming"),
    "Calculations": (
        "Design hydrostatics", "Hydrostatics", "Cross curves and SSD", "Design of propellers",
        "Maneuverability ship tasks", "Hydro and aerodynamics characteristics", "Seakeeping",
        "Delft yacht series", "KAPER", "Holtrop", "Hollenbach", "Fung-Leibman", "van Oortmerssen",
        "Multihull", "OST", "OCT 5.0181-75", "pre-planing and planing ships",
        "round bilge high-speed ships",
    ),
    "Window": ("New window", "Tile", "Cascade"),
    "Help": ("Help", "Check for updates"),
}  # fmt: skip
