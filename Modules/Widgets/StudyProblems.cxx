#include "StudyProblems.h"

#include "SceneContacts.h"
#include "SofteningNotes.h"

#include <algorithm>
#include <vector>

namespace palpate
{
// A step's problem also blocks all later ones. Those of volumes are separate.
void StudyProblems::TellOnce(SceneStep step, const std::string& message)
{
  const bool isOfVolume = step == SceneStep::Volume;
  const auto isTold = [&](const auto& told)
  { return (told.first == SceneStep::Volume) == isOfVolume && told.second.count(message) > 0; };
  if (std::none_of(this->Told.begin(), this->Told.end(), isTold))
  {
    this->Told[step].insert(message);
    this->Tell(message);
  }
}

void StudyProblems::TellOnce(const std::string& problem, std::string& told)
{
  if (problem != told)
  {
    told = problem;
    if (!problem.empty())
    {
      this->Tell(problem);
    }
  }
}

template <typename Image>
void StudyProblems::TellNotes(SceneStep step, const std::shared_ptr<const Image>& image,
                              std::weak_ptr<const Image>& noted)
{
  if (image != nullptr && image != noted.lock())
  {
    noted = image;
    for (const std::string& note : image->Notes)
    {
      this->TellOnce(step, image->Source.filename().string() + ": " + note);
    }
  }
}

void StudyProblems::LookAtVolume(int id)
{
  this->TellNotes(SceneStep::Volume, this->Open.Pipeline().Newest<Volume>(SceneStep::Volume, id),
                  this->NotedVolumes[id]);
}

void StudyProblems::LookAtProducts()
{
  const StudyPipeline& pipeline = this->Open.Pipeline();
  this->LookAtVolume(0);
  for (const StudyVolume& volume : this->Open.State().Volumes)
  {
    this->LookAtVolume(volume.Id);
  }
  this->TellNotes(SceneStep::Segmentation, pipeline.Newest<Segmentation>(SceneStep::Segmentation),
                  this->NotedLabels);
  const auto products = [&pipeline](SceneStep step, int id)
  { return pipeline.NewestProduct(step, id); };
  for (const SofteningNote& note : SofteningNotes(this->Open.State(), products))
  {
    this->TellOnce(SceneStep::Elasticity, note.Text);
  }
}

void StudyProblems::LookAtSteps()
{
  for (const SceneStep step : Steps)
  {
    const StudyStepState state = this->Open.Pipeline().StateOf(step);
    if (state.Is == StudyStepState::Kind::Failed && step != SceneStep::Protection)
    {
      this->TellOnce(step, state.Message);
    }
  }
  this->LookAtProtection();
  for (const std::string& advice : this->Open.Pipeline().Advice())
  {
    this->TellOnce(SceneStep::Touch, advice);
  }
}

// A structure that cannot be protected is told at once, with the consequence for the drill.
void StudyProblems::LookAtProtection()
{
  std::vector<StudyForbidden> failed = ForbiddenOf(this->Open.State(), this->Open.Pipeline());
  failed.erase(std::remove_if(failed.begin(), failed.end(),
                              [](const StudyForbidden& one)
                              { return one.State.Is != StudyStepState::Kind::Failed; }),
               failed.end());
  if (!failed.empty())
  {
    this->TellOnce(SceneStep::Protection, DrillHoldText(failed));
  }
}

void StudyProblems::LookAtTouch(const StudyTouchReading& reading)
{
  this->TellOnce(this->Open.TouchProblem(), this->ToldOfTouch);
  // Of a drill that was started by its key or by the device's button.
  if (this->Open.Touch().IsRunning() && reading.Newest.IsDrilling && !reading.Drill.Hold.empty())
  {
    this->TellOnce(SceneStep::Protection, reading.Drill.Hold);
  }
}

void StudyProblems::LookAtReplay()
{
  this->TellOnce(this->Open.ReplayProblem(), this->ToldOfReplay);
}
} // namespace palpate
