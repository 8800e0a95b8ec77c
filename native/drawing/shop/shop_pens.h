// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drawing/paper/pens.h"
#include "drawing/shop/shop_drawing.h"

namespace hull::drawing {

struct ShopPen {
  Pen pen;
  int colour;  // of AutoCAD
};

ShopPen shop_pen(ShopLayer layer);

}  // namespace hull::drawing
