# SPDX-License-Identifier: GPL-3.0-or-later
"""What docs/coming-from.md covers of programs besides FREE!ship: what DELFTship has beyond that, as
its manual names it, and Rhino's commands for hulls, by what they are for."""

DELFTSHIP = (
    "Background images", "Tanks", "Compartments", "Sounding tables", "Bulkhead deck",
    "Damage stability", "Longitudinal strength", "Load cases", "Critical points",
    "Wind silhouette", "Stability criteria", "Shell plate expansion",
)  # fmt: skip

RHINO = {
    "move": (
        "PointsOn", "Move", "Rotate", "Scale", "Scale1D", "MoveUVN", "SetPt", "Align", "CageEdit",
        "SoftMove", "Flow", "Copy", "Array", "Mirror", "Undo", "Redo", "History",
    ),
    "mesh": (
        "SubD", "ToSubD", "QuadRemesh", "Crease", "RemoveCrease", "InsertEdge", "InsertPoint",
        "Bridge", "InsertKnot", "InsertControlPoint", "RemoveKnot", "Rebuild", "Mesh",
    ),
    "curves": (
        "Curve", "InterpCrv", "Conic", "Fair", "BlendCrv", "FitCrv", "ExtractIsocurve", "DupEdge",
        "Contour", "Section",
    ),
    "surfaces": (
        "NetworkSrf", "Loft", "Sweep2", "EdgeSrf", "Patch", "Drape", "ShrinkWrap", "MatchSrf",
        "BlendSrf", "FilletSrf", "Trim", "Split", "Join", "PlanarSrf", "Cap", "BooleanUnion",
        "BooleanDifference", "Offset", "OffsetSrf", "Shell", "UnrollSrf", "Smash", "DevLoft",
    ),
    "judge": (
        "CurvatureGraph", "CurvatureAnalysis", "Zebra", "EMap", "DraftAngleAnalysis",
        "PointDeviation", "ShowEdges", "Check", "SelBadObjects",
    ),
    "measure": ("Distance", "Length", "Area", "Volume", "AreaCentroid", "BoundingBox"),
    "show": (
        "Layer", "Group", "Lock", "Hide", "BackgroundBitmap", "Picture", "Make2D",
        "ViewCaptureToFile", "Render", "Layout", "Dim", "Print",
    ),
}  # fmt: skip
