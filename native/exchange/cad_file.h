// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include "conversion/patches/patch_set.h"
#include "exchange/cad_options.h"
#include "exchange/cad_report.h"

namespace hull::exchange {

struct CadModel;

// Why a text could not be made; write_cad_file() names the file.
class NoCadText : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Makes the text of a file, or throws NoCadText; it may call the progress with shares of its own
// from 0 to 1.
using CadText = std::function<std::string(const CadModel&, const CadOptions&,
                                          const surface::Progress& progress)>;

// What write_step() and write_iges() have in common: makes the model, its text, the file beside the
// one at `path`, reads that back, compares, and puts it into its place.
CadReport write_cad_file(const conversion::PatchSet& patches, const std::string& path,
                         const CadOptions& options, const CadText& text_of);

}  // namespace hull::exchange
