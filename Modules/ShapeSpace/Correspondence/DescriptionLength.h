#pragma once

#include <Eigen/Core>

namespace palpate
{
/// How long the description of shapes by their principal modes is: the sum over the modes of
/// log(1 + variance / noise), in nats per shape and up to a factor of 1/2. It is the determinant of
/// Kotcheff and Taylor (Med. Image Anal. 2, 1998) with the noise added to each variance, and counts
/// as the description length of Davies et al. (IEEE TMI 21, 2002) does: modes far below the noise
/// cost nothing, those above it the logarithm.
struct DescriptionLength
{
  double Value = 0.0;
  double Variance = 0.0; ///< of all modes together, mm^2
  /// The derivative by the matrix of the shapes' inner products times cases - 1, centred: with C
  /// the shapes as columns, C * Pull is the difference of each shape from what the others predict,
  /// times its precision Pull(i, i). As the length is concave in that matrix, lowering the trace of
  /// Pull times the matrix lowers the length at least as much (majorisation).
  Eigen::MatrixXd Pull;
};

/// `shapes` has a shape per column: coordinates (mm), each times the root of its share of the
/// surface. `noise` in mm^2 > 0. At least two shapes. `findsPull` if Pull is wanted. Allocates.
DescriptionLength MeasureDescriptionLength(const Eigen::MatrixXd& shapes, double noise,
                                           bool findsPull);
} // namespace palpate
