// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/paper/canvas.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "hand_made_hulls.h"

namespace hull::drawing {
namespace {

namespace fs = std::filesystem;

class Canvas : public ::testing::Test {
 protected:
  Canvas() : folder_(fs::temp_directory_path() / ("hull_canvas_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~Canvas() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  static std::string content(const std::string& name) {
    std::ifstream file(name, std::ios::binary);
    return (std::ostringstream() << file.rdbuf()).str();
  }
  std::size_t file_count() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  const LinesSheet sheet_ = lay_out_lines(test::Wigley{}.lines());
  fs::path folder_;
};

TEST_F(Canvas, WritesEveryKind) {
  for (const auto& [name, magic] :
       {std::pair("a.pdf", "%PDF"), std::pair("a.svg", "<?xml"), std::pair("a.PNG", "\x89PNG")}) {
    write_sheet(sheet_, path(name));
    EXPECT_EQ(content(path(name)).rfind(magic, 0), 0u) << name;
  }
  EXPECT_EQ(file_count(), 3u);  // nothing temporary is left
}

TEST_F(Canvas, SvgHasTrueSize) {
  write_sheet(sheet_, path("a.svg"));
  const std::string text = content(path("a.svg"));
  // A3 in points, as Cairo writes them, or in millimetres.
  EXPECT_TRUE(text.find("width=\"1190.5") != std::string::npos ||
              text.find("width=\"420mm\"") != std::string::npos)
      << text.substr(0, 300);
}

TEST_F(Canvas, RefusesOtherExtensions) {
  EXPECT_THROW(write_sheet(sheet_, path("a.dwg")), std::invalid_argument);
  EXPECT_THROW(check_drawing_path("plan"), std::invalid_argument);
  EXPECT_NO_THROW(check_drawing_path("plan.svg"));
  EXPECT_EQ(file_count(), 0u);
}

TEST_F(Canvas, FailureLeavesTheOldFile) {
  EXPECT_THROW(write_sheet(sheet_, path("missing/a.svg")), std::runtime_error);
  // A folder in the place of the file can't be replaced by one.
  fs::create_directories(path("b.svg/inside"));
  EXPECT_THROW(write_sheet(sheet_, path("b.svg")), std::runtime_error);
  EXPECT_TRUE(fs::is_directory(path("b.svg/inside")));
  EXPECT_EQ(file_count(), 1u);
}

}  // namespace
}  // namespace hull::drawing
