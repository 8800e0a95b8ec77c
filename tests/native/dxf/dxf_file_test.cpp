// SPDX-License-Identifier: GPL-3.0-or-later
#include "dxf/dxf_file.h"

#include <dl_creationadapter.h>
#include <dl_dxf.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "dxf/dxf_text.h"
#include "files/atomic_file.h"

namespace hull::dxf {
namespace {

namespace fs = std::filesystem;

// What dxflib's own reader finds.
class Found : public DL_CreationAdapter {
 public:
  void addLayer(const DL_LayerData& data) override { layers.push_back(data.name); }
  void addSpline(const DL_SplineData& data) override {
    degree = static_cast<int>(data.degree);
    spline_layer = getAttributes().getLayer();
  }
  void addControlPoint(const DL_ControlPointData& data) override {
    control_points.emplace_back(data.x, data.y);
  }
  void addKnot(const DL_KnotData& data) override { knots.push_back(data.k); }
  void addVertex(const DL_VertexData& data) override { vertices.emplace_back(data.x, data.y); }
  void addPolyline(const DL_PolylineData& data) override { polyline_flags = data.flags; }
  void addLine(const DL_LineData&) override { ++lines; }
  void addText(const DL_TextData& data) override { texts.push_back(data); }
  void setVariableInt(const std::string& name, int value, int) override {
    if (name == "$INSUNITS") units = value;
  }

  std::vector<std::string> layers;
  std::string spline_layer;
  int degree = 0, polyline_flags = -1, lines = 0, units = -1;
  std::vector<Eigen::Vector2d> control_points, vertices;
  std::vector<double> knots;
  std::vector<DL_TextData> texts;
};

DxfDrawing small_drawing() {
  DxfDrawing drawing;
  drawing.layers = {{"STATIONS", 5, 0.2}, {"TEXT", 7, 0.18}};
  drawing.splines = {
      {0, {{0, 0}, {1.0 / 3.0, 2}, {2, 2e-7}, {3, -1234567.125}}, {0, 0, 0, 0, 1, 1, 1, 1}}};
  drawing.polylines = {{0, {{0, 0}, {1, 0}, {1, 1}, {0, 0}}}, {0, {{0, 0}, {5, 5}}}};
  drawing.texts = {{1, "Fläche 10 m²", {2, 3}, 0.25, 0.5}};
  return drawing;
}

class DxfFile : public ::testing::Test {
 protected:
  DxfFile() : folder_(fs::temp_directory_path() / ("hull_dxf_test_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~DxfFile() override { fs::remove_all(folder_); }
  std::string path() const { return (folder_ / "a.dxf").string(); }

  Found read() const {
    Found found;
    DL_Dxf dxf;
    EXPECT_TRUE(dxf.in(path(), &found));
    return found;
  }

  fs::path folder_;
};

TEST_F(DxfFile, ReadsBackAsWritten) {
  const DxfDrawing drawing = small_drawing();
  write_dxf(drawing, path());
  const Found found = read();
  EXPECT_EQ(found.layers, (std::vector<std::string>{"0", "STATIONS", "TEXT"}));
  EXPECT_EQ(found.units, 6);
  EXPECT_EQ(found.degree, 3);
  EXPECT_EQ(found.spline_layer, "STATIONS");
  EXPECT_EQ(found.knots, drawing.splines[0].knots);
  ASSERT_EQ(found.control_points.size(), 4u);
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector2d wanted = drawing.splines[0].points[i];
    EXPECT_LE((found.control_points[i] - wanted).norm(), 1e-15 * (1.0 + wanted.norm()));
  }
  EXPECT_EQ(found.polyline_flags, 1);  // closed
  EXPECT_EQ(found.vertices.size(), 3u);
  EXPECT_EQ(found.lines, 1);
  ASSERT_EQ(found.texts.size(), 1u);
  EXPECT_EQ(found.texts[0].text, "Fl\\U+00E4che 10 m\\U+00B2");
  EXPECT_NEAR(found.texts[0].angle, 0.5, 1e-12);
}

TEST_F(DxfFile, SaysMillimetres) {
  DxfDrawing drawing = small_drawing();
  drawing.unit = DxfUnit::kMillimetre;
  write_dxf(drawing, path());
  EXPECT_EQ(read().units, 4);
}

TEST_F(DxfFile, IsCompleteOrNotThere) {
  EXPECT_THROW(write_dxf(small_drawing(), (folder_ / "nowhere" / "a.dxf").string()),
               files::FileError);
  EXPECT_TRUE(fs::is_empty(folder_));
  write_dxf(small_drawing(), path());
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST(DxfText, EncodesWhatIsNotAscii) {
  EXPECT_EQ(encode_dxf_text("abc 1:200"), "abc 1:200");
  EXPECT_EQ(encode_dxf_text("∇ – °"), "\\U+2207 \\U+2013 \\U+00B0");
  EXPECT_EQ(encode_dxf_text("a\nb"), "a b");
  EXPECT_EQ(encode_dxf_text("^J %%d"), "^ J % %d");
  EXPECT_EQ(encode_dxf_text("\xff \xe2\x82"), "? ??");
  EXPECT_EQ(encode_dxf_text("\xf0\x9f\x9a\xa2"), "?");
}

}  // namespace
}  // namespace hull::dxf
