#pragma once

#include "ShapeModes.h"

#include <Eigen/Core>

#include <cstdint>

namespace palpate
{
/// A mean over cases or shapes for each number of modes, 0 (the mean shape alone) to all.
struct QualityCurve
{
  Eigen::VectorXd Values;
  Eigen::VectorXd StandardErrors;
};

/// How well a linear model of shapes describes its population (Davies, Twining and Taylor,
/// Statistical Models of Shape, Springer 2008, ch. 9). Distances are RMS over the sphere of
/// directions (radial models: of the radius) or of parameters (surface models: of the position):
/// the coefficients' distance over sqrt(4 pi).
struct ShapeModelQuality
{
  /// Variance of the first modes together, mm^2. Its standard error is that of independent
  /// variances of normal scores, each its value times sqrt(2 / (cases - 1)) (Anderson, Ann. Math.
  /// Statist. 34, 1963).
  QualityCurve Compactness;
  /// Distance of a case from its best description by the first modes of all other cases, about
  /// their mean; mean over the cases, mm. All of their modes where they have fewer.
  QualityCurve Generalisation;
  /// Distance of random shapes of the model from the nearest case; mean, mm. The error is that of
  /// the finite number of random shapes.
  QualityCurve Specificity;
};

/// What random shapes a model's specificity is measured with.
struct RandomShapeSettings
{
  int Count = 2000;
  std::uint64_t Seed = 1;
};

/// Scores (mm) of one of the random shapes: normal, with the deviations of the modes. The shape of
/// the model with k modes has the first k of them. Depends on seed and number alone.
Eigen::VectorXd RandomScores(const ShapeModes& modes, std::uint64_t seed, std::uint64_t number);

/// Exact up to rounding (LeftOutSolver), apart from the random shapes. Time: cases x modes x (modes
/// + random shapes); memory beside the scores: independent of the number of cases but for one
/// number each. Empty curves for fewer than two cases. Allocates.
ShapeModelQuality MeasureShapeModel(const ShapeModes& modes, const RandomShapeSettings& settings);
} // namespace palpate
