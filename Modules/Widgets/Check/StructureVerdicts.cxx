#include "StructureVerdicts.h"

#include "CheckText.h"
#include "ScreenString.h"
#include "StructurePlaces.h"

#include <utility>

namespace palpate
{
namespace
{
std::set<std::filesystem::path> LabelFilesOf(const StudyState& state)
{
  std::set<std::filesystem::path> files;
  for (const SceneStructure& structure : state.Structures)
  {
    if (structure.Source() == SceneSource::Label)
    {
      files.insert(structure.File);
    }
  }
  return files;
}
} // namespace

StructureVerdicts::StructureVerdicts(StudyController& study, QObject* parent)
    : QObject(parent), Study(study)
{
  connect(&study, &StudyController::StateChanged, this, &StructureVerdicts::Forget);
  connect(&study, &StudyController::ProductsChanged, this, &StructureVerdicts::Forget);
}

StructureVerdicts::Masks StructureVerdicts::Now() const
{
  const StudyState& state = this->Study.State();
  Masks masks;
  masks.Labels = this->Study.Current().Pipeline().Newest<Segmentation>(SceneStep::Segmentation);
  masks.Files = LabelFilesOf(state);
  if (masks.Labels == nullptr)
  {
    return masks;
  }
  StructurePlaces places;
  places.Take(state, masks.Labels);
  Segmentation named = *masks.Labels; // its layers are shared
  for (std::size_t n = 0; n < named.Segments.size(); ++n)
  {
    const int id = places.IdOf(named.Segments[n].Label);
    if (const SceneStructure* structure = FindStructure(state, id))
    {
      masks.Ids[n] = id;
      named.Segments[n].Name = TitleOf(*structure);
    }
  }
  masks.Named = std::make_shared<const Segmentation>(std::move(named));
  return masks;
}

bool StructureVerdicts::AreThere(const std::shared_ptr<const Segmentation>& labels,
                                 const std::set<std::filesystem::path>& files) const
{
  return labels != nullptr && files == LabelFilesOf(this->Study.State()) &&
         labels == this->Study.Current().Pipeline().Newest<Segmentation>(SceneStep::Segmentation);
}

bool StructureVerdicts::Take(const Masks& masks, const MaskChecks& found)
{
  const bool areThere = this->AreThere(masks.Labels, masks.Files);
  this->Found.clear();
  for (const auto& [segment, id] : areThere ? masks.Ids : std::map<std::size_t, int>())
  {
    const OrganJudgement& judgement = found.Cases.front().Judgements.at(segment);
    this->Found[id] = {judgement.Is, ScreenString(JudgementSentence(judgement)),
                       judgement.Reason.Place, masks.Named->Segments[segment].Name};
  }
  this->Labels = masks.Labels;
  this->Files = masks.Files;
  Q_EMIT Changed();
  return areThere;
}

const StructureVerdict* StructureVerdicts::Of(const SceneStructure& structure) const
{
  const auto found = this->Found.find(structure.Id);
  return found != this->Found.end() && found->second.Name == TitleOf(structure) ? &found->second
                                                                                : nullptr;
}

void StructureVerdicts::Forget()
{
  if (!this->Found.empty() && !this->AreThere(this->Labels.lock(), this->Files))
  {
    this->Found.clear();
    Q_EMIT Changed();
  }
}
} // namespace palpate
