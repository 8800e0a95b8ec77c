// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <optional>
#include <string>
#include <vector>

#include "exchange/cad_options.h"
#include "surface/progress.h"

namespace hull::exchange {

// A layer's shapes that were found again, with their colours.
struct CadLayer {
  struct Member {
    TopoDS_Shape shape;
    std::optional<analysis::Colour> colour;
  };
  std::string name;
  std::vector<Member> members;
};

// A shape that the file gives a name.
struct CadName {
  std::string name;
  TopoDS_Shape shape;
};

// What a file of one of the formats gives. The shape is null if there is none.
struct CadContent {
  std::string format, unit, product;
  TopoDS_Shape shape;  // in millimetres
  std::vector<CadLayer> layers;
  std::vector<CadName> names;
};

// REQUIRES of both: an OcctSession lives. Throw FileError, with `refusal` in front, if the file is
// not of the format.
CadContent read_step(const std::string& path, const std::string& refusal,
                     const surface::Progress& progress);
CadContent read_iges(const std::string& path, const std::string& refusal,
                     const surface::Progress& progress);

// Of the format that the file's own beginning tells. Throws FileError likewise, and for a file that
// can't be read, is of neither format, or holds no shape that Open CASCADE can translate.
CadContent read_cad_content(const std::string& path, const std::string& refusal,
                            const surface::Progress& progress);

}  // namespace hull::exchange
