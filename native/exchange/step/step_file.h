// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "conversion/patches/patch_set.h"
#include "exchange/cad_report.h"

namespace hull::exchange {

// Writes patches as a STEP file: one shell, a closed one as a solid, several where the patches fall
// into parts that share no edge. Each patch is one face, its normal outwards; joined patches share
// their edge. Faces are on the layer of their region and have its colour; curves are products of
// their own.
//
// The file is read back before it takes its name and must hold what was meant: every face, valid,
// free edges where the patches have borders and nowhere else, a solid where one is asked for, the
// size, unit, names, layers, colours and curves. That report is returned. The file is then complete
// or not there at all; one that was there is replaced only by a complete one.
//
// Throws std::invalid_argument if the patches do not fit together, all lack area, can't be closed
// where a solid is asked for, or what is read back is not what was meant; FileError if the file
// can't be written. Open CASCADE serves one caller at a time: calls from several threads wait for
// one another.
CadReport write_step(const conversion::PatchSet& patches, const std::string& path,
                     const CadOptions& options = {});

}  // namespace hull::exchange
