#pragma once

#include "CohortGroup.h"
#include "KernelProgress.h"
#include "LinearDesign.h"
#include "MultivariateTest.h"
#include "NormalDisplacement.h"
#include "PalpateGroupModule.h"
#include "PermutationTest.h"

#include <map>
#include <string>
#include <vector>

namespace palpate
{
/// How one column of a design moves the mean surface along its normal, at each point (mm).
struct ColumnEffect
{
  std::string Name;
  Eigen::VectorXd PerUnit;   ///< of a number's unit; of a factor's level against the reference
  Eigen::VectorXd HalfWidth; ///< of its 95 % confidence interval
};

/// Points of the mean surface: 2,562, some 3 mm apart on a prostate.
constexpr int EffectFrequency = 16;

/// How the columns of a term move the mean surface.
struct TermDisplacement
{
  DesignTerm Term;
  std::vector<ColumnEffect> Columns;

  /// The largest displacement (mm) of a column: per standard deviation of a number, per level of a
  /// factor.
  double LargestMillimeters() const;
  std::string UnitText() const; ///< "per sd (7.1)" or "per level"
  /// By what PerUnit is multiplied to be seen: a number's standard deviation, 1 for a factor.
  double ShownUnits() const { return this->Term.IsNumeric ? this->Term.Deviation : 1.0; }
};

/// What a term of the model explains, given all others.
struct TermEffect : TermDisplacement
{
  MultivariateTest Scores;   ///< on the scores of the first modes together
  PermutationTest Points;    ///< at the points of the mean surface
  Eigen::VectorXd Discovery; ///< false-discovery rates of Points.P
  Eigen::VectorXd PartialR2;
};

struct EffectSettings
{
  PermutationSettings Permutations;
  /// The group's first modes that are further covariates at the points: what differs along these
  /// wide modes is noise to a small, local effect.
  int BeyondModes = 0;
};

/// A linear model of the shapes of a cohort on covariates.
struct CohortEffects
{
  ModelFormula Formula;
  /// At the points; its cases are rows of the group. The scores of BeyondModes are its last
  /// columns.
  LinearDesign Design;
  NormalDisplacement Surface; ///< of the group's mean
  Eigen::Index ScoreCount = 0;
  std::vector<TermEffect> Terms; ///< those that are tested
  EffectSettings Settings;
};

/// Displacements are those of the aligned models at 2,562 points of the mean; tests are those of
/// PermutationTest. The multivariate tests use the first modes that explain 95 % of the variance,
/// at most a fifth of the free degrees, whatever BeyondModes. `covariates` has a row per row of the
/// group. Throws InputError if the design is impossible or BeyondModes take more than half of its
/// free degrees, Cancelled if `progress` cancels.
PALPATEGROUP_EXPORT CohortEffects
FindCohortEffects(const CohortGroup& group, const CovariateTable& covariates,
                  const ModelFormula& formula, const std::map<std::string, std::string>& references,
                  const EffectSettings& settings, const KernelProgress& progress);
} // namespace palpate
