#pragma once

#include "SphericalHarmonicModel.h"

namespace palpate
{
/// A model of a low degree that holds all that another one holds.
struct CoarseHarmonics
{
  SphericalHarmonicModel Model;
  double RaisedBy; ///< mm by which all its radii are longer than those of the cut model
};

/// Leaves out the terms above `degree` and makes all radii longer by the most that these terms
/// anywhere add up to, certified by branch and bound to a hundredth of the mean radius. So its
/// radius is nowhere less than the model's, and a ball that it does not touch does not touch the
/// model either. Allocates, takes a millisecond. Coefficients have to be finite.
CoarseHarmonics MakeCoarseHarmonics(const SphericalHarmonicModel& model, int degree);
} // namespace palpate
