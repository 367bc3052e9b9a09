#include "CohortGroup.h"

#include "CohortPage.h"
#include "CsvText.h"
#include "DecimalText.h"
#include "InputError.h"
#include "ModelFile.h"
#include "ModelSurface.h"
#include "OutputFolder.h"
#include "SurfaceFile.h"
#include "WholeFile.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace palpate
{
namespace
{
constexpr int SurfaceFrequency = 40; // 16,002 points
constexpr double DrawnDeviations = 2.0;
// As a fraction of the mean radius: beyond it, the centre of a fit is not the centroid.
constexpr double LargestOffset = 0.05;
// Principal axes whose lengths differ by less than this fraction are arbitrary.
constexpr double SmallestAxisDifference = 0.02;

bool IsOf(const CohortRow& row, const std::string& structure)
{
  const Segment& segment = row.Result.Structure;
  return structure.empty() || segment.Name == structure ||
         std::to_string(segment.Label) == structure;
}

// Cases may number a structure differently, so its name is used if there is one.
std::string TitleOf(const Segment& segment)
{
  return segment.Name.empty() ? std::to_string(segment.Label) : segment.Name;
}

std::vector<CohortRow> Choose(const CohortTable& table, const std::string& structure,
                              std::vector<std::string>& notes)
{
  std::vector<CohortRow> chosen;
  std::set<std::string> titles;
  for (const CohortRow& row : table.Rows())
  {
    if (row.Model.empty())
    {
      notes.push_back(row.Case + " has no model and is omitted: " + row.Result.Message);
    }
    else if (IsOf(row, structure))
    {
      chosen.push_back(row);
      titles.insert(structure.empty() ? TitleOf(row.Result.Structure) : structure);
    }
  }
  std::set<std::string> cases;
  const bool isTwice =
      std::any_of(chosen.begin(), chosen.end(),
                  [&](const CohortRow& row) { return !cases.insert(row.Case).second; });
  if (titles.size() > 1 || isTwice)
  {
    throw InputError("the cohort has several structures, within or across cases; choose one with "
                     "--label, or state each case's in the manifest");
  }
  if (chosen.size() < 2)
  {
    throw InputError("a group needs at least two cases with a model, but " +
                     std::to_string(chosen.size()) + " has one" +
                     (structure.empty() ? "" : " of structure " + structure) + "; fit more cases");
  }
  return chosen;
}

SphericalHarmonicModel ReadStarShaped(const std::filesystem::path& file)
{
  const ModelDocument document = ReadModel(file);
  const auto* model = std::get_if<SphericalHarmonicModel>(&document.Surface);
  if (model == nullptr)
  {
    throw InputError(file.string() + " is a parametric surface; a cohort needs star-shaped models");
  }
  return *model;
}

void Check(const Status& status, const std::string& name)
{
  if (!status.IsOk())
  {
    throw InputError(name + ": " + status.Message());
  }
}

void NoteOn(CohortGroup& group, const std::string& name, const SphericalHarmonicModel& model,
            const BodyMoments& body)
{
  const double offset = (body.CentroidWorld - model.CenterWorld()).norm();
  if (offset > LargestOffset * std::cbrt(body.SemiAxes.prod()))
  {
    group.Notes.push_back(name + ": its centre lies " + std::to_string(offset) +
                          " mm from its centroid, which counts as shape; fit with --center "
                          "centroid");
  }
  const bool isRound = body.SemiAxes[1] > (1.0 - SmallestAxisDifference) * body.SemiAxes[0] ||
                       body.SemiAxes[2] > (1.0 - SmallestAxisDifference) * body.SemiAxes[1];
  if (group.Axes == AlignmentAxes::Ellipsoid && isRound)
  {
    group.Notes.push_back(name + ": two of its principal axes are nearly equal, so its rotation "
                                 "about the third is poorly determined");
  }
}

Eigen::MatrixXd CoefficientsOf(const std::vector<SphericalHarmonicModel>& models)
{
  const auto count = static_cast<Eigen::Index>(models.front().Coefficients().size());
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(models.size()), count);
  for (std::size_t row = 0; row < models.size(); ++row)
  {
    matrix.row(static_cast<Eigen::Index>(row)) =
        Eigen::Map<const Eigen::RowVectorXd>(models[row].Coefficients().data(), count);
  }
  return matrix;
}

// A table with one row per case: name, label, numbers.
std::string CaseTable(const CohortGroup& group, const std::vector<std::string>& columns,
                      const Eigen::MatrixXd& numbers)
{
  std::vector<std::string> head{"case", "label"};
  head.insert(head.end(), columns.begin(), columns.end());
  std::string text = CsvLine(head);
  for (std::size_t row = 0; row < group.Rows.size(); ++row)
  {
    std::vector<std::string> fields{group.Rows[row].Case,
                                    std::to_string(group.Rows[row].Result.Structure.Label)};
    for (Eigen::Index k = 0; k < numbers.cols(); ++k)
    {
      fields.push_back(ExactText(numbers(static_cast<Eigen::Index>(row), k)));
    }
    text += CsvLine(fields);
  }
  return text;
}

std::vector<std::string> CoefficientColumns(int degree)
{
  std::vector<std::string> columns;
  for (int l = 0; l <= degree; ++l)
  {
    for (int m = -l; m <= l; ++m)
    {
      columns.push_back("c_" + std::to_string(l) + "_" + std::to_string(m));
    }
  }
  return columns;
}

std::vector<std::string> ModeColumns(const CohortGroup& group)
{
  std::vector<std::string> columns;
  for (Eigen::Index mode = 1; mode <= group.Modes.Modes.cols(); ++mode)
  {
    columns.push_back("mode_" + std::to_string(mode));
  }
  return columns;
}

std::string VarianceTable(const ShapeModes& modes)
{
  std::string text = CsvLine({"mode", "deviation_mm", "rms_radius_mm", "explained"});
  for (Eigen::Index k = 0; k < modes.Modes.cols(); ++k)
  {
    text += CsvLine({std::to_string(k + 1), ExactText(modes.Deviations[k]),
                     ExactText(modes.Deviations[k] / std::sqrt(4.0 * M_PI)),
                     ExactText(modes.Explained[k])});
  }
  return text;
}

std::string MeasureTable(const CohortGroup& group)
{
  const std::vector<std::string> columns{"volume_ml",      "area_mm2",
                                         "mean_radius_mm", "semi_axis_1_mm",
                                         "semi_axis_2_mm", "semi_axis_3_mm",
                                         "centroid_x_mm",  "centroid_y_mm",
                                         "centroid_z_mm",  "mask_ml",
                                         "mean_mm",        "p95_mm",
                                         "max_mm",         "dice"};
  Eigen::MatrixXd numbers(static_cast<Eigen::Index>(group.Rows.size()),
                          static_cast<Eigen::Index>(columns.size()));
  for (std::size_t row = 0; row < group.Rows.size(); ++row)
  {
    const FitResult& fit = group.Rows[row].Result;
    const BodyMoments& body = group.Bodies[row];
    numbers.row(static_cast<Eigen::Index>(row)) << body.Volume / 1000.0,
        fit.ModelAreaSquareMillimeters,
        group.Models[row].Coefficients().front() / std::sqrt(4.0 * M_PI), body.SemiAxes[0],
        body.SemiAxes[1], body.SemiAxes[2], body.CentroidWorld[0], body.CentroidWorld[1],
        body.CentroidWorld[2], fit.MaskMilliliters, fit.ModelToMask.Mean,
        fit.ModelToMask.Percentile95, fit.ModelToMask.Maximum, fit.Dice;
  }
  return CaseTable(group, columns, numbers);
}

void WriteShape(const CohortGroup& group, int mode, double deviations,
                const std::filesystem::path& file, const std::string& program)
{
  ModelDocument document;
  document.Surface = ShapeOf(group, mode, deviations);
  document.Provenance.Program = program;
  document.Provenance.Settings = {
      {"cases", std::to_string(group.Rows.size())},
      {"align", group.Axes == AlignmentAxes::Patient ? "patient" : "ellipsoid"}};
  WriteModel(file, document);
}

void WriteGroupFiles(const CohortGroup& group, const std::filesystem::path& folder,
                     const std::string& program)
{
  WriteWholeFile(folder / "coefficients.csv",
                 CaseTable(group, CoefficientColumns(group.Models.front().Degree()),
                           CoefficientsOf(group.Models)));
  WriteWholeFile(folder / "modes.csv", CaseTable(group, ModeColumns(group), group.Modes.Scores));
  WriteWholeFile(folder / "variance.csv", VarianceTable(group.Modes));
  WriteWholeFile(folder / "measures.csv", MeasureTable(group));
  WriteShape(group, -1, 0.0, folder / "mean.json", program);
  WriteSurface(folder / "mean.vtp", DrawModel(ShapeOf(group, -1, 0.0), SurfaceFrequency));
  for (int mode = 0; mode < ShownModes(group); ++mode)
  {
    const std::string name = "mode_" + std::to_string(mode + 1);
    WriteShape(group, mode, -DrawnDeviations, folder / (name + "_minus.json"), program);
    WriteShape(group, mode, DrawnDeviations, folder / (name + "_plus.json"), program);
  }
  WriteWholeFile(folder / "cohort.html", CohortPage(group, DrawnDeviations));
}
} // namespace

CohortGroup MakeCohortGroup(const CohortTable& table, const std::filesystem::path& folder,
                            const std::string& structure, AlignmentAxes axes)
{
  CohortGroup group;
  group.Axes = axes;
  group.Rows = Choose(table, structure, group.Notes);
  int degree = 0;
  for (const CohortRow& row : group.Rows)
  {
    const SphericalHarmonicModel model = ReadStarShaped((folder / row.Model).lexically_normal());
    BodyMoments body;
    SphericalHarmonicModel aligned;
    Check(MeasureBody(model, body), row.Case);
    Check(AlignShape(model, axes, aligned), row.Case);
    NoteOn(group, row.Case, model, body);
    group.Bodies.push_back(body);
    group.Models.push_back(aligned);
    degree = std::max(degree, model.Degree());
  }
  for (SphericalHarmonicModel& model : group.Models)
  {
    model = model.WithDegree(degree);
  }
  Check(FindShapeModes(CoefficientsOf(group.Models), group.Modes), folder.string());
  return group;
}

SphericalHarmonicModel ShapeOf(const CohortGroup& group, int mode, double deviations)
{
  Eigen::VectorXd values = group.Modes.Mean;
  if (mode >= 0)
  {
    values += deviations * group.Modes.Deviations[mode] * group.Modes.Modes.col(mode);
  }
  return {group.Models.front().Degree(),
          std::vector<double>(values.data(), values.data() + values.size()), Vector3::Zero()};
}

void WriteCohortGroup(const CohortGroup& group, const std::filesystem::path& folder,
                      const std::string& program)
{
  std::vector<std::string> obsolete;
  for (int mode = ShownModes(group); mode < MostShownModes; ++mode)
  {
    const std::string name = "mode_" + std::to_string(mode + 1);
    obsolete.insert(obsolete.end(), {name + "_minus.json", name + "_plus.json"});
  }
  WriteOutputSet(
      folder, [&](const std::filesystem::path& stage) { WriteGroupFiles(group, stage, program); },
      obsolete);
}
} // namespace palpate
