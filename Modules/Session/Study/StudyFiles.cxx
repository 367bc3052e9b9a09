#include "StudyFiles.h"

#include "FitFiles.h"
#include "FitStructure.h"
#include "OutputFolder.h"
#include "OutputNames.h"
#include "StudyMarkups.h"
#include "StudyScene.h"
#include "SurfaceFile.h"
#include "TouchSceneFile.h"
#include "WholeFile.h"

namespace palpate
{
namespace
{
std::filesystem::path FolderOf(const StudyState& state, const StudyStructure& structure,
                               const std::filesystem::path& folder)
{
  Segment segment;
  segment.Label = structure.Label;
  segment.Name = structure.Name;
  return folder / CaseFolderName(CaseNameOf(state.SegmentationFile), segment);
}

void WriteStructure(const StudyStructure& structure, const StudyPipeline& pipeline,
                    const std::filesystem::path& folder, const std::string& program)
{
  const auto volume = pipeline.Newest<Volume>(StudyStep::Volume);
  const auto fit = pipeline.Newest<FitResult>(StudyStep::Model, structure.Label);
  const auto surface = pipeline.Newest<FitSurface>(StudyStep::Surface, structure.Label);
  if (fit != nullptr)
  {
    WriteFitFiles(*fit, volume.get(), folder, program);
  }
  else if (surface != nullptr && !surface->IsOver)
  {
    WriteOutputSet(folder, [&surface](const std::filesystem::path& stage)
                   { WriteSurface(stage / "surface.vtp", surface->Found.Surface); });
  }
}
} // namespace

void WriteStudyFiles(const StudyState& state, const StudyPipeline& pipeline,
                     const std::filesystem::path& folder, const std::string& program)
{
  MakeOutputFolder(folder);
  for (const StudyStructure& structure : state.Structures)
  {
    WriteStructure(structure, pipeline, FolderOf(state, structure, folder), program);
  }
  const TouchSettings scene = SceneOfStudy(state, pipeline, folder);
  WriteOutputSet(folder,
                 [&](const std::filesystem::path& stage)
                 {
                   if (!scene.Structures.empty())
                   {
                     WriteWholeFile(stage / "scene.json", TouchSceneText(scene, folder));
                   }
                   if (!state.Landmarks.empty() || !state.Distances.empty())
                   {
                     WriteMarkups(stage / "markups.mrk.json", state.Landmarks, state.Distances);
                     WriteMarkups(stage / "markups.csv", state.Landmarks, state.Distances);
                   }
                 });
}

namespace
{
// By its mask, as the study protects it, whatever it is touched by.
TouchStructureSettings ForbiddenEntry(const StudyState& state, const StudyStructure& structure)
{
  TouchStructureSettings forbidden;
  forbidden.Name = structure.Name;
  forbidden.File = state.SegmentationFile;
  forbidden.Labels = {std::to_string(structure.Label)};
  forbidden.IsSeen = false;
  forbidden.IsTouched = false;
  forbidden.IsForbidden = true;
  forbidden.AlarmDistance = structure.AlarmDistance;
  return forbidden;
}
} // namespace

TouchSettings SceneOfStudy(const StudyState& state, const StudyPipeline& pipeline,
                           const std::filesystem::path& folder)
{
  TouchSettings scene;
  scene.Tool = state.Tool;
  scene.Device = state.Device;
  scene.Rate = state.Rate;
  scene.Scale = state.Placement.Scale;
  for (const StudyContact& contact : ContactsOf(state, pipeline))
  {
    const StudyStructure& structure = *FindStructure(state, contact.Label);
    TouchStructureSettings touch;
    touch.Name = structure.Name;
    touch.Stiffness = structure.Stiffness;
    touch.Friction = structure.Friction;
    const auto trade = pipeline.Newest<StudyTrade>(StudyStep::Trade, contact.Label);
    const StudyFeel feel = FeelOf(state, structure, trade.get());
    touch.Degree = feel.Degree;
    touch.Interpolation = feel.Interpolation;
    touch.Smoothing = state.FieldSmoothing;
    const TouchAppearance& looks = contact.Contact->Looks;
    touch.File = FolderOf(state, structure, folder) / (looks.Model ? "model.json" : "surface.vtp");
    if (looks.Field != nullptr)
    {
      touch.File = state.SegmentationFile;
      touch.Labels = {std::to_string(structure.Label)};
      touch.Representation = TouchRepresentation::SubVoxel;
    }
    if (structure.IsDrilled())
    {
      touch.Drill = structure.Drill;
      touch.Interpolation = FieldInterpolation::Trilinear;
    }
    scene.Structures.push_back(std::move(touch));
  }
  scene.Drill = state.Drill;
  for (const StudyStructure& structure : state.Structures)
  {
    if (structure.IsForbidden)
    {
      scene.Structures.push_back(ForbiddenEntry(state, structure));
    }
  }
  return scene;
}
} // namespace palpate
