// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/shop/shop_pens.h"

#include <stdexcept>

namespace hull::drawing {
namespace {

constexpr ShopLayer kLayers[] = {ShopLayer::kOutline,  ShopLayer::kFrames, ShopLayer::kWaterlines,
                                 ShopLayer::kButtocks, ShopLayer::kSeams,  ShopLayer::kRolling,
                                 ShopLayer::kShell,    ShopLayer::kBase,   ShopLayer::kStretch,
                                 ShopLayer::kHidden};

}  // namespace

ShopPen shop_pen(ShopLayer layer) {
  switch (layer) {
    case ShopLayer::kOutline:
      return {{0.50, inks::kBlack, {}, "OUTLINE"}, 7};
    case ShopLayer::kFrames:
      return {{0.25, inks::kStation, {}, "FRAMES"}, 5};
    case ShopLayer::kWaterlines:
      return {{0.25, inks::kWaterline, {}, "WATERLINES"}, 3};
    case ShopLayer::kButtocks:
      return {{0.25, inks::kButtock, {}, "BUTTOCKS"}, 1};
    case ShopLayer::kSeams:
      return {{0.35, inks::kDiagonal, {}, "SEAMS"}, 6};
    case ShopLayer::kRolling:
      return {{0.25, inks::kBlack, pens::kChain, "ROLLING"}, 7};
    case ShopLayer::kShell:
      return {{0.50, inks::kBlack, {}, "SHELL"}, 7};
    case ShopLayer::kBase:
      return {{0.18, inks::kGrey, {}, "BASE"}, 8};
    case ShopLayer::kStretch:
      return {{0.13, inks::kGrey, {}, "STRETCH"}, 8};
    case ShopLayer::kHidden:
      return {{0.13, inks::kGrey, {1.5, 0.8, 1.5, 0.8}, "HIDDEN"}, 8};
  }
  throw std::logic_error("a layer without a pen");
}

ShopLayer shop_layer(const std::string& name) {
  std::string known;
  for (const ShopLayer layer : kLayers) {
    // The pens alone know the names, so none can differ from the file's.
    const std::string_view own = shop_pen(layer).pen.layer;
    if (own == name) return layer;
    known += (known.empty() ? "" : ", ") + std::string(own);
  }
  throw std::invalid_argument("A layer of shop drawings is one of " + known + ", not " + name +
                              ".");
}

}  // namespace hull::drawing
