#include "CohortCommand.h"

#include "CaseProcesses.h"
#include "CohortCorrespondence.h"
#include "CohortEffectFiles.h"
#include "CohortExport.h"
#include "CohortFit.h"
#include "CohortPrior.h"
#include "CohortQuality.h"
#include "CohortReparametrisation.h"
#include "CommandProgress.h"
#include "Console.h"
#include "FileType.h"
#include "InputError.h"
#include "Interruption.h"
#include "OutputFolder.h"
#include "ProcessorCount.h"
#include "ProgramVersion.h"
#include "Progress.h"
#include "RepeatedEffectFiles.h"
#include "ScreenText.h"
#include "ShapeSynthesis.h"

#include <CLI/CLI.hpp>
#include <iomanip>
#include <ostream>

namespace palpate::cli
{
namespace
{
// The tables of all folders, their models' paths as seen from `output`.
CohortTable JoinCohorts(const std::vector<std::string>& folders,
                        const std::filesystem::path& output)
{
  CohortTable joined;
  for (const std::string& folder : folders)
  {
    const CohortTable table = CohortTable::Read(std::filesystem::path(folder) / "cohort.csv");
    if (table.Rows().empty())
    {
      throw InputError(folder + " has no cohort.csv with cases; name a folder that `palpate fit` "
                                "wrote from a folder or a --manifest");
    }
    std::vector<CohortRow> rows = table.Rows();
    for (CohortRow& row : rows)
    {
      const std::filesystem::path model =
          std::filesystem::absolute(folder / row.Model).lexically_normal();
      const std::filesystem::path base = std::filesystem::absolute(output).lexically_normal();
      row.Model = row.Model.empty() ? row.Model : model.lexically_relative(base);
    }
    joined.Add(rows);
  }
  return joined;
}

// Without cohort.csv, which is read before it is replaced, and those of --export.
std::vector<std::string> WrittenNames()
{
  return {"cohort.html",
          "mean.json",
          "mean.vtp",
          "shape.json",
          "coefficients.csv",
          "modes.csv",
          "variance.csv",
          "measures.csv",
          "effects.csv",
          "effects.vtp",
          "design.csv",
          "alignment.csv",
          "correspondence.csv",
          "distances.csv",
          "distances.vtp",
          "reparametrisation.csv",
          "model_quality.csv",
          "repeated.csv",
          "repeated_variances.csv",
          "asymmetry.csv",
          "asymmetry_anova.csv",
          "asymmetry.vtp"};
}
} // namespace

std::string CohortCommand::Examples() const
{
  return "  palpate cohort out                      mean, modes and tables of out/cohort.csv\n"
         "  palpate cohort out --align ellipsoid    in each body's principal axes\n"
         "  palpate cohort a b c --output all       cases that were fitted separately\n"
         "  palpate cohort out --covariates patients.csv --formula \"~ age + log(psa) + center\"\n"
         "                                          what explains the shape, with p-values\n"
         "  palpate cohort out --covariates scans.csv --repeated patient --time months --formula "
         "\"~ "
         "months * drug\"\n"
         "                                          patients who were scanned several times\n"
         "  palpate cohort out --masks glands --model radial --prior prior.json\n"
         "                                          what palpate complete takes\n"
         "  palpate cohort out --masks glands --covariates patients.csv --formula \"~ age\"\n"
         "                                          the same from the masks, in one command";
}

void CohortCommand::DeclareOptions(CLI::App& app)
{
  app.add_option("OUT", this->Folders,
                 "Folders with a cohort.csv written by fit; with --masks, the folder to write")
      ->required()
      ->check(FileType::OutputFolder(WrittenNames()));
  app.add_option(
         "--masks", this->Masks,
         "First fit the masks of this folder, of this table (--manifest of fit), or of this "
         "pattern, such as sub-{id}/anat/sub-{id}_*_dseg.nii.gz, with the options of fit; "
         "resumes after a stop")
      ->check(FileType::Input("label"));
  this->Options.DeclareModel(app);
  app.add_option("--output", this->OutputFolder,
                 "Folder for tables and cohort.html (default: OUT, if it is a single folder)")
      ->type_name("DIR")
      ->check(FileType::OutputFolder(WrittenNames()));
  app.add_option("--label", this->Label, "Structure, by number or name, if there are several")
      ->type_name("N|NAME");
  this->DeclareAlignment(app);
  app.add_flag("--names", this->ShowsNames,
               "Name the cases in cohort.html, which numbers them otherwise");
  app.add_flag("--anonymous", this->IsAnonymous,
               "Number the cases, after they were matched with covariates, in all that is written "
               "into --output, which then has no cohort.csv")
      ->excludes(app.get_option("--names"));
  app.add_option("--export", this->Exports,
                 "Also write the cases as files of another tool, into a folder of this name in the "
                 "output: spharm-pdm, shapeworks")
      ->check(CLI::IsMember({"spharm-pdm", "shapeworks"}))
      ->type_name("TOOL");
  app.add_option("--shape", this->Shape,
                 "Write shape.json: the mean plus standard deviations of modes, such as 1:2,3:-1 "
                 "(0: the mean)")
      ->type_name("MODE:SD,...");
  app.add_option(
         "--prior", this->Prior,
         "Also write what the cases' models say of the organ, for palpate complete (no case "
         "is named); of surface models better with --reparametrise")
      ->type_name("FILE")
      ->check(FileType::Output("file", ".json"));
  app.add_option("--known", this->Known,
                 "With --prior, of surface models: a folder with a cohort.csv of another organ of "
                 "the same cases, which palpate complete --known then takes")
      ->needs("--prior")
      ->type_name("DIR")
      ->check(FileType::Input("directory"));
  this->DeclareCovariates(app);
}

void CohortCommand::DeclareAlignment(CLI::App& app)
{
  app.add_option("--align", this->Axes,
                 "patient: the patients' axes; ellipsoid: each body's principal axes; procrustes: "
                 "from the patients' axes each body turned to the mean")
      ->check(CLI::IsMember({"patient", "ellipsoid", "procrustes"}))
      ->capture_default_str();
  app.add_option(
         "--align-to", this->Reference,
         "With --align procrustes: the model to which all are turned, instead of their mean "
         "(such as an earlier mean.json), so that no case depends on the others")
      ->check(FileType::Input("file"));
  app.add_flag("--scale", this->ScalesShapes, "With --align procrustes: all shapes to one size");
  app.add_flag("--reparametrise", this->MovesParameters,
               "Move the parameters of surface models, so that the group's modes have a shorter "
               "description; every case then depends on all others");
}

std::optional<CohortAlignment> CohortCommand::Align(CohortGroup& group,
                                                    const KernelProgress& progress) const
{
  if (this->Axes == "procrustes")
  {
    return AlignCohortGroup(group, this->ScalesShapes, this->Reference, progress);
  }
  if (this->ScalesShapes || !this->Reference.empty())
  {
    throw InputError("--scale and --align-to need --align procrustes");
  }
  return std::nullopt;
}

void CohortCommand::DeclareCovariates(CLI::App& app)
{
  app.add_option(
         "--covariates", this->Request.File,
         "Table of the cases' covariates, with a header (separated by commas, semicolons or tabs)")
      ->check(FileType::Input("file", ".csv"));
  app.add_option("--id", this->Request.Id,
                 "Column with the cases' names or a part of them (default: case, id, ...)")
      ->type_name("COLUMN");
  app.add_option("--formula", this->Request.Formula,
                 "Linear model of the shape on columns, volume_ml and area_mm2, as in R: ~ age + "
                 "log(psa) + a*b, "
                 "factor(x), I(x^2)")
      ->type_name("FORMULA");
  app.add_option("--reference", this->Request.References,
                 "Reference level of a factor (default: the first)")
      ->type_name("COLUMN=LEVEL");
  app.add_option("--permutations", this->Request.Effects.Permutations.Count,
                 "Permutations of the tests on the surface")
      ->check(CLI::Range(99, 1000000))
      ->capture_default_str();
  app.add_option("--beyond-modes", this->Request.Effects.BeyondModes,
                 "Look on the surface for what the first N modes do not explain, for small, local "
                 "effects; choose it before looking at results")
      ->type_name("N")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  app.add_option("--seed", this->Request.Effects.Permutations.Seed,
                 "Of permutations and random shapes")
      ->capture_default_str();
  app.add_option("--repeated", this->Request.Repeated.Patient,
                 "Column with the patients, of whom some have several cases: mixed models with a "
                 "random intercept of each patient instead of permutations")
      ->type_name("COLUMN");
  app.add_option("--time", this->Request.Repeated.Time,
                 "Column with the time of each case, part of the formula: with --repeated also a "
                 "random slope of each patient")
      ->type_name("COLUMN");
  app.add_option("--asymmetry", this->Sides,
                 "Compare left with right: midline for organs and their own mirror images, or the "
                 "columns of patient and side (left, right) of pairs, as PATIENT,SIDE")
      ->delimiter(',')
      ->expected(1, 2)
      ->type_name("midline|COLUMN,COLUMN");
}

std::vector<SidePair> CohortCommand::PairSides(CohortGroup& group,
                                               std::vector<std::string>& notes) const
{
  if (this->Sides.size() != 2)
  {
    return {};
  }
  if (this->Request.File.empty())
  {
    throw InputError("--asymmetry of pairs needs --covariates with " + this->Sides[0] + " and " +
                     this->Sides[1]);
  }
  std::vector<std::string> ofTable; // told with the covariates
  const CovariateTable table = CovariatesOf(group, this->Request, ofTable);
  std::vector<SidePair> pairs = FindSidePairs(group, table, this->Sides[0], this->Sides[1], notes);
  MirrorRightSides(group, pairs);
  return pairs;
}

int CohortCommand::FitMasks(Console& console) const
{
  if (this->Folders.size() != 1)
  {
    throw InputError("--masks are fitted into one folder, but " +
                     std::to_string(this->Folders.size()) + " are named");
  }
  const ImageOptions images;
  CohortFit fit(this->Options.Settings(),
                this->Label.empty() ? std::vector<std::string>() : std::vector{this->Label},
                images);
  fit.SetJobs(ProcessorCount());
  if (std::filesystem::path(this->Masks).extension() == ".csv")
  {
    fit.TakeManifest(this->Masks, {});
  }
  else
  {
    fit.TakeMasks({this->Masks});
  }
  return fit.Run(this->Folders.front(), console);
}

void CohortCommand::CheckOutputs() const
{
  if (this->Sides.size() == 1 && this->Sides.front() != "midline")
  {
    throw InputError("--asymmetry is midline or two columns, such as patient,side");
  }
  if (this->OutputFolder.empty() && this->Folders.size() > 1)
  {
    throw InputError("--output is required for several cohorts: the folder of their joint results");
  }
  if (this->OutputFolder.empty() && this->IsAnonymous)
  {
    throw InputError("--anonymous needs --output: the folders of the cases name them");
  }
  CheckOutputFolder(this->Output()); // told before the long work
}

void CohortCommand::WriteOthers(const CohortGroup& group, const CohortTable& table,
                                Console& console) const
{
  for (const std::string& tool : this->Exports)
  {
    ExportCohort(group, this->Output(),
                 tool == "shapeworks" ? ExportKind::ShapeWorks : ExportKind::SpharmPdm,
                 this->Output() / tool, ProgressOn(console));
    console.EndProgress();
  }
  if (!this->Shape.empty())
  {
    WriteSynthesis(group, this->Shape, this->Output(), ProgramVersion());
  }
  if (!this->OutputFolder.empty() && !this->IsAnonymous)
  {
    table.Write(this->Output() / "cohort.csv");
  }
}

void CohortCommand::Print(const CohortGroup& group, const std::vector<std::string>& notes,
                          const CovariateModel& model, const std::string& asymmetry,
                          Console& console) const
{
  for (const CohortNote& note : group.Notes)
  {
    console.Note(note.Case + note.Text + note.Reason);
  }
  for (const std::string& note : notes)
  {
    console.Note(note);
  }
  if (model.Effects() != nullptr)
  {
    console.Output() << CohortEffectText(*model.Effects());
  }
  if (model.Repeated() != nullptr)
  {
    console.Output() << RepeatedEffectText(*model.Repeated());
  }
  console.Output() << asymmetry;
  console.Output() << group.Rows.size() << " cases, degree " << DegreeOf(group.Models.front())
                   << ", " << group.Modes.Modes.cols() << " modes";
  if (group.Modes.Modes.cols() > 0)
  {
    console.Output() << std::fixed << std::setprecision(1) << "; the first explains "
                     << 100.0 * group.Modes.Explained[0] << " %";
  }
  console.Output() << ": " << Printable((this->Output() / "cohort.html").string()) << '\n';
}

int CohortCommand::Run(Console& console)
{
  const Interruption interruption;
  this->CheckOutputs();
  const std::filesystem::path output = this->Output();
  const int code = this->Masks.empty() ? 0 : this->FitMasks(console);
  const CohortTable table = JoinCohorts(this->Folders, output);
  const ProgressFunction progress = ProgressOn(console);
  const auto stage = [&progress](const char* name) -> KernelProgress
  { return [&progress, name](double fraction) { return progress(fraction, name); }; };
  CohortGroup group =
      MakeCohortGroup(table, output, this->Label,
                      this->Axes == "ellipsoid" ? AlignmentAxes::Ellipsoid : AlignmentAxes::Patient,
                      stage("models"));
  std::vector<std::string> notes;
  const std::vector<SidePair> pairs = this->PairSides(group, notes);
  const std::optional<CohortAlignment> alignment = this->Align(group, stage("alignment"));
  RandomShapeSettings random;
  random.Seed = this->Request.Effects.Permutations.Seed;
  std::optional<CohortReparametrisation> moved;
  if (this->MovesParameters)
  {
    moved = ReparametriseCohortGroup(group, random, stage("parameters"));
  }
  if (!this->Shape.empty())
  {
    SynthesizeShape(group, this->Shape); // a mistake in it is told before the long work
  }
  if (!this->Prior.empty())
  {
    WriteCohortPrior(group,
                     this->Known.empty() ? CohortTable() : JoinCohorts({this->Known}, this->Known),
                     this->Known, this->Prior);
  }
  CovariateRequest request = this->Request;
  request.IsForSides = this->Sides.size() == 2;
  const CovariateModel model(group, request, notes, stage("permutations"));
  std::optional<CohortAsymmetry> asymmetry;
  if (!this->Sides.empty())
  {
    asymmetry = FindCohortAsymmetry(group, pairs, request.Effects.Permutations, stage("sides"));
  }
  console.EndProgress();
  if (this->IsAnonymous)
  {
    NumberCases(group);
    notes.emplace_back("the cases are numbered in the order of cohort.csv, without those omitted");
  }
  const CohortQuality quality = FindCohortQuality(group, random);
  const CohortCorrespondence correspondence =
      FindCohortCorrespondence(group, stage("correspondence"));
  console.EndProgress();
  WriteCohortGroup(group,
                   {model.Effects(), this->ShowsNames, &quality, alignment ? &*alignment : nullptr,
                    &correspondence, moved ? &*moved : nullptr, model.Repeated(),
                    asymmetry ? &*asymmetry : nullptr},
                   output, ProgramVersion());
  this->WriteOthers(group, table, console);
  this->Print(group, notes, model, asymmetry ? asymmetry->Text() : std::string(), console);
  return code;
}
} // namespace palpate::cli
