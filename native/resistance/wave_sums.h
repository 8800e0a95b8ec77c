// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <limits>
#include <map>
#include <span>
#include <vector>

#include "resistance/source_grid.h"

namespace hull::resistance {

// A wave that was summed: its k, K, amplitude I and how much |I|² counts in the integral.
struct SummedWave {
  double along, decay, weight;
  std::complex<double> amplitude;
};

// ∫₁^∞ |I|² λ² / √(λ² - 1) dλ, as far as it was taken: to λ = shortest. Its error, infinite before
// there is an octave to tell it from, falls off as λ^-fall there.
struct WaveIntegral {
  double value = 0.0, error = std::numeric_limits<double>::infinity(), shortest = 1.0, fall = 2.0;
  bool settled = false;
  std::vector<SummedWave> waves;
  // Its intervals of k: the first behind the integral's beginning, below zero before that; what
  // each has to say; and the error, by the interval that it is taken before.
  int first = -1;
  std::vector<double> parts;
  std::map<int, double> errors;
};

// Integrals over the waves of a grid of sources, for many speeds. The sums along x depend on k
// alone: they are taken once, on intervals of k that all speeds share.
class WaveSums {
 public:
  // `grid` must outlive the sums.
  explicit WaveSums(const SourceGrid& grid);

  // I(λ) for k = ν λ, K = ν λ², waves of any number.
  std::vector<std::complex<double>> amplitudes(double nu, std::span<const double> along) const;

  // The integral for ν: ends where what is left is below `tolerance` of it, or at λ = `shortest`,
  // but not before three intervals of k. `begun`: as far as it was taken by a coarser grid of the
  // same sources, of the same ν; it is gone on with.
  WaveIntegral integral(double nu, double tolerance, double shortest, WaveIntegral begun = {});

  // The least k that an integral may have to reach whatever λ is. `length`: of the sources, m.
  static double least_reach(double length);
  // The k at which its beginning ends, for ν, which is always taken as a whole.
  static double first_reach(double nu, double length);

 private:
  using Complex = std::complex<double>;
  using Table = std::vector<Eigen::MatrixXcd>;  // by layer, none beyond the reach of its waves
  Table table_of(std::span<const double> along) const;
  const Table& interval_table(int interval);
  template <class Row>
  Complex amplitude(const Table& table, double decay, const Row& row) const;
  void add_first(double nu, double end, WaveIntegral& integral);
  double add_interval(double nu, int interval, WaveIntegral& integral);

  const SourceGrid& grid_;
  double length_, width_;        // rounded, of the sources; of an interval of k
  std::map<int, Table> tables_;  // of intervals
};

// Derivatives of such an integral by the strengths of the grid's nodes, left in the grid, ready for
// SourceGrid::at().
void take_derivatives(const WaveIntegral& integral, SourceGrid& grid);

}  // namespace hull::resistance
