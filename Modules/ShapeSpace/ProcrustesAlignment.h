#pragma once

#include "KernelProgress.h"
#include "OrganModel.h"
#include "ShapeSuperposition.h"
#include "Status.h"

#include <vector>

namespace palpate
{
struct ProcrustesSettings
{
  bool Scales = false;     ///< all shapes to one size (RmsSizeOf)
  double Tolerance = 1e-7; ///< mm (RMS): the mean moves less in the last round
  int MostRounds = 200;
};

/// How one shape was aligned, and how sure that is.
struct ProcrustesCase
{
  SphereRotation Rotation;
  double Scale = 1.0;
  double Residual = 0.0; ///< RMS distance from the mean, mm
  ///@{ The same at the size that makes it smallest, so that sizes do not hide differences in shape.
  double ShapeResidual = 0.0; ///< mm
  /// The best of the optima that are reached after half a turn about one of the mean's principal
  /// axes, the longest first. From where only the chosen orientation is reached again, the half
  /// turn itself counts.
  double FlippedResidual = 0.0; ///< mm
  int FlipAxis = 0;
  double MirroredResidual = 0.0; ///< of the optimum of the mirror image (x to -x), mm
  ///@}

  /// Below 1 if the orientation is better than every flip; close to 1 if it is ambiguous.
  double FlipRatio() const;
  double MirrorRatio() const;
  bool IsAmbiguous() const;
  bool IsMirrored() const;
};

struct ProcrustesResult
{
  std::vector<OrganModel> Aligned;
  OrganModel Mean;
  std::vector<ProcrustesCase> Cases;
  int Rounds = 0;
  bool HasConverged = false;
};

/// Ratios of residuals from here on are close to 1.
constexpr double AmbiguousRatio = 0.8;

/// Generalised Procrustes analysis (Gower, Psychometrika 40, 1975): every shape is turned to the
/// mean of all, and that computed again, until it stays. Rotations start from those that the shapes
/// have, so that an optimum half a turn away, which is better for some, is not taken; only surface
/// models' parameters may start from the polar factor of their linear terms
/// (ShapeSuperposition::StartFor), if that is better. Shapes are never mirrored. The order of
/// shapes has no influence beyond rounding. With a `reference` every shape is turned to that
/// instead, whatever the others are, and with Scales it gets its size; otherwise the mean size of
/// all.
///
/// `shapes` about the origin, of one kind and degree, as the reference. Fails if the reference is
/// of another kind or degree, if there are no shapes, if a shape has no volume, or if `progress`
/// cancels. How many rounds there will be is unknown, so that the progress of one is a part of what
/// is left.
Status AlignByProcrustes(const std::vector<OrganModel>& shapes, const OrganModel* reference,
                         const ProcrustesSettings& settings, ProcrustesResult& result,
                         const KernelProgress& progress = {});
} // namespace palpate
