// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "conversion/patches/patch_set.h"
#include "exchange/cad_report.h"

namespace hull::exchange {

// Writes patches as an IGES 5.3 file of B-rep entities: one manifold solid (186) or shell (514) of
// faces (510) that share their edges (504), as write_step() does; `schema` does not matter. Regions
// are levels, with a level function property (406, form 3) that has the name; colours are color
// definitions (314); curves are B-spline curves (126) with a name property (406, form 15).
//
// IGES is ASCII: characters beyond it are written as in STEP files, \X2\hhhh\X0\.
CadReport write_iges(const conversion::PatchSet& patches, const std::string& path,
                     const CadOptions& options = {});

}  // namespace hull::exchange
