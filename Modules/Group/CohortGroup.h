#pragma once

#include "CohortTable.h"
#include "KernelProgress.h"
#include "ModelMeasures.h"
#include "OrganModel.h"
#include "PalpateGroupModule.h"
#include "ShapeAlignment.h"
#include "ShapeModes.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace palpate
{
/// What is to be said of a case.
struct CohortNote
{
  std::string Case;
  std::string Text;        ///< follows the name: " has no model"
  std::string Reason = {}; ///< follows the text; may name files
};

/// The models of one structure over a cohort in common axes, and their variation.
struct CohortGroup
{
  AlignmentAxes Axes = AlignmentAxes::Patient;
  std::vector<CohortRow> Rows;     ///< those with a model of that kind
  std::vector<OrganModel> Models;  ///< aligned, of one kind and degree: the highest of all
  std::vector<BodyMoments> Bodies; ///< of the models in their patients' frames
  ShapeModes Modes;
  std::vector<CohortNote> Notes; ///< omitted cases and warnings

  /// A row's case by its name or its number.
  std::string ShownName(std::size_t row, bool showsNames) const
  {
    return showsNames ? this->Rows[row].Case : std::to_string(row + 1);
  }

  ///@{ Of the model files read, also of those omitted: programs, and settings that all share.
  std::vector<std::string> FitPrograms;
  std::vector<std::pair<std::string, std::string>> FitSettings;
  ///@}
};

/// Reads the models listed in a table, relative to `folder`, and aligns them. `structure` is a
/// label or a name; it may be empty if the cohort has only one. Of radial and surface models, whose
/// coefficients cannot be compared, those of the more frequent kind are taken. Throws InputError if
/// fewer than two cases have a model, the structure is ambiguous, or a model cannot be read, and
/// Cancelled if `progress`, which counts the cases, cancels.
PALPATEGROUP_EXPORT CohortGroup MakeCohortGroup(const CohortTable& table,
                                                const std::filesystem::path& folder,
                                                const std::string& structure, AlignmentAxes axes,
                                                const KernelProgress& progress = {});

/// Names the cases "case 1", "case 2", … in the order of the rows, and forgets their masks, so that
/// what is written of the group names no patient.
PALPATEGROUP_EXPORT void NumberCases(CohortGroup& group);

/// The aligned models' coefficients (mm), one row per case; of surface models x, then y, then z.
PALPATEGROUP_EXPORT Eigen::MatrixXd CoefficientsOf(const CohortGroup& group);

/// The mean shape plus a mode times its standard deviation times `deviations`; the mean for mode
/// -1.
PALPATEGROUP_EXPORT OrganModel ShapeOf(const CohortGroup& group, int mode, double deviations);

/// The mean shape plus the modes times these scores (mm), one per mode.
PALPATEGROUP_EXPORT OrganModel ShapeWith(const CohortGroup& group, const Eigen::VectorXd& scores);
///@{ Figures of the bodies in their patients' frames: volume_ml, area_mm2, mean_radius_mm (over the
/// directions; of a surface model that of the ball of its volume) and semi_axis_1_mm to
/// semi_axis_3_mm; one case per row.
PALPATEGROUP_EXPORT std::vector<std::string> FigureNames();
PALPATEGROUP_EXPORT Eigen::MatrixXd FiguresOf(const CohortGroup& group);
///@}
/// mode_1, mode_2, ...: columns of tables.
PALPATEGROUP_EXPORT std::vector<std::string> ModeNames(Eigen::Index count);

struct CohortEffects;
struct CohortQuality;
struct CohortAlignment;
struct CohortAsymmetry;
struct CohortCorrespondence;
struct CohortReparametrisation;
struct RepeatedEffects;

/// What is written of a group beside its shapes.
struct CohortOutput
{
  const CohortEffects* Effects = nullptr;     ///< of covariates; may be null
  bool ShowsNames = false;                    ///< cases by name on the page, otherwise by number
  const CohortQuality* Quality = nullptr;     ///< of the modes; may be null
  const CohortAlignment* Alignment = nullptr; ///< of axes Procrustes; may be null
  const CohortCorrespondence* Correspondence = nullptr;       ///< of the cases; may be null
  const CohortReparametrisation* Reparametrisation = nullptr; ///< may be null
  const RepeatedEffects* Repeated = nullptr;  ///< of patients with several cases; may be null
  const CohortAsymmetry* Asymmetry = nullptr; ///< of left and right; may be null
};

/// Writes coefficients.csv (one row per case, columns c_l_m, of surfaces x_l_m, y_l_m and z_l_m,
/// mm), modes.csv (scores, mm), variance.csv (one row per mode), measures.csv, mean.json, mean.vtp,
/// mode_K_minus.json and mode_K_plus.json (the mean and two standard deviations, for the first five
/// modes), cohort.html, alignment.csv (AlignmentTable), correspondence.csv (CorrespondenceTable),
/// reparametrisation.csv (ReparametrisationTable), and the files of WriteCohortEffects,
/// WriteRepeatedEffects, WriteCohortAsymmetry and WriteCohortQuality into the folder, all of them
/// or none. Throws InputError.
PALPATEGROUP_EXPORT void WriteCohortGroup(const CohortGroup& group, const CohortOutput& output,
                                          const std::filesystem::path& folder,
                                          const std::string& program);
} // namespace palpate
