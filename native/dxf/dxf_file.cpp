// SPDX-License-Identifier: GPL-3.0-or-later
#include "dxf/dxf_file.h"

#include <dl_dxf.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numbers>
#include <sstream>

#include "dxf/dxf_objects.h"
#include "dxf/dxf_text.h"
#include "files/atomic_file.h"

namespace hull::dxf {

using Eigen::Vector2d;

namespace {

constexpr char kTextStyle[] = "Standard";
constexpr int kPlanar = 8;  // a flag of splines

// The line weights that the format knows, in hundredths of a millimetre.
constexpr std::array kLineWeights = {5,  9,  13, 15, 18,  20,  25,  30,  35,  40,  50, 53,
                                     60, 70, 80, 90, 100, 106, 120, 140, 158, 200, 211};

// The format refuses other weights, so the nearest is taken; `width` is in mm.
int line_weight(double width) {
  const double wanted = 100.0 * width;
  return *std::min_element(kLineWeights.begin(), kLineWeights.end(), [wanted](int a, int b) {
    return std::abs(a - wanted) < std::abs(b - wanted);
  });
}

const char* name_of(DxfLineType type) {
  switch (type) {
    case DxfLineType::kCentre:
      return "CENTER";
    case DxfLineType::kDashed:
      return "DASHED";
    case DxfLineType::kContinuous:
      break;
  }
  return "CONTINUOUS";
}

[[noreturn]] void refuse_for_want_of_room(const std::string& path) {
  std::error_code error;
  const std::string folder = std::filesystem::temp_directory_path(error).string();
  throw files::FileError("Cannot write \"" + path + "\": the folder of temporary files, " +
                         (error ? "TMPDIR" : folder) +
                         ", takes no more; free some space there, or set TMPDIR to another");
}

// A folder of its own for a file that dxflib writes by name; gone with this object.
class ScratchFolder {
 public:
  explicit ScratchFolder(const std::string& target) {
    std::error_code error;
    std::string name = (std::filesystem::temp_directory_path(error) / "hull_dxf_XXXXXX").string();
    if (error || !::mkdtemp(name.data())) refuse_for_want_of_room(target);
    folder_ = name;
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  std::string file() const { return (folder_ / "drawing.dxf").string(); }

 private:
  std::filesystem::path folder_;
};

Eigen::AlignedBox2d box_of(const DxfDrawing& drawing) {
  // By the splines' control points: they enclose the curve (convex hull), which is all that a first
  // view needs.
  Eigen::AlignedBox2d box;
  for (const DxfPolyline& line : drawing.polylines) {
    for (const Vector2d& point : line.points) box.extend(point);
  }
  for (const DxfSpline& spline : drawing.splines) {
    for (const Vector2d& point : spline.points) box.extend(point);
  }
  for (const DxfSpaceSpline& spline : drawing.space_splines) {
    for (const Eigen::Vector3d& point : spline.points) box.extend(point.head<2>());
  }
  for (const DxfText& text : drawing.texts) box.extend(text.position);
  if (box.isEmpty()) box.extend(Vector2d(0.0, 0.0));
  return box;
}

void write_point_variable(DL_WriterA& file, const char* name, const Vector2d& point) {
  file.dxfString(9, name);
  file.dxfReal(10, point.x());
  file.dxfReal(20, point.y());
}

void write_header(DL_Dxf& dxf, DL_WriterA& file, const DxfDrawing& drawing) {
  dxf.writeHeader(file);
  file.dxfString(9, "$INSUNITS");
  // 6 and 4 are the format's numbers of metre and millimetre.
  file.dxfInt(70, drawing.unit == DxfUnit::kMetre ? 6 : 4);
  file.dxfString(9, "$MEASUREMENT");
  file.dxfInt(70, 1);  // metric
  const Eigen::AlignedBox2d box = box_of(drawing);
  write_point_variable(file, "$EXTMIN", box.min());
  write_point_variable(file, "$EXTMAX", box.max());
  file.dxfString(9, "$LTSCALE");
  // Dashes are in mm of paper, lengths in the drawing's unit: this brings the one to the other.
  file.dxfReal(40, drawing.paper_millimetre);
  file.sectionEnd();
}

void write_tables(DL_Dxf& dxf, DL_WriterA& file, const DxfDrawing& drawing) {
  file.sectionTables();
  dxf.writeVPort(file);
  file.tableLinetypes(5);
  // Readers look for these three in every file, also where no layer has them.
  for (const char* name : {"BYBLOCK", "BYLAYER", "CONTINUOUS"}) {
    dxf.writeLinetype(file, DL_LinetypeData(name, name, 0, 0, 0.0));
  }
  // Lengths of line and gap in mm on paper.
  std::array centre = {6.0, -1.2, 0.8, -1.2};
  std::array dashed = {3.0, -1.0};
  dxf.writeLinetype(
      file, DL_LinetypeData(name_of(DxfLineType::kCentre), "chain", 0, 4, 9.2, centre.data()));
  dxf.writeLinetype(
      file, DL_LinetypeData(name_of(DxfLineType::kDashed), "dashed", 0, 2, 4.0, dashed.data()));
  file.tableEnd();

  file.tableLayers(static_cast<int>(drawing.layers.size()) + 1);
  // The weight 25 is 0.25 mm.
  dxf.writeLayer(file, DL_LayerData("0", 0), DL_Attributes("", 7, 25, "CONTINUOUS", 1.0));
  for (const DxfLayer& layer : drawing.layers) {
    dxf.writeLayer(
        file, DL_LayerData(layer.name, 0),
        DL_Attributes("", layer.colour, line_weight(layer.width), name_of(layer.line_type), 1.0));
  }
  file.tableEnd();

  file.tableStyle(1);
  // A height of 0 leaves it to each text; 2.5 is only the height last used.
  dxf.writeStyle(file, DL_StyleData(kTextStyle, 0, 0.0, 1.0, 0.0, 0, 2.5, "txt", ""));
  file.tableEnd();
  dxf.writeView(file);
  dxf.writeUcs(file);
  file.tableAppid(1);
  dxf.writeAppid(file, "ACAD");
  file.tableEnd();
  dxf.writeDimStyle(file, 1.0, 1.0, 1.0, 1.0, 1.0);
  dxf.writeBlockRecord(file);
  file.tableEnd();
  file.sectionEnd();
}

void write_blocks(DL_Dxf& dxf, DL_WriterA& file) {
  // The blocks of model space and of two layouts on paper are there in every file, empty or not.
  file.sectionBlocks();
  for (const char* name : {"*Model_Space", "*Paper_Space", "*Paper_Space0"}) {
    dxf.writeBlock(file, DL_BlockData(name, 0, 0.0, 0.0, 0.0));
    dxf.writeEndBlock(file, name);
  }
  file.sectionEnd();
}

DL_Attributes on_layer(const DxfDrawing& drawing, int layer) {
  // 256 and -1 are the format's "by layer".
  return DL_Attributes(drawing.layers.at(layer).name, 256, -1, "BYLAYER", 1.0);
}

void write_polyline(DL_Dxf& dxf, DL_WriterA& file, const DxfPolyline& line,
                    const DL_Attributes& attributes) {
  const auto& points = line.points;
  // An entity is closed by its flag; with the first point again at the end it would have an edge of
  // no length.
  const bool closed = points.size() > 2 && points.front() == points.back();
  const int count = static_cast<int>(points.size()) - (closed ? 1 : 0);
  if (count == 2) {
    dxf.writeLine(file,
                  DL_LineData(points[0].x(), points[0].y(), 0.0, points[1].x(), points[1].y(), 0.0),
                  attributes);
    return;
  }
  dxf.writePolyline(file, DL_PolylineData(count, 0, 0, closed ? 1 : 0), attributes);
  for (int i = 0; i < count; ++i) {
    dxf.writeVertex(file, DL_VertexData(points[i].x(), points[i].y()));
  }
  dxf.writePolylineEnd(file);
}

// All but its control points.
template <class Spline>
void begin_spline(DL_Dxf& dxf, DL_WriterA& file, const Spline& spline, int flags,
                  const DL_Attributes& attributes) {
  const int points = static_cast<int>(spline.points.size());
  const int knots = static_cast<int>(spline.knots.size());
  // Of degree 3.
  dxf.writeSpline(file, DL_SplineData(3, knots, points, 0, flags), attributes);
  for (const double knot : spline.knots) dxf.writeKnot(file, DL_KnotData(knot));
}

void write_spline(DL_Dxf& dxf, DL_WriterA& file, const DxfSpline& spline,
                  const DL_Attributes& attributes) {
  begin_spline(dxf, file, spline, kPlanar, attributes);
  for (const Vector2d& point : spline.points) {
    // With the weight 1 throughout: not rational.
    dxf.writeControlPoint(file, DL_ControlPointData(point.x(), point.y(), 0.0, 1.0));
  }
}

void write_space_spline(DL_Dxf& dxf, DL_WriterA& file, const DxfSpaceSpline& spline,
                        const DL_Attributes& attributes) {
  begin_spline(dxf, file, spline, 0, attributes);
  for (const Eigen::Vector3d& point : spline.points) {
    dxf.writeControlPoint(file, DL_ControlPointData(point.x(), point.y(), point.z(), 1.0));
  }
}

void write_text(DL_Dxf& dxf, DL_WriterA& file, const DxfText& text,
                const DL_Attributes& attributes) {
  constexpr int kCentred = 1, kOnBaseline = 0;
  // Centred, it is the second point that counts. dxflib takes radians.
  const double x = text.position.x(), y = text.position.y();
  dxf.writeText(file,
                DL_TextData(x, y, 0.0, x, y, 0.0, text.height, 1.0, 0, kCentred, kOnBaseline,
                            encode_dxf_text(text.text), kTextStyle, text.angle),
                attributes);
}

void write_entities(DL_Dxf& dxf, DL_WriterA& file, const DxfDrawing& drawing) {
  file.sectionEntities();
  for (const DxfPolyline& line : drawing.polylines) {
    write_polyline(dxf, file, line, on_layer(drawing, line.layer));
  }
  for (const DxfSpline& spline : drawing.splines) {
    write_spline(dxf, file, spline, on_layer(drawing, spline.layer));
  }
  for (const DxfSpaceSpline& spline : drawing.space_splines) {
    write_space_spline(dxf, file, spline, on_layer(drawing, spline.layer));
  }
  for (const DxfText& text : drawing.texts) {
    write_text(dxf, file, text, on_layer(drawing, text.layer));
  }
  file.sectionEnd();
}

std::string content_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  return content.str();
}

// Cut short by a full disk, a file lacks its end.
bool is_complete(const std::string& content) {
  return content.size() > 6 && content.find("EOF", content.size() - 6) != content.npos;
}

}  // namespace

void write_dxf(const DxfDrawing& drawing, const std::string& path) {
  // dxflib writes to a name only. It writes into a folder of its own, and what is moved to `path`
  // is known to be whole.
  const ScratchFolder scratch(path);
  {
    DL_Dxf dxf;
    const std::unique_ptr<DL_WriterA> file(dxf.out(scratch.file().c_str(), DL_Codes::AC1015));
    if (!file) refuse_for_want_of_room(path);
    write_header(dxf, *file, drawing);
    write_tables(dxf, *file, drawing);
    write_blocks(dxf, *file);
    write_entities(dxf, *file, drawing);
    write_dxf_objects(*file);
    file->dxfEOF();
    file->close();
  }
  const std::string content = content_of(scratch.file());
  if (!is_complete(content)) refuse_for_want_of_room(path);
  files::write_file_atomically(path, content);
}

}  // namespace hull::dxf
