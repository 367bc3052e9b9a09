#include "StudyFiles.h"

#include "FitFiles.h"
#include "FitStructure.h"
#include "OutputFolder.h"
#include "OutputNames.h"
#include "SceneFile.h"
#include "StudyMarkups.h"
#include "SurfaceFile.h"
#include "WholeFile.h"

namespace palpate
{
namespace
{
std::filesystem::path FolderOf(const SceneStructure& structure, const std::filesystem::path& folder)
{
  Segment segment;
  segment.Label = structure.Id;
  segment.Name = structure.Name;
  return folder / CaseFolderName(CaseNameOf(structure.File), segment);
}

void WriteStructure(const SceneStructure& structure, const StudyPipeline& pipeline,
                    const std::filesystem::path& folder, const std::string& program)
{
  const auto volume = pipeline.Newest<Volume>(SceneStep::Volume);
  const auto fit = pipeline.Newest<FitResult>(SceneStep::Model, structure.Id);
  const auto surface = pipeline.Newest<FitSurface>(SceneStep::Surface, structure.Id);
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
  for (const SceneStructure& structure : state.Structures)
  {
    if (structure.Source() != SceneSource::Label)
    {
      continue; // it is already a file
    }
    WriteStructure(structure, pipeline, FolderOf(structure, folder), program);
  }
  WriteOutputSet(folder,
                 [&](const std::filesystem::path& stage)
                 {
                   if (!state.Structures.empty())
                   {
                     WriteWholeFile(stage / "scene.json", SceneText(state, folder));
                   }
                   const StudyMarkups markups = MarkupsOf(state);
                   if (!markups.IsEmpty())
                   {
                     WriteMarkups(stage / "markups.mrk.json", markups);
                     WriteMarkups(stage / "markups.csv", markups);
                   }
                 });
}
} // namespace palpate
