// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <mutex>

#include "surface/eigenbasis/corner_basis.h"

namespace hull::surface {

// The bases of irregular corners by topology, each built once. May be shared by any number of
// surfaces and threads.
class BasisCache {
 public:
  std::shared_ptr<const CornerBasis> get(const CornerKey& key);

 private:
  std::mutex mutex_;
  std::map<CornerKey, std::shared_ptr<const CornerBasis>> bases_;
  // Of the rings, the same for all cells of a fan: by the key of the fan's first cell.
  std::map<CornerKey, std::shared_ptr<const DominantSpectrum>> spectra_;
};

}  // namespace hull::surface
