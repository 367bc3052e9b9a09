#pragma once

#include "CohortGroup.h"
#include "Covariates.h"
#include "NormalDisplacement.h"
#include "PalpateGroupModule.h"
#include "SideAsymmetry.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
class ReportPage;

/// Rows of the group with both sides of a paired organ.
struct SidePair
{
  std::size_t Left = 0;
  std::size_t Right = 0;
};

/// How one individual's sides differ.
struct SideDifference
{
  SidePair Rows;                 ///< the same row twice for an organ of the midline
  double VolumePercent = 0.0;    ///< left minus right over their mean; of pairs
  double ShapeMillimeters = 0.0; ///< along the normals, RMS over the mean surface
  double ShapePercent = 0.0;     ///< the same of the left side's RMS size
};

/// Left against right in a cohort: of pairs, or of organs of the midline against their own mirror
/// images at the sagittal plane. Directional asymmetry is the mean of the differences, fluctuating
/// asymmetry their variation.
struct CohortAsymmetry
{
  bool IsPaired = false;
  std::vector<SideDifference> Individuals;
  SideAnova Anova;            ///< of the coefficients
  NormalDisplacement Surface; ///< of the mean of both sides, as the left one
  SideTest Points;            ///< displacement along its normals of left minus right, mm
  Eigen::VectorXd Discovery;  ///< false-discovery rates of Points.P
  PermutationSettings Flips;

  std::string Text() const; ///< a summary for a console, with line ends
};

/// The pairs by the columns of the individual and of the side (words that begin with l or r).
/// `notes` name individuals without both sides, who are left out. Throws InputError if there is no
/// such column, a side is no side, an individual has one twice, or none has both.
PALPATEGROUP_EXPORT std::vector<SidePair>
FindSidePairs(const CohortGroup& group, const CovariateTable& table, const std::string& individual,
              const std::string& side, std::vector<std::string>& notes);

/// Makes right sides comparable with left ones: replaces those of the pairs by their mirror images.
/// Throws InputError.
PALPATEGROUP_EXPORT void MirrorRightSides(CohortGroup& group, const std::vector<SidePair>& pairs);

/// Of pairs after MirrorRightSides and the group's alignment; without pairs of each case against
/// its mirror image, turned to their common mean if the group's axes are Procrustes. Throws
/// InputError for fewer than three individuals, and Cancelled.
PALPATEGROUP_EXPORT CohortAsymmetry FindCohortAsymmetry(const CohortGroup& group,
                                                        const std::vector<SidePair>& pairs,
                                                        const PermutationSettings& flips,
                                                        const KernelProgress& progress);

/// Writes asymmetry.csv (one row per individual), asymmetry_anova.csv and asymmetry.vtp into an
/// existing folder. Throws InputError.
PALPATEGROUP_EXPORT void WriteCohortAsymmetry(const CohortGroup& group,
                                              const CohortAsymmetry& asymmetry,
                                              const std::filesystem::path& folder);
/// Adds a table and the mean coloured by the directional asymmetry, pale where its corrected p is
/// 0.05 or more.
PALPATEGROUP_EXPORT void AddCohortAsymmetry(ReportPage& page, const CohortAsymmetry& asymmetry);
/// How it was found, to follow other sentences on methods (plain text).
PALPATEGROUP_EXPORT std::string CohortAsymmetryMethods(const CohortAsymmetry& asymmetry);
} // namespace palpate
