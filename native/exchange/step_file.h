// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "conversion/patch_set.h"
#include "exchange/step_report.h"

namespace hull {

struct StepOptions {
  std::string name = "hull";  // of the product, UTF-8
  bool mirrored = false;      // write the mirror image on y = 0 too, joined along the centre line
};

// Writes patches as a STEP file (AP214, length unit metre): one shell, a closed one as a solid,
// several where the patches fall into parts that share no edge. Each patch is one face, its normal
// outwards; joined patches share their edge.
//
// The text is read back before the file is written and must hold what was meant: every face, valid,
// free edges where the patches have borders and nowhere else. That report is returned. The file is
// then complete or not there at all; one that was there is replaced only by a complete one.
//
// Throws std::invalid_argument if the patches do not fit together, all lack area, or what is read
// back is not what was meant; FileError if the file can't be written. Open CASCADE serves one
// caller at a time: calls from several threads wait for one another.
StepReport write_step(const PatchSet& patches, const std::string& path,
                      const StepOptions& options = {});

}  // namespace hull
