// SPDX-License-Identifier: GPL-3.0-or-later
// What STEP and IGES files have in common, each test for both.
#include "exchange/cad_file.h"

#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include "conversion/per_cell/per_cell.h"
#include "conversion/sheets.h"
#include "exchange/iges_file.h"
#include "exchange/step/step_file.h"
#include "files/atomic_file.h"
#include "test_meshes.h"

namespace hull::exchange {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

struct Format {
  const char* name;
  CadReport (*write)(const conversion::PatchSet&, const std::string&, const CadOptions&);
};

class CadFile : public ::testing::TestWithParam<Format> {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("hull_cad_" + std::to_string(getpid()));
    fs::create_directory(folder_);
    path_ = (folder_ / "hull.cad").string();
  }
  void TearDown() override { fs::remove_all(folder_); }

  CadReport write(const conversion::PatchSet& set, const CadOptions& options = {}) const {
    return GetParam().write(set, path_, options);
  }
  // What is said instead of writing.
  std::string refusal(const conversion::PatchSet& set, const std::string& path,
                      const CadOptions& options = {}) const {
    try {
      GetParam().write(set, path, options);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  }
  std::string text() const {
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  int files() const { return static_cast<int>(std::distance(fs::directory_iterator(folder_), {})); }

  fs::path folder_;
  std::string path_;
};

// Half a boat of 20 x 3 x 2 m on the side y < 0, t = 0 its keel and t = 1 the deck's edge.
conversion::PatchSet half_boat(double sheer) {
  return testing::sheet(4, 3, [&](double s, double t) {
    const double x = 20.0 * s, z = t * t * (2.0 + sheer * s * s);
    return Vector3d(x, s == 1.0 || t == 0.0 ? 0.0 : -3.0 * t * (1.0 - s * s), z);
  });
}

TEST_P(CadFile, OfAHalfCanBeAClosedSolid) {
  for (double sheer : {0.0, 0.5}) {
    const CadReport half = write(half_boat(sheer), {.solid = true});
    EXPECT_TRUE(half.valid);
    EXPECT_TRUE(half.closed);
    EXPECT_EQ(half.solids, 1);
    EXPECT_EQ(half.faces, 12 + (sheer > 0.0 ? 4 : 1) + 2);
    const CadReport whole = write(half_boat(sheer), {.mirrored = true, .solid = true});
    EXPECT_TRUE(whole.valid);
    EXPECT_TRUE(whole.closed);
    EXPECT_EQ(whole.solids, 1);
    EXPECT_EQ(whole.faces, 24 + (sheer > 0.0 ? 4 : 1) + 1);
    ASSERT_TRUE(half.volume && whole.volume);
    EXPECT_GT(*half.volume, 0.0);
    EXPECT_NEAR(*whole.volume, 2.0 * *half.volume, 1e-9 * *half.volume);
    // The volume is ∫ |y| dx dz over the centre plane, whatever closes the hull.
    const CadReport shell = write(half_boat(sheer), {.mirrored = true});
    EXPECT_FALSE(shell.closed);
    EXPECT_EQ(shell.solids, 0);
    EXPECT_LT(shell.area, whole.area);
  }
}

// A box of known volume, open at the top and at the centre plane.
TEST_P(CadFile, OfABoxHasItsVolume) {
  mesh::MeshArrays half;
  half.points = {{-1, 0, -1}, {1, 0, -1}, {1, 1, -1}, {-1, 1, -1},
                 {-1, 0, 1},  {1, 0, 1},  {1, 1, 1},  {-1, 1, 1}};
  half.face_sizes = {4, 4, 4, 4};
  half.face_vertices = {0, 3, 2, 1, 3, 7, 6, 2, 0, 4, 7, 3, 1, 2, 6, 5};
  half.creases = {{0, 3}, {1, 2}, {2, 3}, {3, 7}, {2, 6}};
  const conversion::PatchSet set =
      conversion::fit_per_cell(surface::LimitSurface(mesh::ControlMesh(half)), 4);
  const CadReport one = write(set, {.solid = true});
  EXPECT_EQ(one.solids, 1);
  EXPECT_NEAR(one.volume.value_or(0.0), 4.0, 1e-9);
  EXPECT_NEAR(one.area, 16.0, 1e-9);
  const CadReport both = write(set, {.mirrored = true, .solid = true});
  EXPECT_EQ(both.solids, 1);
  EXPECT_NEAR(both.volume.value_or(0.0), 8.0, 1e-9);
  EXPECT_NEAR(both.area, 24.0, 1e-9);
  // By their shape: the sides are flat, the ends furthest aft are a transom.
  std::vector<std::string> names;
  for (const CadRegion& region : both.regions) names.push_back(region.name);
  EXPECT_EQ(names,
            (std::vector<std::string>{"deck", "flat bottom", "flat side", "shell", "transom"}));
}

TEST_P(CadFile, OfAClosedSurfaceStaysAsItIs) {
  const conversion::PatchSet set =
      conversion::fit_per_cell(surface::LimitSurface(mesh::ControlMesh(testing::cube())), 5);
  const CadReport report = write(set, {.solid = true});
  EXPECT_EQ(report.solids, 1);
  EXPECT_EQ(report.faces, 24);
  EXPECT_GT(report.volume.value_or(-1.0), 0.0);
}

TEST_P(CadFile, RefusesASolidThatCannotBe) {
  const conversion::PatchSet bent = testing::sheet(
      2, 2, [](double s, double t) { return Vector3d(s, 1 + t, s * t + s * s * t); });
  EXPECT_NE(refusal(bent, path_, {.solid = true}).find("neither flat nor symmetric"),
            std::string::npos);
  conversion::PatchSet inside_out =
      conversion::fit_per_cell(surface::LimitSurface(mesh::ControlMesh(testing::cube())), 5);
  std::vector<conversion::BSplinePatch> turned;
  for (const conversion::BSplinePatch& patch : inside_out.patches) {
    turned.push_back(patch.transposed());
  }
  EXPECT_NE(refusal(testing::joined(turned), path_, {.solid = true}).find("point inwards"),
            std::string::npos);
  EXPECT_EQ(files(), 0);
}

TEST_P(CadFile, KeepsUnitsAndSize) {
  for (const char* unit : {"m", "cm", "mm", "ft", "in"}) {
    const CadReport report =
        write(testing::rectangle(6.0, 4.0, 3, 2), {.unit = cad_unit_from(unit)});
    EXPECT_EQ(report.unit, unit);
    EXPECT_NEAR(report.area, 24.0, 1e-9) << unit;
    EXPECT_LT((report.box_max - Vector3d(6, 4, 0)).norm(), 1e-9) << unit;
  }
  EXPECT_THROW(cad_unit_from("furlong"), std::invalid_argument);
}

TEST_P(CadFile, KeepsNamesInAnyScript) {
  const std::string name = "Fähre 'Süd' \\ 漢字 ⛵🚢";
  EXPECT_EQ(write(testing::rectangle(6.0, 4.0), {.name = name}).product, name);
  for (char c : text()) ASSERT_TRUE(c == '\n' || (c >= ' ' && c < 127));
}

TEST_P(CadFile, KeepsRegionsLayersAndColours) {
  const conversion::PatchSet set = testing::rectangle(6.0, 4.0, 3, 2);
  CadOptions options;
  options.regions = {"grün", "grün", "", "a", "a", "a"};
  options.colours["a"] = {1.0, 0.0, 0.25};
  const CadReport report = write(set, options);
  ASSERT_EQ(report.regions.size(), 3u);
  EXPECT_EQ(report.regions[0].name, "a");
  EXPECT_EQ(report.regions[0].faces, 3);
  EXPECT_NEAR(report.regions[0].area, 12.0, 1e-9);
  ASSERT_TRUE(report.regions[0].colour.has_value());
  EXPECT_NEAR((*report.regions[0].colour)[2], 0.25, 1e-9);
  EXPECT_EQ(report.regions[1].name, "grün");
  EXPECT_EQ(report.regions[2].name, "shell");
  EXPECT_EQ(report.layers, (std::vector<std::string>{"a", "grün", "shell"}));
  options.regions.pop_back();
  EXPECT_NE(refusal(set, path_, options).find("6 patches"), std::string::npos);
}

TEST_P(CadFile, HasCurvesOnLayers) {
  CadOptions options;
  options.mirrored = true;
  const conversion::BSplineCurve line{1, {0, 0, 2, 2}, {{0, 0, 0}, {20, 0, 0}}};
  const conversion::BSplineCurve arc{3,
                                     {-1, 0, 0.5, 1, 2, 3, 4, 5, 5.5},
                                     {{1, -1, 0}, {2, -2, 1}, {3, -1, 0}, {4, -1, 2}, {5, -1, 0}}};
  options.curves = {{"keel", "centre line", line}, {"bilge 'ü'", "features", arc}};
  const CadReport report = write(half_boat(0.5), options);
  EXPECT_EQ(report.curves, 3);  // the keel has no image
  EXPECT_EQ(report.layers, (std::vector<std::string>{"centre line", "features", "shell"}));
  options.curves[1].curve.knots.pop_back();
  EXPECT_NE(refusal(half_boat(0.5), path_, options).find("bilge"), std::string::npos);
}

TEST_P(CadFile, TellsItsProgressAndCanBeCancelledAtAnyTime) {
  std::vector<double> shares;
  CadOptions options;
  options.solid = true;
  options.progress = [&](double share) { shares.push_back(share); };
  write(half_boat(0.5), options);
  ASSERT_GT(shares.size(), 5u);
  EXPECT_EQ(shares.front(), 0.0);
  EXPECT_EQ(shares.back(), 1.0);
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  std::ofstream(path_) << "old";
  for (std::size_t i = 0; i < shares.size(); i += shares.size() / 12 + 1) {
    const double end = shares[i];
    options.progress = [&](double share) {
      if (share >= end) throw std::invalid_argument("cancelled");
    };
    ASSERT_EQ(refusal(half_boat(0.5), path_, options), "cancelled") << end;
    ASSERT_EQ(text(), "old");
    ASSERT_EQ(files(), 1);
  }
}

TEST_P(CadFile, NeedsAFolderToGoTo) {
  const conversion::PatchSet set = testing::rectangle(6.0, 4.0);
  const std::string none = (folder_ / "none" / "hull.cad").string();
  EXPECT_NE(refusal(set, none).find("there is no folder"), std::string::npos);
  EXPECT_NE(refusal(set, folder_.string()).find("it is a folder"), std::string::npos);
  std::ofstream(folder_ / "file") << "x";
  const std::string within = (folder_ / "file" / "hull.cad").string();
  EXPECT_NE(refusal(set, within).find("there is no folder"), std::string::npos);
  EXPECT_EQ(files(), 1);
}

TEST_P(CadFile, OfWhichNoTextCanBeMadeIsNamed) {
  const auto none = [](const CadModel&, const CadOptions&,
                       const surface::Progress&) -> std::string {
    throw NoCadText("for no reason");
  };
  try {
    write_cad_file(testing::rectangle(6.0, 4.0), path_, {}, none);
    FAIL() << "a file without text";
  } catch (const files::FileError& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find("\"" + path_ + "\": for no reason"), std::string::npos) << said;
  }
  EXPECT_EQ(files(), 0);
}

// A file system with room for 64 kB, or one that is read only; false where we may not make one.
bool mounted(const fs::path& folder, const char* options, unsigned long flags) {
  fs::create_directory(folder);
  return mount("none", folder.c_str(), "tmpfs", flags, options) == 0;
}

TEST_P(CadFile, IsNotThereWhenTheDiskIsFull) {
  const fs::path disk = folder_ / "disk";
  if (!mounted(disk, "size=16k", 0)) GTEST_SKIP() << "file systems can't be made by this user";
  const std::string path = (disk / "hull.cad").string();
  std::ofstream(path) << "old";
  const std::string said = refusal(half_boat(0.5), path);
  std::ifstream file(path);
  std::string old;
  file >> old;
  const auto count = std::distance(fs::directory_iterator(disk), {});
  file.close();
  umount(disk.c_str());
  EXPECT_NE(said.find("No space left"), std::string::npos) << said;
  EXPECT_NE(said.find(path), std::string::npos) << said;
  EXPECT_EQ(old, "old");
  EXPECT_EQ(count, 1);
}

TEST_P(CadFile, IsNotThereWhereNothingMayBeWritten) {
  const fs::path disk = folder_ / "disk";
  if (!mounted(disk, "size=64k", MS_RDONLY)) {
    GTEST_SKIP() << "file systems can't be made by this user";
  }
  const std::string said = refusal(half_boat(0.5), (disk / "hull.cad").string());
  umount(disk.c_str());
  EXPECT_NE(said.find("Read-only file system"), std::string::npos) << said;
}

// The limit of a file's size, as a quota has it.
TEST_P(CadFile, IsNotThereWhenTheQuotaIsUsedUp) {
  std::ofstream(path_) << "old";
  rlimit limit{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &limit), 0);
  const rlimit small{20000, limit.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string said = refusal(half_boat(0.5), path_);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(said.find("File too large"), std::string::npos) << said;
  EXPECT_EQ(text(), "old");
  EXPECT_EQ(files(), 1);
}

INSTANTIATE_TEST_SUITE_P(Formats, CadFile,
                         ::testing::Values(Format{"Step", write_step}, Format{"Iges", write_iges}),
                         [](const auto& format) { return std::string(format.param.name); });

TEST(CadReport, TellsFormatsApart) {
  const fs::path folder = fs::temp_directory_path() / ("hull_report_" + std::to_string(getpid()));
  fs::create_directory(folder);
  const std::string path = (folder / "hull").string();
  const conversion::PatchSet set = testing::rectangle(6.0, 4.0);
  write_step(set, path);
  EXPECT_EQ(read_cad_report(path).format, "STEP AP214");
  write_step(set, path, {.schema = StepSchema::kAp242});
  EXPECT_EQ(read_cad_report(path).format, "STEP AP242");
  write_iges(set, path);
  EXPECT_EQ(read_cad_report(path).format, "IGES 5.3");
  EXPECT_EQ(read_cad_report(path).bytes, fs::file_size(path));
  std::ofstream(path) << "solid cube\nendsolid\n";
  EXPECT_THROW(read_cad_report(path), files::FileError);
  // One whose kind can't be told.
  EXPECT_THROW(read_cad_report((folder / std::string(300, 'a')).string()), files::FileError);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace hull::exchange
