#include "StudyProblems.h"

#include "SceneContacts.h"
#include "SofteningNotes.h"

#include <algorithm>
#include <memory>

namespace palpate
{
namespace
{
std::vector<std::string> RemarksOf(const Volume& volume)
{
  return volume.Notes;
}

std::vector<std::string> RemarksOf(const Segmentation& labels)
{
  return labels.Remarks();
}
} // namespace

std::vector<std::string> StudyProblems::Now(const StudyTouchReading& reading)
{
  this->Messages.clear();
  this->AddNotes();
  this->AddFailures();
  this->AddProtection();
  this->AddHold(reading);
  this->Add(this->Open.TouchProblem());
  this->Add(this->Open.ReplayProblem());
  this->Add(this->Open.DrilledProblem());
  return this->Messages;
}

// A step's failure is also that of all later ones.
void StudyProblems::Add(const std::string& message)
{
  const bool isThere =
      std::find(this->Messages.begin(), this->Messages.end(), message) != this->Messages.end();
  if (!message.empty() && !isThere)
  {
    this->Messages.push_back(message);
  }
}

void StudyProblems::AddNotes()
{
  const StudyPipeline& pipeline = this->Open.Pipeline();
  const auto add = [this](const auto& image)
  {
    if (image != nullptr)
    {
      for (const std::string& note : RemarksOf(*image))
      {
        this->Add(image->Source.filename().string() + ": " + note);
      }
    }
  };
  add(pipeline.Newest<Volume>(SceneStep::Volume));
  for (const StudyVolume& volume : this->Open.State().Volumes)
  {
    add(pipeline.Newest<Volume>(SceneStep::Volume, volume.Id));
  }
  add(pipeline.Newest<Segmentation>(SceneStep::Segmentation));
  const auto products = [&pipeline](SceneStep step, int id)
  { return pipeline.NewestProduct(step, id); };
  for (const SofteningNote& note : SofteningNotes(this->Open.State(), products))
  {
    this->Add(note.Text);
  }
}

void StudyProblems::AddFailures()
{
  const StudyPipeline& pipeline = this->Open.Pipeline();
  for (const SceneStep step : Steps)
  {
    const StudyStepState state = pipeline.StateOf(step);
    if (state.Is == StudyStepState::Kind::Failed && step != SceneStep::Protection)
    {
      this->Add(state.Message);
    }
  }
  for (const std::string& advice : pipeline.Advice())
  {
    this->Add(advice);
  }
}

// A structure that cannot be protected is told at once, with the consequence for the drill.
void StudyProblems::AddProtection()
{
  std::vector<StudyForbidden> failed = ForbiddenOf(this->Open.State(), this->Open.Pipeline());
  failed.erase(std::remove_if(failed.begin(), failed.end(),
                              [](const StudyForbidden& one)
                              { return one.State.Is != StudyStepState::Kind::Failed; }),
               failed.end());
  if (!failed.empty())
  {
    this->Add(DrillHoldText(failed));
  }
}

// Of a drill that was started by its key or by the device's button; until it may turn.
void StudyProblems::AddHold(const StudyTouchReading& reading)
{
  if (!this->Open.Touch().IsRunning() || reading.Drill.Hold.empty())
  {
    this->Hold.clear();
  }
  else if (reading.Newest.IsDrilling)
  {
    this->Hold = reading.Drill.Hold;
  }
  this->Add(this->Hold);
}
} // namespace palpate
