// SPDX-License-Identifier: GPL-3.0-or-later
// A sheet into a file: PDF, SVG or PNG, chosen by the file's extension.
#pragma once

#include <string>
#include <vector>

#include "drawing/paper/sheet.h"

namespace hull::drawing {

// Writes `sheet` to `path`, at true size for `.pdf` and `.svg`, at 8 dots per millimetre (fewer for
// sheets above A2, so that no side exceeds 5000 dots) for `.png`; the extension's case is ignored.
//
// The file is complete or absent: it is written beside its final name and renamed, so a failure
// leaves an existing file as it was.
//
// Throws std::invalid_argument for another extension, std::runtime_error when the folder is
// missing, not writable or full.
void write_sheet(const Sheet& sheet, const std::string& path);

// Writes sheets as the pages of one `.pdf`, in the same way; each has its own size. Throws as
// write_sheet(), and std::invalid_argument for another extension and for no sheets.
void write_sheets(const std::vector<Sheet>& sheets, const std::string& path);

// Throws std::invalid_argument unless the extension of `path` is one of the above. For callers that
// would rather know before a long computation.
void check_drawing_path(const std::string& path);

}  // namespace hull::drawing
