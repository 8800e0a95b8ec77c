// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/step_file.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <Eigen/Geometry>
#include <IFSelect_ReturnStatus.hxx>
#include <STEPControl_Writer.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <TCollection_HAsciiString.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "conversion/flat_patches.h"
#include "conversion/mirror.h"
#include "exchange/brep_shape.h"
#include "exchange/occt_session.h"
#include "exchange/step_text.h"
#include "files/atomic_file.h"

namespace hull {
namespace {

constexpr double kSizeTolerance = 1e-6;  // of the size

// Stands for the product's name until the text is there: Open CASCADE writes bytes above 127 as
// they are, which the format forbids, and would double the backslashes of the directives for them.
constexpr char kNameHolder[] = "HULL-PRODUCT-NAME";

Handle(TCollection_HAsciiString) text_of(const char* value) {
  return new TCollection_HAsciiString(value);
}

void set_names(const Handle(StepData_StepModel) & model) {
  APIHeaderSection_MakeHeader header(model);
  header.SetName(text_of(kNameHolder));
  header.SetAuthorValue(1, text_of(""));
  header.SetOrganizationValue(1, text_of(""));
  header.SetOriginatingSystem(text_of("Hull Tools"));
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto product = Handle(StepBasic_Product)::DownCast(model->Value(i));
    if (product.IsNull()) continue;
    product->SetId(text_of(kNameHolder));
    product->SetName(text_of(kNameHolder));
  }
}

std::string with_name(std::string text, const std::string& name) {
  const std::string holder = kNameHolder, encoded = encode_step_string(name);
  for (size_t at = text.find(holder); at != text.npos; at = text.find(holder, at)) {
    text.replace(at, holder.size(), encoded);
    at += encoded.size();
  }
  return text;
}

// The file's text. REQUIRES: an OcctSession lives.
std::string step_text(const TopoDS_Shape& shape, const std::string& name) {
  STEPControl_Writer writer;
  // Millimetres come in, metres go out. Release 7.8 heeds this and not the global setting for the
  // numbers, but that setting for the unit it declares.
  writer.Model()->SetLocalLengthUnit(1.0);
  writer.Model()->SetWriteLengthUnit(kMillimetresPerMetre);
  if (writer.Transfer(shape, STEPControl_AsIs) != IFSelect_RetDone) {
    throw FileError("Open CASCADE could not translate the patches to STEP");
  }
  set_names(writer.Model());
  StepData_StepWriter text(writer.Model());
  // 17 digits: doubles come back as they were. Trailing zeros stay, because Open CASCADE's way of
  // cutting them off loses the exponent.
  text.FloatWriter().SetFormat("%.16E");
  text.SendModel(Handle(StepData_Protocol)::DownCast(writer.WS()->Protocol()));
  std::ostringstream stream;
  if (!text.Print(stream)) throw FileError("Open CASCADE could not print the STEP file");
  return with_name(stream.str(), name);
}

// The box of the patches, from the same points as that of a StepReport.
Eigen::AlignedBox3d box_of(const PatchSet& set) {
  Eigen::AlignedBox3d box;
  for (const BSplinePatch& patch : set.patches) {
    for (int i = 0; i <= kBoxSteps; ++i) {
      for (int j = 0; j <= kBoxSteps; ++j) {
        box.extend(
            patch.position(static_cast<double>(i) / kBoxSteps, static_cast<double>(j) / kBoxSteps));
      }
    }
  }
  return box;
}

// What was read back and not meant; empty if all is well.
std::string difference(const PatchSet& set, const BRepShape& meant, const StepReport& found) {
  const auto numbers = [](int have, int want) {
    return std::to_string(have) + " of " + std::to_string(want);
  };
  const int faces = static_cast<int>(meant.faces.size());
  if (found.faces != faces) return numbers(found.faces, faces) + " faces";
  if (found.free_edges != meant.free_edges) {
    return numbers(found.free_edges, meant.free_edges) + " free edges";
  }
  const Eigen::AlignedBox3d box = box_of(set);
  const double error =
      std::max((found.box_min - box.min()).norm(), (found.box_max - box.max()).norm());
  if (!(error <= kSizeTolerance * set.size())) return "a shape of another size";
  return found.valid ? "" : "a shape that is not valid";
}

}  // namespace

StepReport write_step(const PatchSet& patches, const std::string& path,
                      const StepOptions& options) {
  patches.check();
  WithoutFlatPatches flat = without_flat_patches(patches);
  if (flat.patches.patches.empty())
    throw std::invalid_argument("no patch has an area: nothing to write");
  const PatchSet set = options.mirrored ? with_mirror_image(flat.patches) : std::move(flat.patches);
  std::string text;
  BRepShape brep;
  try {
    const OcctSession session;
    brep = make_brep_shape(set);
    text = step_text(brep.shape, options.name);
  } catch (const Standard_Failure& failure) {
    throw FileError("Open CASCADE could not make the STEP file: " + describe(failure));
  }
  std::istringstream stream(text);
  StepReport report = read_step_report(stream, path);
  if (const std::string wrong = difference(set, brep, report); !wrong.empty()) {
    throw std::invalid_argument("the STEP file was not written, because reading it back gave " +
                                wrong +
                                "; look for faces that are tiny or folded over, and for "
                                "points that almost coincide");
  }
  write_file_atomically(path, text);
  report.cells_left_out = std::move(flat.left_out);
  return report;
}

}  // namespace hull
