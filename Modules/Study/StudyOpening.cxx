#include "StudyOpening.h"

#include "FileStamp.h"
#include "ModelFile.h"
#include "SceneReading.h"
#include "StudyMarkupsReader.h"
#include "StudyStructures.h"

#include <utility>

namespace palpate
{
void StudyOpening::Read(SceneStep step,
                        std::function<Taking(const ProgressFunction& progress)> read,
                        Outcome outcome)
{
  const auto id = std::make_shared<StudyJobs::Id>();
  StudyJob job;
  job.IsUrgent = true;
  job.Work =
      [this, id, read = std::move(read), done = outcome.Done](const ProgressFunction& progress)
  {
    // `this` may only be used on the owner's thread, which delivers.
    return StudyJob::Delivery(
        [this, id, done, take = read(progress)]
        {
          this->Reading.erase(*id);
          take();
          done();
        });
  };
  job.Fail = [this, id, fail = std::move(outcome.Fail)](const std::string& message)
  {
    this->Reading.erase(*id);
    fail(message);
  };
  *id = this->Open.Jobs().Start(std::move(job));
  this->Reading[*id] = step;
}

// The pipeline gets what was read under the key by which it would read it.
void StudyOpening::ReadImage(const SceneNode& node, Taking take, Outcome outcome)
{
  this->Read(
      node.Step,
      [this, key = node.Key, make = node.Make,
       take = std::move(take)](const ProgressFunction& progress)
      {
        return Taking(
            [this, key, take, product = make({}, progress)]
            {
              this->Open.Pipeline().Keep(key, product);
              take();
            });
      },
      std::move(outcome));
}

void StudyOpening::ReadVolume(const std::filesystem::path& file, const std::string& series,
                              Taking take, Outcome outcome)
{
  const std::filesystem::path path = StudyPath(file);
  this->ReadImage(VolumeNode(path, series, this->Open.State().LeftHanded, {{path, StampOf(path)}}),
                  std::move(take), std::move(outcome));
}

void StudyOpening::OpenVolume(const std::filesystem::path& file, const std::string& series,
                              Outcome outcome)
{
  this->ReadVolume(
      file, series, [this, file, series] { this->Open.OpenVolume(file, series); },
      std::move(outcome));
}

void StudyOpening::AddVolume(const std::filesystem::path& file, const std::string& series,
                             Outcome outcome)
{
  this->ReadVolume(
      file, series, [this, file, series] { this->Open.AddVolume(file, series); },
      std::move(outcome));
}

void StudyOpening::OpenSegmentation(const std::filesystem::path& file, Outcome outcome)
{
  const std::filesystem::path path = StudyPath(file);
  this->ReadImage(
      SegmentationNode(path, this->Open.State().LeftHanded, {{path, StampOf(path)}}),
      [this, file] { this->Open.OpenSegmentation(file); }, std::move(outcome));
}

// Models and surfaces are small: the pipeline reads them again.
void StudyOpening::AddStructure(const std::filesystem::path& file, Outcome outcome)
{
  const std::filesystem::path path = StudyPath(file);
  const SceneNode node = IsModelFile(path) ? ModelNode(path, {}) : SurfaceNode(path, {});
  this->Read(
      node.Step,
      [this, file, make = node.Make](const ProgressFunction& progress)
      {
        make({}, progress);
        return Taking([this, file] { this->Open.AddStructure(file); });
      },
      std::move(outcome));
}

void StudyOpening::AddMarkups(const std::filesystem::path& file, Outcome outcome)
{
  this->Read(
      SceneStep::Structures,
      [this, file](const ProgressFunction&)
      {
        return Taking([this, file, markups = ReadMarkups(file)]
                      { this->Open.AddMarkups(file, markups); });
      },
      std::move(outcome));
}

void StudyOpening::OpenScene(const std::filesystem::path& file, Outcome outcome)
{
  this->Read(
      SceneStep::Structures,
      [this, file, leftHanded = this->Open.State().LeftHanded](const ProgressFunction&)
      {
        return Taking([this, file, scene = ReadWholeScene(file, leftHanded)]
                      { this->Open.AddScene(file, scene); });
      },
      std::move(outcome));
}

StudyStepState StudyOpening::StateOf(SceneStep step) const
{
  StudyStepState state;
  for (const auto& [id, ofStep] : this->Reading)
  {
    if (ofStep != step || state.Is == StudyStepState::Kind::Running)
    {
      continue;
    }
    const auto progress = this->Open.Jobs().ProgressOf(id);
    const bool isRunning = progress && progress->IsRunning;
    state.Is = isRunning ? StudyStepState::Kind::Running : StudyStepState::Kind::NeedsUpdate;
    state.Fraction = isRunning ? progress->Fraction : 0.0;
    state.Stage = isRunning ? progress->Stage : std::string();
  }
  return state;
}

void StudyOpening::Cancel(SceneStep step)
{
  for (auto one = this->Reading.begin(); one != this->Reading.end();)
  {
    const bool isOf = one->second == step;
    if (isOf)
    {
      this->Open.Jobs().Cancel(one->first);
    }
    one = isOf ? this->Reading.erase(one) : std::next(one);
  }
}

void StudyOpening::Cancel()
{
  while (!this->Reading.empty())
  {
    this->Cancel(this->Reading.begin()->second);
  }
}
} // namespace palpate
