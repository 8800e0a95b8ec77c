// SPDX-License-Identifier: GPL-3.0-or-later
// The last section of a DXF file: the objects that are not drawn.
#pragma once

class DL_WriterA;

namespace hull::dxf {

// Writes the section OBJECTS with what readers of release 2000 look for: the root dictionary and
// in it groups (none), the layouts of model and paper, the standard multiline, plot settings (none)
// and the plot style. Each object names its owner, as the format asks (group code 330); dxflib's
// own writeObjects() leaves that out.
//
// REQUIRES: the blocks' records are those of dxflib's writeBlockRecord(), which name the layouts.
void write_dxf_objects(DL_WriterA& file);

}  // namespace hull::dxf
