#pragma once

#include "ComplianceAtlas.h"
#include "FreePlace.h"
#include "RadialModel.h"
#include "Status.h"
#include "Vector3.h"

#include <memory>
#include <optional>

namespace palpate::test
{
/// A ball-shaped nodule that is stiffer than the tissue around it.
struct HiddenNodule
{
  double Diameter; ///< mm
  double Depth;    ///< of its top below the surface, mm
  double Ratio;    ///< of its Young's modulus to the tissue's
};

/// An elastic organ that is palpated from behind: an ellipsoid with a prostate's size, free
/// towards the examiner and on a bed elsewhere, with or without a nodule. The nodule lies a few
/// millimetres from the middle of the free side. The force on the ball that touches the organ is
/// exact up to the errors of Elasticity (its README.md). Immutable once made.
class ElasticPhantom
{
public:
  static constexpr double Tissue = 0.02; ///< Young's modulus, N/mm^2
  static constexpr double Poisson = 0.49;
  static constexpr double Bed = 1e-3;      ///< N/mm^3
  static constexpr double FreeAngle = 1.2; ///< half the cone around +y without a bed, rad
  static constexpr double Ball = 8.0;      ///< radius of the tool, as of a finger, mm
  /// Half the sizes left to right, front to back, down to up, mm; as of ProstateLikeModel.
  static const Vector3 SemiAxes;
  /// Of the surface above the nodule.
  static const FreePlace NodulePlace;

  /// Takes seconds with 12 elements across and a compliance of degree 12 (see OrganSoftening).
  /// Fails with its reasons.
  static Status Make(const std::optional<HiddenNodule>& nodule, int elementsAcross, int degree,
                     ElasticPhantom& phantom);

  const std::optional<HiddenNodule>& Nodule() const noexcept { return this->Hidden; }
  /// Of the surface, mm.
  Vector3 PointWorld(const FreePlace& place) const;
  /// Force along the surface's normal (N) on the ball that is pressed in to `depth` mm.
  double Force(const FreePlace& place, double depth) const;

private:
  std::optional<HiddenNodule> Hidden;
  RadialModel Model;
  std::shared_ptr<const ComplianceAtlas> Atlas;
};
} // namespace palpate::test
