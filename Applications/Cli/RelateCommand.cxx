#include "RelateCommand.h"

#include "CaseProcesses.h"
#include "CaseTally.h"
#include "Console.h"
#include "FileFormat.h"
#include "FileType.h"
#include "FiniteNumber.h"
#include "Interruption.h"
#include "ModelFile.h"
#include "OutputFolder.h"
#include "ProcessorCount.h"
#include "RelationFiles.h"
#include "RelationJson.h"
#include "RelationPage.h"
#include "ScreenText.h"
#include "SurfaceFile.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <ostream>

namespace palpate::cli
{
namespace
{
void PrintNotes(const OrganRelations& found, Console& console)
{
  for (const std::string& note : found.Notes)
  {
    console.Note(note);
  }
  for (const RelatedOrgan& organ : found.Organs)
  {
    for (const std::string& note : organ.Notes)
    {
      console.Note(organ.Name + " " + note);
    }
    if (organ.Tube.IsLong && !organ.TubeMessage.empty())
    {
      console.Note(organ.Name + " " + organ.TubeMessage + ": it has no calibre");
    }
  }
}
} // namespace

std::string RelateCommand::Examples() const
{
  return "  palpate relate masks --output related              a folder of masks, all pairs\n"
         "  palpate relate labels.nii.gz --label 1,2,5         three structures of a label map\n"
         "  palpate relate masks --of tumour --margin 2,5,10   a tumour's margins\n"
         "  palpate relate fitted --output related             the models that fit wrote\n"
         "  palpate relate mask.nii.gz --definition ibsi --json   shape features as radiomics has "
         "them";
}

void RelateCommand::DeclareOptions(CLI::App& app)
{
  app.add_option("FILE", this->Inputs,
                 "Segmentations, a folder of masks, surfaces (" +
                     ListOfEndings(SurfaceFormats().ReadEndings()) + "), models (" +
                     ListOfEndings(ReadableModelEndings()) +
                     ") or a folder of models that fit wrote; all of one patient")
      ->required()
      ->check(FileType::Input("file"));
  app.add_option("--label", this->Settings.Labels, "Structures of segmentations (default: all)")
      ->type_name("N|NAME")
      ->delimiter(',');
  app.add_option("--of", this->Settings.Of, "Only pairs with the organ of this name")
      ->type_name("NAME");
  app.add_option("--contact", this->Settings.Relation.Contact,
                 "Surfaces as near as this are in contact, mm")
      ->type_name("MM")
      ->check(FiniteNumber::Between(0.0, 100.0))
      ->capture_default_str();
  app.add_option("--margin", this->Settings.Relation.Margins,
                 "Distances within which areas and volumes are counted, mm")
      ->type_name("MM")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(FiniteNumber::Between(0.0, 1000.0))
      ->capture_default_str();
  app.add_option("--definition", this->Definition,
                 "Surface of masks: the shape behind the voxels (subvoxel), or that of the Image "
                 "Biomarker Standardisation Initiative, for comparison with radiomics (ibsi)")
      ->check(CLI::IsMember({"subvoxel", "ibsi"}))
      ->capture_default_str();
  app.add_option("--thickness", this->Thickness,
                 "Thickness at a point: the largest ball that touches the surface there from "
                 "inside (spheres), or the inward normal up to the opposite side (rays)")
      ->check(CLI::IsMember({"spheres", "rays"}))
      ->capture_default_str();
  app.add_flag("--calibre", this->Settings.Measures.Calibre,
               "Also measure tubes along their axes: organs at least five times as long as wide");
  app.add_flag("--keep-cuts", this->Settings.Measures.KeepCuts,
               "Count where the border of an image cuts an organ as its surface");
  this->Images.Declare(app, "folder");
  this->Images.DeclareValues(app);
  app.add_option("--output", this->Output,
                 "Folder for report.html, organs.csv, pairs.csv, relations.json and surfaces with "
                 "maps (default: write nothing)")
      ->type_name("DIR")
      ->check(FileType::OutputFolder({"report.html", "organs.csv", "pairs.csv"}));
  app.add_option("--jobs", this->Jobs, "Organs measured at a time (default: one per processor)")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  app.add_flag("--json", this->Json, "Print one JSON object");
}

int RelateCommand::Run(Console& console)
{
  const Interruption interruption;
  if (!this->Output.empty())
  {
    CheckOutputFolder(this->Output);
  }
  this->Settings.Images = this->Images.Choice();
  OrganMeasures& measures = this->Settings.Measures;
  measures.Mesh = this->Definition == "ibsi" ? MaskMesh::Ibsi : MaskMesh::SubVoxel;
  measures.Thickness = this->Thickness == "rays" ? ThicknessRule::Rays : ThicknessRule::Spheres;
  this->Settings.Jobs = this->Jobs > 0 ? static_cast<std::size_t>(this->Jobs) : ProcessorCount();
  std::vector<double>& margins = this->Settings.Relation.Margins;
  std::sort(margins.begin(), margins.end());
  const OrganRelations found = OrganRelations::Of(this->Inputs, this->Settings,
                                                  [&](double fraction, const std::string& stage)
                                                  {
                                                    console.Progress(fraction, stage);
                                                    return !Interruption::WasAsked();
                                                  });
  if (!this->Output.empty())
  {
    console.Progress(1.0, "writing");
    WriteRelationFiles(found, this->Output);
  }
  console.EndProgress();
  PrintNotes(found, console);
  CaseTally tally;
  for (const RelatedOrgan& organ : found.Organs)
  {
    tally.Add(organ.IsMeasured() ? FitResult::Outcome::Fitted : FitResult::Outcome::BadInput);
    if (!organ.IsMeasured())
    {
      console.Error(organ.Name + ": " + organ.Message);
    }
  }
  console.Output() << (this->Json ? RelationJson(found, this->Output.string()) + "\n"
                                  : RelationText(found));
  return tally.Conclude(console, "were not measured");
}
} // namespace palpate::cli
