// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/step/step_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "conversion/exact/exact_conversion.h"
#include "conversion/patches/edge_uses.h"
#include "conversion/per_cell/per_cell.h"
#include "conversion/sheets.h"
#include "files/atomic_file.h"
#include "test_meshes.h"

namespace hull::exchange {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

class StepFile : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("hull_exchange_" + std::to_string(getpid()));
    fs::create_directory(folder_);
    path_ = (folder_ / "hull.step").string();
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string text() const {
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  int files() const { return static_cast<int>(std::distance(fs::directory_iterator(folder_), {})); }

  fs::path folder_;
  std::string path_;
};

// A bowl of 20 x 6 x 3 m: t = 0 is its keel in the centre plane.
conversion::PatchSet half_bowl() {
  return testing::sheet(4, 3, [](double s, double t) {
    const double along = 2 * s - 1;
    return Vector3d(20 * s, 3 * t * (1 - 0.5 * along * along), 3 * t * t);
  });
}

TEST_F(StepFile, OfTheCubesSurfaceIsASolid) {
  const conversion::PatchSet set =
      conversion::fit_per_cell(surface::LimitSurface(mesh::ControlMesh(testing::cube())), 7);
  write_step(set, path_, {.name = "cube"});
  const CadReport report = read_cad_report(path_);
  EXPECT_TRUE(report.valid);
  EXPECT_EQ(report.solids, 1);
  EXPECT_EQ(report.shells, 1);
  EXPECT_EQ(report.faces, 24);
  EXPECT_EQ(report.edges, 48);
  EXPECT_EQ(report.free_edges, 0);
  EXPECT_EQ(report.free_edge_length, 0.0);
  EXPECT_EQ(report.product, "cube");
  ASSERT_TRUE(report.volume.has_value());
  // Outward normals make it positive.
  EXPECT_NEAR(*report.volume, 2.62041903269898, 2e-5);
  EXPECT_TRUE(report.cells_left_out.empty());
}

// Points that an edge has and both its faces are one in the file.
TEST_F(StepFile, OfTrianglesIsSmall) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::sheet_of_triangles(8))};
  const conversion::PatchSet set = conversion::exact_patches(surface);
  write_step(set, path_);
  const CadReport report = read_cad_report(path_);
  EXPECT_TRUE(report.valid);
  EXPECT_EQ(report.shells, 1);
  EXPECT_EQ(report.faces, static_cast<int>(set.patches.size()));
  const conversion::EdgeUses uses(set);
  int borders = 0;
  for (int edge = 0; edge < set.edge_count; ++edge) borders += uses.is_border(edge) ? 1 : 0;
  EXPECT_EQ(report.free_edges, borders);
  std::size_t points = 0;
  for (const conversion::BSplinePatch& patch : set.patches) points += patch.control_points.size();
  const double bytes = static_cast<double>(fs::file_size(path_));
  EXPECT_LE(bytes, 95.0 * static_cast<double>(points));
  EXPECT_LE(bytes, 52e3 * 2 * 8 * 8);
}

TEST_F(StepFile, RefusesWhatCouldNotBeReadBack) {
  // Three hundred patches of 300 x 300 points; nothing is made of them.
  conversion::PatchSet set = testing::rectangle(6.0, 4.0, 1, 1);
  set.patches.front().control_points.resize(90000);
  set.patches.resize(300, set.patches.front());
  try {
    write_step(set, path_);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("about 2700 MB"), std::string::npos) << error.what();
  }
  EXPECT_EQ(files(), 0);
}

TEST_F(StepFile, HasTheTrueSize) {
  write_step(testing::rectangle(6.0, 4.0, 3, 2), path_);
  const CadReport report = read_cad_report(path_);
  EXPECT_TRUE(report.valid);
  EXPECT_EQ(report.solids, 0);
  EXPECT_EQ(report.shells, 1);
  EXPECT_EQ(report.faces, 6);
  EXPECT_EQ(report.free_edges, 10);
  EXPECT_NEAR(report.area, 24.0, 1e-9);
  EXPECT_NEAR(report.free_edge_length, 20.0, 1e-9);
  EXPECT_LT((report.box_min - Vector3d(0, 0, 0)).norm(), 1e-9);
  EXPECT_LT((report.box_max - Vector3d(6, 4, 0)).norm(), 1e-9);
  EXPECT_FALSE(report.volume.has_value());
  // Coordinates are in metres, and the file says so.
  EXPECT_NE(text().find("SI_UNIT($,.METRE.)"), std::string::npos);
  EXPECT_NE(text().find("(6.,4.,0.)"), std::string::npos);
}

TEST_F(StepFile, OfAHalfHasOnlyItsRealBorders) {
  const CadReport report = write_step(half_bowl(), path_);
  EXPECT_TRUE(report.valid);
  EXPECT_EQ(report.shells, 1);
  EXPECT_EQ(report.faces, 12);
  EXPECT_EQ(report.free_edges, 2 * (4 + 3));
}

TEST_F(StepFile, MirroredIsJoinedAlongTheCentreLine) {
  const CadReport half = write_step(half_bowl(), path_);
  const CadReport whole = write_step(half_bowl(), path_, {.mirrored = true});
  EXPECT_TRUE(whole.valid);
  EXPECT_EQ(whole.shells, 1);
  EXPECT_EQ(whole.faces, 24);
  EXPECT_EQ(whole.free_edges, 2 * (4 + 3 + 3));
  EXPECT_NEAR(whole.area, 2 * half.area, 1e-9 * half.area);
  EXPECT_NEAR(whole.box_min.y(), -whole.box_max.y(), 1e-12);
}

// Half of a box, open where y = 0; all its edges are creases.
TEST_F(StepFile, MirroredHalfOfAClosedBoxIsASolidWithOutwardNormals) {
  mesh::MeshArrays half;
  half.points = {{-1, 0, -1}, {1, 0, -1}, {1, 1, -1}, {-1, 1, -1},
                 {-1, 0, 1},  {1, 0, 1},  {1, 1, 1},  {-1, 1, 1}};
  half.face_sizes = {4, 4, 4, 4, 4};
  half.face_vertices = {0, 3, 2, 1, 4, 5, 6, 7, 3, 7, 6, 2, 0, 4, 7, 3, 1, 2, 6, 5};
  half.creases = {{0, 3}, {1, 2}, {2, 3}, {4, 7}, {5, 6}, {6, 7}, {3, 7}, {2, 6}};
  const conversion::PatchSet set =
      conversion::fit_per_cell(surface::LimitSurface(mesh::ControlMesh(half)), 4);
  const CadReport report = write_step(set, path_, {.mirrored = true});
  EXPECT_TRUE(report.valid);
  EXPECT_EQ(report.solids, 1);
  EXPECT_EQ(report.free_edges, 0);
  ASSERT_TRUE(report.volume.has_value());
  EXPECT_NEAR(*report.volume, 2.0 * 2.0 * 2.0, 1e-9);
}

TEST_F(StepFile, KeepsPartsApart) {
  std::vector<conversion::BSplinePatch> patches = testing::rectangle(6.0, 4.0, 2, 2).patches;
  for (conversion::BSplinePatch patch : testing::rectangle(1.0, 1.0).patches) {
    for (Vector3d& point : patch.control_points) point.z() += 5.0;
    patch.cell = 4;
    patches.push_back(patch);
  }
  const CadReport report = write_step(testing::joined(patches), path_);
  EXPECT_TRUE(report.valid);
  EXPECT_EQ(report.shells, 2);
  EXPECT_EQ(report.faces, 5);
}

// An eighth of a dome: all its meridians end in the pole, where three sides have no length.
TEST_F(StepFile, TakesSidesOfNoLength) {
  const conversion::PatchSet set = testing::sheet(3, 2, [](double s, double t) {
    const double angle = 0.5 * std::numbers::pi * s, radius = 2.0 * (1.0 - t);
    if (t == 1.0) return Vector3d(0, 0, 2);
    return Vector3d(radius * std::cos(angle), radius * std::sin(angle), 2.0 * t * (2.0 - t));
  });
  const CadReport report = write_step(set, path_);
  EXPECT_TRUE(report.valid);
  EXPECT_EQ(report.faces, 6);
  EXPECT_EQ(report.edges, 3 + 3 + 4 + 4);
  EXPECT_EQ(report.free_edges, 3 + 2 + 2);
}

TEST_F(StepFile, LeavesOutCellsWithoutAreaAndSaysWhich) {
  conversion::PatchSet set =
      testing::sheet(3, 2, [](double s, double t) { return Vector3d(s, t, s * t); });
  for (conversion::BSplinePatch& patch : set.patches) {
    for (Vector3d& p : patch.control_points) {
      if (p.x() > 1.0 / 3) p.x() = std::max(1.0 / 3, p.x() - 1.0 / 3);
      p.z() = p.x() * p.y();
    }
  }
  const CadReport report = write_step(set, path_);
  EXPECT_EQ(report.cells_left_out, (std::vector<int>{1, 4}));
  EXPECT_TRUE(report.valid);
  EXPECT_EQ(report.shells, 1);
  EXPECT_EQ(report.faces, 4);
  EXPECT_EQ(report.free_edges, 8);
}

TEST_F(StepFile, KeepsNamesInAnyScript) {
  const std::string name = "Fähre 'Süd' \\ 漢字 ⛵🚢";
  write_step(testing::rectangle(6.0, 4.0), path_, {.name = name});
  EXPECT_EQ(read_cad_report(path_).product, name);
  for (char c : text()) ASSERT_TRUE(c == '\n' || (c >= ' ' && c < 127));
  write_step(testing::rectangle(6.0, 4.0), path_, {.name = std::string(300, 'x')});
  EXPECT_EQ(read_cad_report(path_).product, std::string(300, 'x'));
}

TEST_F(StepFile, PrintsNothing) {
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  write_step(testing::rectangle(6.0, 4.0), path_);
  EXPECT_THROW(read_cad_report((folder_ / "none.step").string()), files::FileError);
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST_F(StepFile, CanBeWrittenFromSeveralThreads) {
  std::vector<std::thread> threads;
  std::array<CadReport, 3> reports;
  for (int i = 0; i < 3; ++i) {
    threads.emplace_back([&, i] {
      reports[i] = write_step(testing::rectangle(6.0, 4.0, i + 1, 2),
                              (folder_ / (std::to_string(i) + ".step")).string());
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (int i = 0; i < 3; ++i) EXPECT_EQ(reports[i].faces, 2 * (i + 1));
  EXPECT_EQ(files(), 3);
}

TEST_F(StepFile, LeavesAnExistingFileWhenItFails) {
  std::ofstream(path_) << "old";
  conversion::PatchSet bad = testing::rectangle(6.0, 4.0);
  bad.patches[0].control_points[7].z() = std::nan("");
  EXPECT_THROW(write_step(bad, path_), std::invalid_argument);
  EXPECT_THROW(write_step(conversion::PatchSet{}, path_), std::invalid_argument);
  EXPECT_EQ(text(), "old");
  EXPECT_EQ(files(), 1);
}

// Far below what Open CASCADE tells apart (1e-10 m): it drops the edges.
TEST_F(StepFile, RefusesWhatWouldNotBeReadBack) {
  const conversion::PatchSet set =
      testing::sheet(2, 2, [](double s, double t) { return Vector3d(1e-11 * s, 1e-11 * t, 0); });
  try {
    write_step(set, path_);
    FAIL() << "was written";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("0 of 8 free edges"), std::string::npos)
        << error.what();
  }
  EXPECT_EQ(files(), 0);
}

TEST_F(StepFile, NeedsAFolderToGoTo) {
  const conversion::PatchSet set = testing::rectangle(6.0, 4.0);
  EXPECT_THROW(write_step(set, (folder_ / "none" / "hull.step").string()), files::FileError);
  EXPECT_THROW(write_step(set, folder_.string()), files::FileError);
  EXPECT_EQ(files(), 0);
}

TEST_F(StepFile, ReadingRefusesWhatIsNoStepFile) {
  std::ofstream(path_) << "solid cube\nendsolid\n";
  EXPECT_THROW(read_cad_report(path_), files::FileError);
  std::ofstream(path_, std::ios::trunc);
  EXPECT_THROW(read_cad_report(path_), files::FileError);
  EXPECT_THROW(read_cad_report(folder_.string()), files::FileError);
}

}  // namespace
}  // namespace hull::exchange
