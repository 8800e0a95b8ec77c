// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/basis_cache.h"

namespace hull {

std::shared_ptr<const CornerBasis> BasisCache::get(const CornerKey& key) {
  const std::lock_guard lock(mutex_);
  std::shared_ptr<const CornerBasis>& basis = bases_[key];
  if (!basis) basis = std::make_shared<const CornerBasis>(key);
  return basis;
}

}  // namespace hull
