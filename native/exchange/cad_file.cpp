// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/cad_file.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include "conversion/patches/control_faces.h"
#include "conversion/place_error.h"
#include "exchange/cad_model.h"
#include "exchange/occt_geometry.h"
#include "exchange/occt_session.h"
#include "exchange/regions.h"
#include "exchange/solids/face_integrals.h"
#include "exchange/solids/telling_faces.h"
#include "exchange/step/step_text.h"
#include "files/atomic_file.h"

namespace hull::exchange {
namespace {

constexpr double kSizeTolerance = 1e-6;      // of the size
constexpr double kIntegralTolerance = 1e-6;  // of the area, and of the area times the size

// Parts of colours: more than files round them to, and less than the 1/255 that shows.
constexpr double kSameColour = 1e-6;

// Shares of the time that the steps take, about.
constexpr double kModelDone = 0.05, kTextDone = 0.3;

// "3 of 4 faces".
std::string of(int have, int want, const std::string& what) {
  return std::to_string(have) + " of " + std::to_string(want) + " " + what;
}

// What a file can hold of a name: controls have become blanks.
std::string held(const std::string& name) { return decode_step_string(encode_step_string(name)); }

std::vector<CadRegion> regions_of(const CadModel& model, const CadOptions& options) {
  // By name, as the report has them: the two are compared one by one.
  std::map<std::string, CadRegion> regions;
  for (const std::string& name : model.regions) {
    CadRegion& region = regions[held(name)];
    region.name = held(name);
    region.colour = colour_of(name, options);
    ++region.faces;
  }
  std::vector<CadRegion> result;
  for (auto& [name, region] : regions) result.push_back(std::move(region));
  return result;
}

bool is_same(const analysis::Colour& one, const analysis::Colour& two) {
  for (int i = 0; i < 3; ++i) {
    if (!(std::abs(one[i] - two[i]) <= kSameColour)) return false;
  }
  return true;
}

std::string layer_difference(const CadModel& model, const CadOptions& options,
                             const CadReport& found) {
  const std::vector<CadRegion> meant = regions_of(model, options);
  if (found.regions.size() != meant.size()) {
    return of(static_cast<int>(found.regions.size()), static_cast<int>(meant.size()), "regions");
  }
  for (std::size_t i = 0; i < meant.size(); ++i) {
    const CadRegion& region = found.regions[i];
    const std::string where = "in the region \"" + meant[i].name + "\"";
    if (region.name != meant[i].name) return "no region \"" + meant[i].name + "\"";
    if (region.faces != meant[i].faces) return of(region.faces, meant[i].faces, "faces " + where);
    if (!region.colour || !is_same(*region.colour, *meant[i].colour)) {
      return "another colour " + where;
    }
  }
  for (const CadCurve& curve : model.curves) {
    // What has no layer is on none by that name. The report sorts its layers.
    if (!curve.layer.empty() && !std::ranges::binary_search(found.layers, held(curve.layer))) {
      return "no layer \"" + curve.layer + "\"";
    }
  }
  return "";
}

// Whether some of the solids that were read back are turned inside out.
bool has_turned_solid(const CadModel& model, const CadReport& found) {
  // All is there, and only the volume is another: then the reader took the outside of a solid for
  // its inside.
  return model.brep.solids > 0 && found.solids == model.brep.solids && found.closed &&
         !(std::abs(*found.volume - model.integrals.volume) <=
           kIntegralTolerance * model.integrals.area * model.size);
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
    // With the sign of the other, all faces point the other way.
    return *found.volume * model.integrals.volume < 0.0 ? "a solid turned inside out"
                                                        : "another volume";
  }
  const int curves = static_cast<int>(model.curves.size());
  if (found.curves != curves) return of(found.curves, curves, "curves");
  if (found.unit != name_of(options.unit)) return "another unit of length";
  if (found.product != held(options.name)) {
    return "the name \"" + found.product + "\"";
  }
  return layer_difference(model, options, found);
}

class FileWriter {
 public:
  // Makes the file first of all, so that nobody waits for one that can't be written.
  FileWriter(const std::string& path, const CadOptions& options, const CadText& text_of)
      : path_(path), options_(options), text_of_(text_of), file_(make_file()) {}

  CadReport write(const conversion::PatchSet& patches) {
    surface::tell(options_.progress, 0.0, 1.0);
    try {
      // Each step in a session of its own, as read_cad_report() opens one itself.
      in_session([&] { model_ = make_cad_model(patches, options_); });
      surface::tell(options_.progress, kModelDone, 1.0);
      CadReport report = written_and_read();
      // Once: every face is tried for the first one, so that another time would find no other.
      if (has_turned_solid(model_, report)) {
        in_session([&] { model_.brep.shape = with_telling_first_faces(model_.brep.shape); });
        // What was written to the first one is gone with it.
        file_ = make_file();
        report = written_and_read();
      }
      if (const std::string wrong = difference(model_, options_, report); !wrong.empty()) {
        refuse(wrong, report);
      }
      report.cells_left_out = std::move(model_.cells_left_out);
      report.warnings = std::move(model_.warnings);
      // Only now, after it was found to say what was meant, does it take its name.
      file_->replace();
      return report;
      // Also of what refuse() throws above.
    } catch (const conversion::PlaceError& error) {
      refuse_with_face(patches, error);
    }
  }

 private:
  std::unique_ptr<files::ReplacingFile> make_file() const {
    return std::make_unique<files::ReplacingFile>(path_);
  }

  template <class Do>
  void in_session(const Do& action) const {
    try {
      const OcctSession session(options_);
      action();
    } catch (const Standard_Failure& failure) {
      throw files::FileError("Open CASCADE could not make \"" + path_ + "\": " + describe(failure));
    } catch (const NoCadText& failure) {
      throw files::FileError("Open CASCADE could not make \"" + path_ + "\": " + failure.what());
    }
  }

  CadReport written_and_read() {
    std::string text;
    in_session([&] {
      // As text in memory: files are written in one place, which tells what went wrong.
      text = text_of_(model_, options_, surface::part_of(options_.progress, kModelDone, kTextDone));
    });
    file_->write(text);
    surface::tell(options_.progress, kTextDone, 1.0);
    return read_cad_report(file_->name(), path_,
                           surface::part_of(options_.progress, kTextDone, 1.0));
  }

  [[noreturn]] void refuse(const std::string& wrong, const CadReport& report) const {
    // The fault itself, else an edge that should not be free, else what most often makes trouble.
    const Vector3d place = !report.valid && report.at_fault ? *report.at_fault
                           : report.at_free_edge && report.free_edges > model_.brep.free_edges
                               ? *report.at_free_edge
                               : middle_of(smallest_face());
    throw conversion::PlaceError("\"" + path_ +
                                     "\" was not written, because reading it back gave " + wrong +
                                     "; look at " + conversion::place_text(place) +
                                     " for faces that are tiny or folded over, and for points "
                                     "that almost coincide",
                                 place);
  }

  const TopoDS_Face& smallest_face() const {
    return *std::ranges::min_element(model_.brep.faces, {}, [](const TopoDS_Face& face) {
      return std::abs(integrals_of_face(face).area);
    });
  }

  // Names the face of the control mesh where it is known, and no point is.
  [[noreturn]] void refuse_with_face(const conversion::PatchSet& patches,
                                     const conversion::PlaceError& error) const {
    // These say more exactly what is meant.
    if (!error.vertices().empty()) throw error;
    Vector3d point = error.point();
    // The control mesh is of the port half alone.
    if (options_.mirrored && point.y() < 0.0) point.y() = -point.y();
    const int face = conversion::nearest_control_face(patches, point);
    if (face < 0) throw error;
    throw conversion::PlaceError(
        std::string(error.what()) + " (face " + std::to_string(face) + " of the control mesh)",
        error.point(), face);
  }

  const std::string& path_;
  const CadOptions& options_;
  const CadText& text_of_;
  std::unique_ptr<files::ReplacingFile> file_;
  CadModel model_;
};

}  // namespace

CadReport write_cad_file(const conversion::PatchSet& patches, const std::string& path,
                         const CadOptions& options, const CadText& text_of) {
  return FileWriter(path, options, text_of).write(patches);
}

}  // namespace hull::exchange
