// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/eigenbasis/basis_cache.h"

#include "surface/eigenbasis/local_matrix.h"

namespace hull::surface {

std::shared_ptr<const CornerBasis> BasisCache::get(const CornerKey& key) {
  // Held while a basis is made: who asks for the same one waits rather than makes it again.
  const std::lock_guard lock(mutex_);
  std::shared_ptr<const CornerBasis>& basis = bases_[key];
  if (basis) return basis;
  const LocalMatrices local = local_matrices(key);
  CornerKey fan = key;
  fan.cell = 0;
  std::shared_ptr<const DominantSpectrum>& spectrum = spectra_[fan];
  if (!spectrum) spectrum = std::make_shared<const DominantSpectrum>(ring_spectrum(key, local));
  basis = std::make_shared<const CornerBasis>(key, local, spectrum);
  return basis;
}

}  // namespace hull::surface
