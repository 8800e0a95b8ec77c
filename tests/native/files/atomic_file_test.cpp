// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace hull::files {
namespace {

namespace fs = std::filesystem;

class WriteFileAtomically : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("hull_files_" + std::to_string(getpid()));
    fs::create_directory(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string in_folder(const std::string& name) const { return (folder_ / name).string(); }
  static std::string text(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  int files() const { return static_cast<int>(std::distance(fs::directory_iterator(folder_), {})); }
  static std::string refusal(const std::string& path, const std::string& bytes = "new") {
    try {
      write_file_atomically(path, bytes);
    } catch (const FileError& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_;
};

TEST_F(WriteFileAtomically, WritesBytesAsTheyAre) {
  const std::string bytes("a\0b\r\n\xff", 6);
  write_file_atomically(in_folder("f"), bytes);
  EXPECT_EQ(text(in_folder("f")), bytes);
  EXPECT_EQ(files(), 1);
}

TEST_F(WriteFileAtomically, TakesTheLongestNameThereIs) {
  const std::string longest(255, 'n');
  write_file_atomically(in_folder(longest), "new");
  EXPECT_EQ(text(in_folder(longest)), "new");
  EXPECT_EQ(files(), 1);
}

TEST_F(WriteFileAtomically, SaysWhatIsWrongWithAName) {
  EXPECT_NE(refusal(in_folder(std::string(256, 'n'))).find("the name is too long; shorten it"),
            std::string::npos);
  EXPECT_NE(refusal(in_folder("two\nlines")).find("can't have line breaks"), std::string::npos);
  EXPECT_EQ(files(), 0);
}

TEST_F(WriteFileAtomically, ReplacesAFileAndKeepsItsMode) {
  write_file_atomically(in_folder("f"), "a longer old text");
  ASSERT_EQ(chmod(in_folder("f").c_str(), 0640), 0);
  write_file_atomically(in_folder("f"), "new");
  EXPECT_EQ(text(in_folder("f")), "new");
  EXPECT_EQ(fs::status(in_folder("f")).permissions(), static_cast<fs::perms>(0640));
  EXPECT_EQ(files(), 1);
}

TEST_F(WriteFileAtomically, WritesThroughALink) {
  write_file_atomically(in_folder("f"), "old");
  fs::create_symlink("f", in_folder("link"));
  write_file_atomically(in_folder("link"), "new");
  EXPECT_TRUE(fs::is_symlink(in_folder("link")));
  EXPECT_EQ(text(in_folder("f")), "new");
}

TEST_F(WriteFileAtomically, WritesThroughLinksToWhatIsNotThere) {
  fs::create_directory(in_folder("d"));
  fs::create_symlink("d/new", in_folder("second"));
  fs::create_symlink("second", in_folder("first"));
  write_file_atomically(in_folder("first"), "new");
  EXPECT_TRUE(fs::is_symlink(in_folder("first")));
  EXPECT_TRUE(fs::is_symlink(in_folder("second")));
  EXPECT_EQ(text(in_folder("d/new")), "new");
  fs::create_symlink("nowhere/new", in_folder("lost"));
  EXPECT_NE(refusal(in_folder("lost")).find("there is no folder"), std::string::npos);
  fs::create_symlink("ring", in_folder("ring"));
  EXPECT_NE(refusal(in_folder("ring")), "");
  EXPECT_TRUE(fs::is_symlink(in_folder("ring")));
}

TEST_F(WriteFileAtomically, LeavesPipesAndWhatPointsToThem) {
  ASSERT_EQ(mkfifo(in_folder("pipe").c_str(), 0600), 0);
  fs::create_symlink("pipe", in_folder("link"));
  for (const char* name : {"pipe", "link"}) {
    EXPECT_NE(refusal(in_folder(name)).find("it is a device or pipe and no file; give another"),
              std::string::npos);
  }
  EXPECT_TRUE(fs::is_fifo(in_folder("pipe")));
  EXPECT_EQ(files(), 2);
}

TEST_F(WriteFileAtomically, TakesNamesInAnyScript) {
  write_file_atomically(in_folder("Fähre 漢字 'x'.step"), "new");
  EXPECT_EQ(text(in_folder("Fähre 漢字 'x'.step")), "new");
}

TEST_F(WriteFileAtomically, SaysThatTheFolderIsMissing) {
  const std::string path = in_folder("none/f");
  EXPECT_NE(refusal(path).find(path), std::string::npos);
  EXPECT_NE(refusal(path).find("there is no folder"), std::string::npos);
  EXPECT_EQ(files(), 0);
}

TEST_F(WriteFileAtomically, RefusesAFolder) {
  fs::create_directory(in_folder("d"));
  EXPECT_NE(refusal(in_folder("d")).find("it is a folder"), std::string::npos);
  EXPECT_NE(refusal(in_folder("d") + "/").find("it is a folder"), std::string::npos);
  EXPECT_NE(refusal(""), "");
  EXPECT_TRUE(fs::is_empty(in_folder("d")));
}

// Root may write anywhere, but nobody below a file.
TEST_F(WriteFileAtomically, SaysThatTheFolderCannotBeWrittenTo) {
  write_file_atomically(in_folder("f"), "old");
  EXPECT_NE(refusal(in_folder("f") + "/g"), "");
  EXPECT_EQ(text(in_folder("f")), "old");
  if (geteuid() == 0) return;
  fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
  const std::string message = refusal(in_folder("f"));
  fs::permissions(folder_, fs::perms::owner_all);
  EXPECT_NE(message.find("ermission"), std::string::npos) << message;
  EXPECT_EQ(text(in_folder("f")), "old");
}

// A limit on the size of files stands for a full disk.
TEST_F(WriteFileAtomically, LeavesTheOldFileWhenThereIsNoRoom) {
  write_file_atomically(in_folder("f"), "old");
  rlimit usual{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &usual), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{4096, usual.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string message = refusal(in_folder("f"), std::string(10000, 'x'));
  setrlimit(RLIMIT_FSIZE, &usual);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(message.find("; free some space, or choose another folder"), std::string::npos);
  EXPECT_EQ(text(in_folder("f")), "old");
  EXPECT_EQ(files(), 1);
}

}  // namespace
}  // namespace hull::files
