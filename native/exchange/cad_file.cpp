// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/cad_file.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "exchange/occt_session.h"
#include "exchange/regions.h"
#include "exchange/step_text.h"
#include "files/atomic_file.h"

namespace hull::exchange {
namespace {

constexpr double kSizeTolerance = 1e-6;      // of the size
constexpr double kIntegralTolerance = 1e-6;  // of the area, and of the area times the size

// Shares of the time that the steps take, about.
constexpr double kModelDone = 0.05, kTextDone = 0.3;

std::string of(int have, int want, const std::string& what) {
  return std::to_string(have) + " of " + std::to_string(want) + " " + what;
}

std::vector<CadRegion> regions_of(const CadModel& model) {
  std::map<std::string, CadRegion> regions;
  for (const std::string& name : model.regions) {
    regions[name].name = name;
    ++regions[name].faces;
  }
  std::vector<CadRegion> result;
  for (auto& [name, region] : regions) result.push_back(std::move(region));
  return result;
}

bool is_same(const Colour& one, const Colour& two) {
  for (int i = 0; i < 3; ++i) {
    if (!(std::abs(one[i] - two[i]) <= 1e-6)) return false;
  }
  return true;
}

std::string layer_difference(const CadModel& model, const CadOptions& options,
                             const CadReport& found) {
  const std::vector<CadRegion> meant = regions_of(model);
  if (found.regions.size() != meant.size()) {
    return of(static_cast<int>(found.regions.size()), static_cast<int>(meant.size()), "regions");
  }
  for (std::size_t i = 0; i < meant.size(); ++i) {
    const CadRegion& region = found.regions[i];
    const std::string where = "in the region \"" + meant[i].name + "\"";
    if (region.name != meant[i].name) return "no region \"" + meant[i].name + "\"";
    if (region.faces != meant[i].faces) return of(region.faces, meant[i].faces, "faces " + where);
    if (!region.colour || !is_same(*region.colour, colour_of(meant[i].name, options))) {
      return "another colour " + where;
    }
  }
  for (const CadCurve& curve : model.curves) {
    if (!std::ranges::binary_search(found.layers, curve.layer)) {
      return "no layer \"" + curve.layer + "\"";
    }
  }
  return "";
}

// What was read back and not meant; empty if all is well.
std::string difference(const CadModel& model, const CadOptions& options, const CadReport& found) {
  const int faces = static_cast<int>(model.brep.faces.size());
  if (found.faces != faces) return of(found.faces, faces, "faces");
  if (found.free_edges != model.brep.free_edges) {
    return of(found.free_edges, model.brep.free_edges, "free edges");
  }
  if (found.solids != model.brep.solids) return of(found.solids, model.brep.solids, "solids");
  const double error =
      std::max((found.box_min - model.box.min()).norm(), (found.box_max - model.box.max()).norm());
  if (!(error <= kSizeTolerance * model.size)) return "a shape of another size";
  if (!found.valid) return "a shape that is not valid";
  const double area = model.integrals.area;
  if (!(std::abs(found.area - area) <= kIntegralTolerance * area)) return "another area";
  // By the area times the size, for the volume of a thin shell may be nearly nothing.
  if (found.closed && !(std::abs(*found.volume - model.integrals.volume) <=
                        kIntegralTolerance * area * model.size)) {
    return *found.volume * model.integrals.volume < 0.0 ? "a solid turned inside out"
                                                        : "another volume";
  }
  const int curves = static_cast<int>(model.curves.size());
  if (found.curves != curves) return of(found.curves, curves, "curves");
  if (found.unit != name_of(options.unit)) return "another unit of length";
  if (found.product != decode_step_string(encode_step_string(options.name))) {
    return "the name \"" + found.product + "\"";
  }
  return layer_difference(model, options, found);
}

}  // namespace

CadReport write_cad_file(const conversion::PatchSet& patches, const std::string& path,
                         const CadOptions& options, const CadText& text_of) {
  // First of all, so that nobody waits for a file that can't be written.
  files::ReplacingFile file(path);
  surface::tell(options.progress, 0.0, 1.0);
  CadModel model;
  std::string text;
  try {
    const OcctSession session(options);
    model = make_cad_model(patches, options);
    surface::tell(options.progress, kModelDone, 1.0);
    text = text_of(model, options, surface::part_of(options.progress, kModelDone, kTextDone));
  } catch (const Standard_Failure& failure) {
    throw files::FileError("Open CASCADE could not make \"" + path + "\": " + describe(failure));
  }
  file.write(text);
  surface::tell(options.progress, kTextDone, 1.0);
  CadReport report =
      read_cad_report(file.name(), path, surface::part_of(options.progress, kTextDone, 1.0));
  if (const std::string wrong = difference(model, options, report); !wrong.empty()) {
    throw std::invalid_argument("\"" + path + "\" was not written, because reading it back gave " +
                                wrong +
                                "; look for faces that are tiny or folded over, and for "
                                "points that almost coincide");
  }
  report.cells_left_out = std::move(model.cells_left_out);
  // Only now, after it was found to say what was meant, does it take its name.
  file.replace();
  return report;
}

}  // namespace hull::exchange
