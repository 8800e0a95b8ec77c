// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace hull {

// A file could not be read or written; what() names it and says why.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Makes the file at `path` hold `bytes`, completely or not at all: they go to a new file beside it,
// which is forced to the disk and then renamed over `path`. A symbolic link stays one: the file it
// points to is replaced.
//
// Throws FileError, leaving nothing behind and a file that was there untouched, if the folder does
// not exist or can't be written to, if `path` is a folder, or if the disk is full.
void write_file_atomically(const std::string& path, std::string_view bytes);

}  // namespace hull
