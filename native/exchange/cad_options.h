// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "analysis/appendages/appendage.h"
#include "analysis/fairness/colour_maps.h"
#include "conversion/patches/bspline_curve.h"
#include "surface/progress.h"

namespace hull::exchange {

enum class StepSchema { kAp214, kAp242 };
enum class CadUnit { kMetre, kCentimetre, kMillimetre, kFoot, kInch };

// "m", "cm", "mm", "ft", "in", and of one unit how many millimetres.
CadUnit cad_unit_from(const std::string& name);  // throws std::invalid_argument for another name
std::string name_of(CadUnit unit);
double millimetres_in(CadUnit unit);

// A curve beside the faces, on a layer.
struct CadCurve {
  std::string name, layer;
  conversion::BSplineCurve curve;
};

// What CAD files are made with. Text is UTF-8.
struct CadOptions {
  StepSchema schema = StepSchema::kAp214;  // of STEP files
  std::string name = "hull";               // of the product
  CadUnit unit = CadUnit::kMetre;          // of the file's numbers
  bool mirrored = false;  // the mirror image on y = 0 too, joined along the centre line; of curves
                          // as well, but for those in the centre plane
  bool solid = false;     // close open borders with caps (closing_of), so that a solid comes out
  // Per patch the region that it belongs to; none: what find_regions() says. An image's is that of
  // its patch. A region is a layer of its name, whose faces have its colour.
  std::vector<std::string> regions{};
  std::map<std::string, analysis::Colour> colours{};  // beside or instead of region_colour()
  std::vector<CadCurve> curves{};
  // Joined to the solid, or cut out of it; both sides must be there.
  std::vector<analysis::Appendage> appendages{};
  // Called now and then; what it throws ends the task and leaves nothing behind.
  surface::Progress progress{};
};

}  // namespace hull::exchange
