#include "CohortGroup.h"

#include "CohortAlignment.h"
#include "CohortAsymmetry.h"
#include "CohortCorrespondence.h"
#include "CohortEffectFiles.h"
#include "CohortPage.h"
#include "CohortQualityFiles.h"
#include "CohortReparametrisation.h"
#include "CsvText.h"
#include "DecimalText.h"
#include "InputError.h"
#include "ModelFile.h"
#include "ModelMeasures.h"
#include "ModelSurface.h"
#include "OutputFolder.h"
#include "Progress.h"
#include "RepeatedEffectFiles.h"
#include "ShapeVector.h"
#include "SurfaceFile.h"
#include "WholeFile.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

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
constexpr double ReadingShare = 0.5; // of the progress; the rest is placing

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
                              std::vector<CohortNote>& notes)
{
  std::vector<CohortRow> chosen;
  std::set<std::string> titles;
  for (const CohortRow& row : table.Rows())
  {
    if (row.Model.empty())
    {
      notes.push_back({row.Case, " has no model and is omitted", ": " + row.Result.Message});
    }
    else if (IsOf(row, structure))
    {
      chosen.push_back(row);
      titles.insert(structure.empty() ? TitleOf(row.Result.Structure) : structure);
    }
  }
  if (titles.size() > 1)
  {
    throw InputError("the cohort has several structures, within or across cases; choose one with "
                     "--label, or state each case's in the manifest");
  }
  std::set<std::string> cases;
  const auto twice =
      std::find_if(chosen.begin(), chosen.end(),
                   [&](const CohortRow& row) { return !cases.insert(row.Case).second; });
  if (twice != chosen.end())
  {
    throw InputError(
        "the cohort has more than one case " + twice->Case +
        "; give the cases of several folders, and a case's structures, different names");
  }
  if (chosen.size() < 2)
  {
    throw InputError("a group needs at least two cases with a model, but " +
                     std::to_string(chosen.size()) + " has one" +
                     (structure.empty() ? "" : " of structure " + structure) + "; fit more cases");
  }
  return chosen;
}

void Check(const Status& status, const std::string& name)
{
  if (!status.IsOk())
  {
    throw InputError(name + ": " + status.Message());
  }
}

// Leaves out the cases whose kind of model is the rarer one; radial if they are as many.
void KeepOneKind(std::vector<OrganModel>& models, CohortGroup& group)
{
  const auto isRadial = [](const OrganModel& model)
  { return std::holds_alternative<RadialModel>(model); };
  const auto radial = std::count_if(models.begin(), models.end(), isRadial);
  const bool keepsRadial = 2 * static_cast<std::size_t>(radial) >= models.size();
  std::vector<OrganModel> kept;
  std::vector<CohortRow> rows;
  for (std::size_t i = 0; i < models.size(); ++i)
  {
    if (isRadial(models[i]) == keepsRadial)
    {
      kept.push_back(std::move(models[i]));
      rows.push_back(std::move(group.Rows[i]));
    }
    else
    {
      group.Notes.push_back(
          {group.Rows[i].Case, std::string(" has a ") +
                                   (keepsRadial ? "surface model, the others radial ones"
                                                : "radial model, the others surface models") +
                                   ", and is omitted; fit all with --model surface"});
    }
  }
  if (kept.size() < 2)
  {
    throw InputError("a group needs at least two models of one kind, but these are radial and "
                     "surface models; fit all with --model surface");
  }
  models = std::move(kept);
  group.Rows = std::move(rows);
}

void NoteOn(CohortGroup& group, const std::string& name, const OrganModel& model,
            const BodyMoments& body)
{
  const auto* radial = std::get_if<RadialModel>(&model);
  const double offset =
      radial != nullptr ? (body.CentroidWorld - radial->CenterWorld()).norm() : 0.0;
  if (offset > LargestOffset * std::cbrt(body.SemiAxes.prod()))
  {
    group.Notes.push_back(
        {name, ": its centre lies " + std::to_string(offset) +
                   " mm from its centroid, which counts as shape; fit with --center "
                   "centroid"});
  }
  const bool isRound = body.SemiAxes[1] > (1.0 - SmallestAxisDifference) * body.SemiAxes[0] ||
                       body.SemiAxes[2] > (1.0 - SmallestAxisDifference) * body.SemiAxes[1];
  if (group.Axes == AlignmentAxes::Ellipsoid && isRound)
  {
    group.Notes.push_back({name, ": two of its principal axes are nearly equal, so its rotation "
                                 "about the third is poorly determined"});
  }
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

std::vector<std::string> CoefficientColumns(const OrganModel& model)
{
  const bool isRadial = std::holds_alternative<RadialModel>(model);
  std::vector<std::string> columns;
  for (const std::string& series :
       isRadial ? std::vector<std::string>{"c"} : std::vector<std::string>{"x", "y", "z"})
  {
    for (int l = 0; l <= DegreeOf(model); ++l)
    {
      for (int m = -l; m <= l; ++m)
      {
        columns.push_back(series + "_" + std::to_string(l) + "_" + std::to_string(m));
      }
    }
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

double MeanRadius(const OrganModel& model, const BodyMoments& body)
{
  const auto* radial = std::get_if<RadialModel>(&model);
  return radial != nullptr ? radial->Coefficients().front() / std::sqrt(4.0 * M_PI)
                           : std::cbrt(0.75 * body.Volume / M_PI);
}

std::string MeasureTable(const CohortGroup& group)
{
  std::vector<std::string> columns = FigureNames();
  columns.insert(columns.end(), {"centroid_x_mm", "centroid_y_mm", "centroid_z_mm", "mask_ml",
                                 "mean_mm", "p95_mm", "max_mm", "dice"});
  const Eigen::MatrixXd figures = FiguresOf(group);
  Eigen::MatrixXd numbers(figures.rows(), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t row = 0; row < group.Rows.size(); ++row)
  {
    const FitResult& fit = group.Rows[row].Result;
    const auto index = static_cast<Eigen::Index>(row);
    numbers.row(index) << figures.row(index), group.Bodies[row].CentroidWorld.transpose(),
        fit.MaskMilliliters, fit.ModelToMask.Mean, fit.ModelToMask.Percentile95,
        fit.ModelToMask.Maximum, fit.Dice;
  }
  return CaseTable(group, columns, numbers);
}

std::string AxesName(AlignmentAxes axes)
{
  const char* const others = axes == AlignmentAxes::Ellipsoid ? "ellipsoid" : "procrustes";
  return axes == AlignmentAxes::Patient ? "patient" : others;
}

void WriteShape(const CohortGroup& group, int mode, double deviations,
                const std::filesystem::path& file, const std::string& program)
{
  ModelDocument document;
  document.Surface = ShapeOf(group, mode, deviations);
  document.Provenance.Program = program;
  document.Provenance.Settings = {{"cases", std::to_string(group.Rows.size())},
                                  {"align", AxesName(group.Axes)}};
  WriteModel(file, document);
}

void WriteGroupFiles(const CohortGroup& group, const CohortOutput& output,
                     const std::filesystem::path& folder, const std::string& program)
{
  WriteWholeFile(folder / "coefficients.csv",
                 CaseTable(group, CoefficientColumns(group.Models.front()), CoefficientsOf(group)));
  WriteWholeFile(folder / "modes.csv",
                 CaseTable(group, ModeNames(group.Modes.Modes.cols()), group.Modes.Scores));
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
  WriteWholeFile(folder / "cohort.html", CohortPage(group, output, DrawnDeviations, program));
  if (output.Effects != nullptr)
  {
    WriteCohortEffects(group, *output.Effects, folder);
  }
  if (output.Repeated != nullptr)
  {
    WriteRepeatedEffects(group, *output.Repeated, folder);
  }
  if (output.Asymmetry != nullptr)
  {
    WriteCohortAsymmetry(group, *output.Asymmetry, folder);
  }
  if (output.Alignment != nullptr)
  {
    WriteWholeFile(folder / "alignment.csv", AlignmentTable(group, *output.Alignment));
  }
  if (output.Correspondence != nullptr)
  {
    WriteWholeFile(folder / "correspondence.csv",
                   CorrespondenceTable(group, *output.Correspondence));
  }
  if (output.Reparametrisation != nullptr)
  {
    WriteWholeFile(folder / "reparametrisation.csv",
                   ReparametrisationTable(group, *output.Reparametrisation));
  }
  if (output.Quality != nullptr)
  {
    WriteCohortQuality(group, *output.Quality, folder);
  }
}

double Share(std::size_t done, std::size_t all)
{
  return static_cast<double>(done) / static_cast<double>(all);
}

void Report(const KernelProgress& progress, double done)
{
  if (progress && !progress(done))
  {
    throw Cancelled();
  }
}

// Settings that all models share.
void TakeProvenance(const ModelProvenance& provenance, bool isFirst, CohortGroup& group)
{
  std::vector<std::string>& programs = group.FitPrograms;
  if (!provenance.Program.empty() &&
      std::find(programs.begin(), programs.end(), provenance.Program) == programs.end())
  {
    programs.push_back(provenance.Program);
  }
  if (isFirst)
  {
    group.FitSettings = provenance.Settings;
    return;
  }
  const auto isOther = [&](const auto& setting)
  {
    return std::find(provenance.Settings.begin(), provenance.Settings.end(), setting) ==
           provenance.Settings.end();
  };
  group.FitSettings.erase(
      std::remove_if(group.FitSettings.begin(), group.FitSettings.end(), isOther),
      group.FitSettings.end());
}

std::vector<OrganModel> ReadModels(const std::filesystem::path& folder,
                                   const KernelProgress& progress, CohortGroup& group)
{
  std::vector<OrganModel> models;
  for (const CohortRow& row : group.Rows)
  {
    Report(progress, ReadingShare * Share(models.size(), group.Rows.size()));
    ModelDocument document = ReadModel((folder / row.Model).lexically_normal());
    TakeProvenance(document.Provenance, models.empty(), group);
    models.push_back(std::move(document.Surface));
  }
  return models;
}

void AddAligned(const OrganModel& model, const std::string& name, CohortGroup& group)
{
  BodyMoments body;
  OrganModel aligned = model;
  Check(std::visit([&](const auto& one) { return MeasureBody(one, body); }, model), name);
  Check(AlignShape(model, group.Axes, aligned), name);
  group.Bodies.push_back(body);
  group.Models.push_back(std::move(aligned));
}
} // namespace

CohortGroup MakeCohortGroup(const CohortTable& table, const std::filesystem::path& folder,
                            const std::string& structure, AlignmentAxes axes,
                            const KernelProgress& progress)
{
  CohortGroup group;
  group.Axes = axes;
  group.Rows = Choose(table, structure, group.Notes);
  std::vector<OrganModel> models = ReadModels(folder, progress, group);
  KeepOneKind(models, group);
  int degree = 0;
  for (std::size_t i = 0; i < models.size(); ++i)
  {
    Report(progress, ReadingShare + (1.0 - ReadingShare) * Share(i, models.size()));
    const std::string& name = group.Rows[i].Case;
    AddAligned(models[i], name, group);
    NoteOn(group, name, models[i], group.Bodies.back());
    degree = std::max(degree, DegreeOf(models[i]));
  }
  for (OrganModel& model : group.Models)
  {
    model = WithDegree(model, degree);
  }
  Check(FindShapeModes(CoefficientsOf(group), group.Modes), folder.string());
  return group;
}

std::vector<std::string> FigureNames()
{
  return {"volume_ml",      "area_mm2",       "mean_radius_mm",
          "semi_axis_1_mm", "semi_axis_2_mm", "semi_axis_3_mm"};
}

Eigen::MatrixXd FiguresOf(const CohortGroup& group)
{
  Eigen::MatrixXd figures(static_cast<Eigen::Index>(group.Rows.size()), 6);
  for (std::size_t row = 0; row < group.Rows.size(); ++row)
  {
    const BodyMoments& body = group.Bodies[row];
    figures.row(static_cast<Eigen::Index>(row)) << body.Volume / 1000.0,
        group.Rows[row].Result.ModelAreaSquareMillimeters, MeanRadius(group.Models[row], body),
        body.SemiAxes.transpose();
  }
  return figures;
}

void NumberCases(CohortGroup& group)
{
  std::map<std::string, std::string> numbers;
  for (CohortRow& row : group.Rows)
  {
    const std::string number = "case " + std::to_string(numbers.size() + 1);
    numbers.emplace(row.Case, number);
    row.Case = row.Result.CaseName = number;
    row.Result.Input.clear();
  }
  for (CohortNote& note : group.Notes)
  {
    const auto found = numbers.find(note.Case);
    note.Case = found == numbers.end() ? "a case" : found->second;
    note.Reason.clear();
  }
}

Eigen::MatrixXd CoefficientsOf(const CohortGroup& group)
{
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(group.Models.size()),
                         VectorOf(group.Models.front()).size());
  for (std::size_t i = 0; i < group.Models.size(); ++i)
  {
    matrix.row(static_cast<Eigen::Index>(i)) = VectorOf(group.Models[i]);
  }
  return matrix;
}

OrganModel ShapeOf(const CohortGroup& group, int mode, double deviations)
{
  Eigen::VectorXd scores = Eigen::VectorXd::Zero(group.Modes.Deviations.size());
  if (mode >= 0)
  {
    scores[mode] = deviations * group.Modes.Deviations[mode];
  }
  return ShapeWith(group, scores);
}

std::vector<std::string> ModeNames(Eigen::Index count)
{
  std::vector<std::string> names;
  for (Eigen::Index mode = 1; mode <= count; ++mode)
  {
    names.push_back("mode_" + std::to_string(mode));
  }
  return names;
}

OrganModel ShapeWith(const CohortGroup& group, const Eigen::VectorXd& scores)
{
  return ShapeFrom(group.Modes.Mean + group.Modes.Modes * scores, group.Models.front());
}

void WriteCohortGroup(const CohortGroup& group, const CohortOutput& output,
                      const std::filesystem::path& folder, const std::string& program)
{
  std::vector<std::string> obsolete;
  if (output.Effects == nullptr)
  {
    obsolete = {"effects.csv", "effects.vtp", "design.csv"};
  }
  if (output.Quality == nullptr)
  {
    const std::vector<std::string> names = CohortQualityNames();
    obsolete.insert(obsolete.end(), names.begin(), names.end());
  }
  if (output.Alignment == nullptr)
  {
    obsolete.emplace_back("alignment.csv");
  }
  if (output.Correspondence == nullptr)
  {
    obsolete.emplace_back("correspondence.csv");
  }
  if (output.Reparametrisation == nullptr)
  {
    obsolete.emplace_back("reparametrisation.csv");
  }
  for (int mode = ShownModes(group); mode < MostShownModes; ++mode)
  {
    const std::string name = "mode_" + std::to_string(mode + 1);
    obsolete.insert(obsolete.end(), {name + "_minus.json", name + "_plus.json"});
  }
  WriteOutputSet(
      folder,
      [&](const std::filesystem::path& stage) { WriteGroupFiles(group, output, stage, program); },
      obsolete);
}
} // namespace palpate
