#include "SoftenCommand.h"

#include "CancelDeadline.h"
#include "CommandProgress.h"
#include "Console.h"
#include "DecimalText.h"
#include "FileFormat.h"
#include "FileType.h"
#include "FiniteNumber.h"
#include "InputError.h"
#include "Interruption.h"
#include "ModelFile.h"
#include "ModelSoftening.h"
#include "PatientSides.h"
#include "SegmentationFile.h"
#include "SoftenJson.h"
#include "SofteningReport.h"
#include "StageClock.h"
#include "VolumeFile.h"
#include "WholeFile.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <optional>
#include <ostream>

namespace palpate::cli
{
namespace
{
// "60kPa", "60 kPa" or "60".
double Kilopascal(const std::string& option, const std::string& word)
{
  std::string number = word;
  const std::string unit = "kPa";
  if (number.size() > unit.size() &&
      number.compare(number.size() - unit.size(), unit.size(), unit) == 0)
  {
    number.erase(number.size() - unit.size());
  }
  while (!number.empty() && number.back() == ' ')
  {
    number.pop_back();
  }
  const std::optional<double> value = ParseNumber(number);
  if (!value || !(*value > 0.0))
  {
    throw InputError(option + " " + word + " is not a modulus; give a positive number of kPa.");
  }
  return *value;
}

// Of words that are given once for all files, or once for each.
template <typename Word>
Word WordOf(const std::vector<Word>& words, std::size_t file, const Word& otherwise)
{
  return words.empty() ? otherwise : words[words.size() > 1 ? file : 0];
}

void RequireOneForAllOrEach(std::size_t words, std::size_t files, const std::string& options)
{
  if (words != files && words > std::min<std::size_t>(files, 1))
  {
    throw InputError("give " + options + ".");
  }
}

std::vector<Segment> SegmentsNamed(const Segmentation& read, const std::string& label)
{
  return label.empty() ? read.Segments : std::vector<Segment>{read.Find(label)};
}

void Tell(const std::vector<std::string>& notes, Console& console)
{
  for (const std::string& note : notes)
  {
    console.Note(note);
  }
}

// What was built.
std::string TextOf(const ModelSoftness& softness)
{
  const ComplianceMaps& maps = *softness.Elasticity;
  return std::to_string(softness.Account.Unknowns) + " unknowns, elements of " +
         FixedText(softness.Account.ElementEdge, 1) + " mm at the surface; the maps leave out " +
         FixedText(100.0 * maps.FitError.Rms, 1) + " % of the compliance, at most " +
         FixedText(100.0 * maps.FitError.Largest, 1) + " %; patches up to " +
         FixedText(maps.LargestPatch, 1) + " mm\n";
}
} // namespace

std::string SoftenCommand::Examples() const
{
  return "  palpate soften gland.json --output soft.json          20 kPa, held all round\n"
         "  palpate soften gland.json --tissue 20kPa --lesion lesion.nii.gz \\\n"
         "    --lesion-modulus 60kPa --free posterior --output soft.json\n"
         "  palpate soften gland.json --elastography mre.nii.gz --output soft.json\n"
         "  palpate touch soft.json --tool-radius 8               feel it";
}

void SoftenCommand::DeclareOptions(CLI::App& app)
{
  app.add_option("MODEL", this->Model, "Radial model: " + ListOfEndings(ReadableModelEndings()))
      ->required()
      ->check(FileType::Input("file"));
  app.add_option("--output", this->Output, "The model that yields, .json")
      ->required()
      ->check(FileType::Output("file", ".json"));
  app.add_option("--tissue", this->Tissue, "Young's modulus of the organ's tissue")
      ->type_name("KPA")
      ->capture_default_str();
  app.add_option("--lesion", this->Lesions,
                 "Segmentation of a part with another modulus; may be repeated, later ones count")
      ->type_name("FILE")
      ->check(FileType::Input("label"))
      ->allow_extra_args(false);
  app.add_option("--lesion-modulus", this->LesionModuli,
                 "Its Young's modulus: one for all, or one for each")
      ->type_name("KPA")
      ->allow_extra_args(false);
  app.add_option("--lesion-label", this->LesionLabels,
                 "Its structure (default: all of the file): one for all, or one for each")
      ->type_name("N|NAME")
      ->allow_extra_args(false);
  app.add_option("--elastography", this->Elastography,
                 "Image of Young's modulus in kPa, instead of --tissue where it has values")
      ->type_name("FILE")
      ->check(FileType::Input("image"));
  app.add_option("--poisson", this->Settings.PoissonRatio, "Poisson's ratio")
      ->check(FiniteNumber::Between(0.0, ElasticSolid::MostPoissonRatio))
      ->capture_default_str();
  this->DeclareSupport(app);
  this->DeclareNumbers(app);
  app.add_option("--report", this->Report,
                 "Page with a map of how hard the organ's places feel, .html")
      ->type_name("FILE")
      ->check(FileType::Output("file", ".html"));
  app.add_option("--tool-radius", this->ToolRadius,
                 "Radius of the spherical indenter for the force map and the summary, mm")
      ->type_name("MM")
      ->check(FiniteNumber::Between(0.1, 100.0))
      ->capture_default_str();
  app.add_flag("--json", this->Json,
               "Print one JSON object: what was built, how hard it feels, warnings");
  this->Images.Declare(app, "file");
  this->Images.DeclareValues(app);
}

void SoftenCommand::DeclareSupport(CLI::App& app)
{
  std::vector<std::string> names;
  for (const PatientSide& side : PatientSides())
  {
    names.emplace_back(side.Name);
  }
  app.add_option("--free", this->FreeSides,
                 "Side of the organ that lies on nothing; may be repeated (default: none)")
      ->check(CLI::IsMember(names))
      ->allow_extra_args(false);
  app.add_option("--free-angle", this->Settings.FreeDegrees,
                 "Half the angle of the cone that is free on each such side, degrees")
      ->type_name("DEG")
      ->check(FiniteNumber::Between(SofteningSettings::LeastFreeDegrees,
                                    SofteningSettings::MostFreeDegrees))
      ->capture_default_str();
  app.add_option("--support", this->Settings.BedPerMillimeter,
                 "Stiffness of what the organ lies on, kPa per mm; at most 200 times the tissue's "
                 "modulus by the organ's mean radius")
      ->type_name("KPA/MM")
      ->check(
          FiniteNumber::Between(SofteningSettings::LeastSupport, SofteningSettings::MostSupport))
      ->capture_default_str();
  app.add_option("--neighbour", this->Neighbours,
                 "Segmentation of what holds the organ where it is next to it; may be repeated")
      ->type_name("FILE")
      ->check(FileType::Input("label"))
      ->allow_extra_args(false);
  app.add_option("--neighbour-label", this->NeighbourLabels,
                 "Its structure (default: all of the file): one for all, or one for each")
      ->type_name("N|NAME")
      ->allow_extra_args(false);
  app.add_option("--neighbour-support", this->NeighbourSupports,
                 "Its stiffness instead of --support and --free, kPa per mm: one for all, or one "
                 "for each (default: 1)")
      ->type_name("KPA/MM")
      ->check(
          FiniteNumber::Between(SofteningSettings::LeastSupport, SofteningSettings::MostSupport))
      ->allow_extra_args(false);
}

void SoftenCommand::DeclareNumbers(CLI::App& app)
{
  app.add_option("--exaggerate", this->Settings.Exaggeration,
                 "Power to which contrasts with the tissue are raised, and said to be")
      ->check(FiniteNumber::Between(1.0, TissueMap::MostExaggeration))
      ->capture_default_str();
  app.add_option("--elements", this->Settings.Numbers.ElementsAcross,
                 "Finite elements along a quarter of a great circle: even; time grows with its "
                 "fifth power, memory with its fourth")
      ->check(CLI::Range(SofteningSettings::FewestElements, SofteningSettings::MostElements))
      ->capture_default_str();
  app.add_option("--degree", this->Settings.Numbers.Degree,
                 "Degree of the harmonics of the finite elements' compliance (default: " +
                     std::to_string(OrganSoftening::UsualDegree) + ", or " +
                     std::to_string(OrganSoftening::DegreeInHollows) +
                     " if the surface has a hollow with a radius below " +
                     FixedText(OrganSoftening::SharpHollow, 0) + " mm)")
      ->check(CLI::Range(4, ReducedCompliance::MostDegree));
  app.add_option("--map-degree", this->Settings.Numbers.Maps.Degree,
                 "Degree of the maps that are kept; a tick's time grows with its square")
      ->check(CLI::Range(4, ComplianceMaps::MostDegree))
      ->capture_default_str();
}

void SoftenCommand::ReadLesions(SofteningSettings& settings, Console& console) const
{
  const std::string moduli = "--lesion-modulus once for all, or once for each --lesion";
  RequireOneForAllOrEach(this->LesionModuli.size(), this->Lesions.size(), moduli);
  RequireOneForAllOrEach(this->LesionLabels.size(), this->Lesions.size(),
                         "--lesion-label once for all, or once for each --lesion");
  if (this->LesionModuli.empty() && !this->Lesions.empty())
  {
    throw InputError("give " + moduli + ".");
  }
  for (std::size_t i = 0; i < this->Lesions.size(); ++i)
  {
    SofteningSettings::Inclusion inclusion;
    inclusion.Kilopascal = Kilopascal("--lesion-modulus", WordOf(this->LesionModuli, i, {}));
    inclusion.Read = std::make_shared<const Segmentation>(
        ReadSegmentation(this->Lesions[i], this->Images.Choice()));
    inclusion.Segments = SegmentsNamed(*inclusion.Read, WordOf(this->LesionLabels, i, {}));
    Tell(inclusion.Read->Notes, console);
    settings.Inclusions.push_back(std::move(inclusion));
  }
}

void SoftenCommand::ReadNeighbours(SofteningSettings& settings, Console& console) const
{
  RequireOneForAllOrEach(this->NeighbourSupports.size(), this->Neighbours.size(),
                         "--neighbour-support once for all, or once for each --neighbour");
  RequireOneForAllOrEach(this->NeighbourLabels.size(), this->Neighbours.size(),
                         "--neighbour-label once for all, or once for each --neighbour");
  for (std::size_t i = 0; i < this->Neighbours.size(); ++i)
  {
    SofteningSettings::Neighbour neighbour;
    neighbour.KilopascalPerMillimeter =
        WordOf(this->NeighbourSupports, i, SofteningSettings::Neighbour::DefaultSupport);
    neighbour.Read = std::make_shared<const Segmentation>(
        ReadSegmentation(this->Neighbours[i], this->Images.Choice()));
    neighbour.Segments = SegmentsNamed(*neighbour.Read, WordOf(this->NeighbourLabels, i, {}));
    Tell(neighbour.Read->Notes, console);
    settings.Neighbours.push_back(std::move(neighbour));
  }
}

SofteningSettings SoftenCommand::Read(Console& console) const
{
  SofteningSettings settings = this->Settings;
  settings.TissueKilopascal = Kilopascal("--tissue", this->Tissue);
  for (const std::string& name : this->FreeSides)
  {
    for (const PatientSide& side : PatientSides())
    {
      if (name == side.Name)
      {
        settings.FreeSides.push_back(side.World);
      }
    }
  }
  if (!this->Elastography.empty())
  {
    settings.Elastography = std::make_shared<const Volume>(
        ReadVolume(this->Elastography, this->Images.ChoiceOfVolume()));
    Tell(settings.Elastography->Notes, console);
  }
  this->ReadLesions(settings, console);
  this->ReadNeighbours(settings, console);
  return settings;
}

void SoftenCommand::CheckOutputs() const
{
  if (this->Output.extension() != ".json")
  {
    throw InputError(this->Output.string() + " cannot hold a model that yields; use .json.");
  }
  if (!this->Report.empty() && this->Report.extension() != ".html")
  {
    throw InputError(this->Report.string() + " cannot hold a report; use .html.");
  }
}

int SoftenCommand::Run(Console& console)
{
  const Interruption interruption;
  this->CheckOutputs();
  SofteningSettings settings = this->Read(console);
  ModelDocument model = ReadModel(this->Model);
  std::vector<std::pair<std::string, double>> stages;
  StageClock clock(stages);
  const ModelSoftness softness =
      Cancellably(console,
                  [&]
                  {
                    return SoftenModel(model.Surface, this->Model.string(), settings,
                                       ProgressOn(console), SofteningCache::OfProcess().get());
                  });
  clock.EndStage("softening");
  console.EndProgress();
  Tell(softness.Warnings(), console);
  model.Elasticity = softness.Elasticity;
  settings.Numbers.Degree = softness.ComplianceDegree;
  for (const auto& entry : DescribeSettings(settings))
  {
    model.Provenance.Settings.push_back(entry);
  }
  WriteModel(this->Output, model);
  const SofteningReport report(model, softness, this->Output.filename().string(), this->ToolRadius);
  console.Output() << (this->Json ? SoftenedAsJson({this->Model, this->Output, settings, softness,
                                                    report.Forces(), this->ToolRadius,
                                                    stages.front().second})
                                  : TextOf(softness) + report.Sentence() + "\n");
  if (!this->Report.empty())
  {
    WriteWholeFile(this->Report, report.Page());
  }
  return 0;
}
} // namespace palpate::cli
