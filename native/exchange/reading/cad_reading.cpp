// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/reading/cad_reading.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "files/atomic_file.h"

namespace hull::exchange {
namespace {

// The first line of a file that is not too long for one of text.
std::string first_line(const std::string& path, const std::string& refusal) {
  // What can't even be looked at is not opened either, and that says why.
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw files::FileError(refusal + "it is a folder");
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) throw files::FileError(refusal + std::strerror(errno));
  // As long as a line of IGES: enough to tell either format.
  std::string line(80, ' ');
  file.read(line.data(), static_cast<std::streamsize>(line.size()));
  line.resize(static_cast<std::size_t>(file.gcount()));
  return line;
}

CadContent content_of_format(const std::string& path, const std::string& refusal,
                             const surface::Progress& progress) {
  const std::string line = first_line(path, refusal);
  if (line.find("ISO-10303-21") != line.npos) return read_step(path, refusal, progress);
  // Lines of IGES name their section in column 73.
  if (line.size() > 72 && line[72] == 'S') return read_iges(path, refusal, progress);
  throw files::FileError(refusal + "it is neither a STEP nor an IGES file");
}

}  // namespace

CadContent read_cad_content(const std::string& path, const std::string& refusal,
                            const surface::Progress& progress) {
  CadContent content = content_of_format(path, refusal, progress);
  if (content.shape.IsNull()) throw files::FileError(refusal + "it holds no shape");
  return content;
}

}  // namespace hull::exchange
