#pragma once

#include "CohortEffects.h"
#include "MixedModel.h"
#include "PalpateGroupModule.h"

#include <string>
#include <vector>

namespace palpate
{
/// A figure of the cases or their scores of a mode, in a mixed model.
struct RepeatedFigure
{
  std::string Name;
  MixedFit Fit;
  std::vector<FixedTest> Tests;  ///< of the tested terms
  std::vector<double> Discovery; ///< their false-discovery rates among figures, or among modes
};

/// What a term explains at the points, given all others. Where a mixed model finds nothing, effects
/// are 0 and P is 1.
struct RepeatedTerm : TermDisplacement
{
  Eigen::VectorXd Statistic; ///< t of a term with one column, otherwise the root of F
  Eigen::VectorXd P;
  Eigen::VectorXd Discovery; ///< false-discovery rates
};

/// The column of patients with several cases, and of the time of these; no time for random
/// intercepts without slopes.
struct RepeatedColumns
{
  std::string Patient;
  std::string Time;
};

/// Linear mixed models of a cohort whose patients have several cases.
struct RepeatedEffects
{
  ModelFormula Formula;
  RepeatedColumns Columns;
  LinearDesign Design;
  Eigen::Index PatientCount = 0;
  Eigen::Index SeveralCount = 0;       ///< patients with several cases
  std::vector<RepeatedFigure> Figures; ///< see FiguresOf; those that are no covariates
  std::vector<RepeatedFigure> Modes;   ///< scores, mm, of the first ten
  NormalDisplacement Surface;          ///< of the group's mean
  std::vector<RepeatedTerm> Terms;
  ///@{ At the points: standard deviations, mm or mm per unit of time; 0 where nothing is found.
  Eigen::VectorXd BetweenPatients;
  Eigen::VectorXd Slopes;
  Eigen::VectorXd WithinPatients;
  ///@}
  Eigen::VectorXd Singular; ///< 1 where the fit is
  Eigen::Index UnfoundPoints = 0;

  std::string RandomText() const;   ///< "random intercept and slope on months of each patient"
  std::string SingularText() const; ///< how many fits are singular
};

/// Displacements are those of FindCohortEffects. Where slopes cannot be separated from residuals, a
/// random intercept alone is fitted, and `notes` say so. Throws InputError if the design is
/// impossible or no patient has several cases, Cancelled if `progress` cancels.
PALPATEGROUP_EXPORT RepeatedEffects FindRepeatedEffects(
    const CohortGroup& group, const CovariateTable& covariates, const ModelFormula& formula,
    const std::map<std::string, std::string>& references, const RepeatedColumns& columns,
    std::vector<std::string>& notes, const KernelProgress& progress);
} // namespace palpate
