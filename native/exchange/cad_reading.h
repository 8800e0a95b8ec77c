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
    std::optional<Colour> colour;
  };
  std::string name;
  std::vector<Member> members;
};

// What a file of one of the formats gives. The shape is null if there is none.
struct CadContent {
  std::string format, unit, product;
  TopoDS_Shape shape;  // in millimetres
  std::vector<CadLayer> layers;
};

// REQUIRES of both: an OcctSession lives. Throw FileError, with `refusal` in front, if the file is
// not of the format.
CadContent read_step(const std::string& path, const std::string& refusal,
                     const surface::Progress& progress);
CadContent read_iges(const std::string& path, const std::string& refusal,
                     const surface::Progress& progress);

}  // namespace hull::exchange
