// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace hull::files {

// A file could not be read or written; what() names it and says why.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A file that takes the place of the one at `path` when it is complete: until then its bytes are in
// a new file beside it, which is gone with this object. A symbolic link stays one: the file it
// points to is replaced, or made.
class ReplacingFile {
 public:
  // Throws FileError if the folder does not exist or can't be written to, or `path` is a folder,
  // a device or a pipe.
  explicit ReplacingFile(const std::string& path);
  ~ReplacingFile();
  ReplacingFile(const ReplacingFile&) = delete;
  ReplacingFile& operator=(const ReplacingFile&) = delete;

  // Of the new file, to be read by others after write().
  const std::string& name() const;
  // Throws FileError if the disk is full.
  void write(std::string_view bytes);
  // Forces the bytes to the disk and renames the new file. Throws FileError if that fails.
  void replace();

 private:
  class NewFile;
  std::string path_, target_;
  std::unique_ptr<NewFile> file_;
};

// Makes the file at `path` hold `bytes`, completely or not at all: they are written
// as a ReplacingFile.
//
// Throws FileError, leaving nothing behind and a file that was there untouched, if the folder does
// not exist or can't be written to, if `path` is there and no regular file, or if the disk is full.
void write_file_atomically(const std::string& path, std::string_view bytes);

}  // namespace hull::files
