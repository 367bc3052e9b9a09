#pragma once

#include "KernelProgress.h"
#include "PermutationTest.h"
#include "Status.h"

#include <Eigen/Core>

#include <vector>

namespace palpate
{
/// Analysis of variance of shapes by individual and side, summed over the coordinates (Klingenberg,
/// Barluenga and Meyer, Evolution 56, 2002; without repeated measurements the interaction holds
/// their error).
struct SideAnova
{
  struct Effect
  {
    double Squares = 0.0;
    double Degrees = 0.0;
    double Mean() const { return this->Squares / this->Degrees; }
  };
  Effect Individual;  ///< variation of the symmetric parts
  Effect Side;        ///< directional asymmetry: of the mean
  Effect Interaction; ///< fluctuating asymmetry: of the individuals about that

  /// Of the side over the interaction.
  double SideF() const { return this->Side.Mean() / this->Interaction.Mean(); }
};

/// `left` and `right` have a row per individual, of the right side mirrored. Of the coordinates,
/// `symmetric` can differ between individuals and `asymmetric` between sides: all for paired
/// organs; for an organ and its mirror image those that mirroring keeps, and the others.
SideAnova FindSideAnova(const Eigen::MatrixXd& left, const Eigen::MatrixXd& right,
                        Eigen::Index symmetric, Eigen::Index asymmetric);

/// Test that the two sides do not differ on average.
struct SideTest
{
  Eigen::VectorXd Mean;      ///< of left minus right
  Eigen::VectorXd Deviation; ///< standard deviation of left minus right
  Eigen::VectorXd Statistic; ///< paired t; 0 without variation
  Eigen::VectorXd P;         ///< of Student's distribution
  Eigen::VectorXd FamilyP;   ///< corrected for all points: by the largest t, over flips
  double WholeF = 0.0;       ///< explained by residual squares, both integrated over the surface
  double WholeP = 1.0;       ///< over flips
};

/// `differences` of left minus right: a row per individual, a column per point, whose `areas` weigh
/// the whole. If the sides do not differ, those of any individual may be exchanged, so that random
/// signs of its differences give the distribution (exact for symmetric distributions, such as in
/// Nichols and Holmes, Human Brain Mapping 15, 2002). A p-value is the share of flips, the observed
/// one included, whose statistic is at least as large. Fails only if `progress` cancels.
Status TestSides(const Eigen::MatrixXd& differences, const std::vector<double>& areas,
                 const PermutationSettings& settings, const KernelProgress& progress,
                 SideTest& test);
} // namespace palpate
