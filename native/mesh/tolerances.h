// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What counts as equal, flat, or in a plane, wherever more than one part of the program asks. All
// are parts of the size that ControlMesh::size() tells (of sets of patches PatchSet::size()). What
// one algorithm alone needs, to end its steps or to know its rounding, stays beside it.
namespace hull {

// m, the one length among parts: the least extent that the points of a mesh's faces have along some
// axis. Below it the mesh has no size that tolerances could be parts of, and check_mesh() and
// ControlMesh::with_points() refuse it.
inline constexpr double kLeastSize = 1e-9;

// A half hull's points so near lie in the centre plane y = 0, for closings, CAD files and what is
// drawn alike. Conversion puts its centre line there first, so that seams and caps are exact. A
// tenth of a mm on 100 m: several times the rounding of single precision, which turning a model
// leaves, and less than anybody models.
inline constexpr double kOnCentrePlane = 1e-6;

// Borders that run along the centre plane this near to it, but not on it, are taken for meant to be
// on it, and are told of: a centimetre on 100 m.
inline constexpr double kNearCentrePlane = 1e-4;

// Keel, stem and stern of a half hull may lie this far from the centre plane by their modelling, as
// those of a bar keel: in plans and tables they are the centre line still.
inline constexpr double kAtCentreLine = 1e-3;

// Points lie in one plane, of models with coordinates in single precision: flat ends, transoms,
// flat regions.
inline constexpr double kInPlane = 1e-6;

// Positions that are asked for are the same, and lines at an end of the hull are drawn that much
// inside of it.
inline constexpr double kSamePosition = 1e-6;

// Parts of the surface lie in the plane of a section that is drawn. Less than kInPlane, as they are
// left out of the section but for their borders; more than the rounding of single precision.
inline constexpr double kInSection = 2e-7;

// What a cap is a plane face of, or lies on a line athwartships. Not more, because what CAD systems
// take for the same point is not more either: 1 µm on 100 m.
inline constexpr double kInCap = 1e-8;

// Sides and patches of B-splines have no length, and no area across it.
inline constexpr double kNoLength = 1e-9;

// Squares of cells at irregular corners are cut no further: what is left out of a section or a
// volume.
inline constexpr double kSmallestCorner = 1e-9;

// Heights above a plane are none, but for the rounding of a few sums.
inline constexpr double kZeroHeight = 1e-13;

}  // namespace hull
