#include "StudyQuality.h"

#include "SteadyClock.h"

#include <utility>

namespace palpate
{
const QualityMeasurement* StudyQuality::Of(const StudyState& state,
                                           const SceneStructure& structure) const
{
  const auto found = this->Qualities.find(structure.Id);
  const bool isKnown =
      found != this->Qualities.end() && found->second.Key == QualityKey(state, structure);
  return isKnown ? found->second.Measured.get() : nullptr;
}

void StudyQuality::Measure(const StudyState& state, const SceneSettings& touched)
{
  for (const SceneStructure& structure : state.Structures)
  {
    if (!structure.IsTouchable || !HasPresets(structure) || this->Running.count(structure.Id) > 0 ||
        this->Of(state, structure) != nullptr)
    {
      continue;
    }
    const int id = structure.Id;
    const std::string key = QualityKey(state, structure);
    StudyJob job;
    job.Work = [this, id, key, structure, scene = touched](const ProgressFunction& progress)
    {
      const SteadyClock clock;
      auto measured = std::make_shared<const QualityMeasurement>(
          MeasureQuality(scene, structure, clock, progress));
      return StudyJob::Delivery(
          [this, id, key, measured = std::move(measured)]
          {
            this->Running.erase(id);
            this->Qualities[id] = {key, measured, {}};
          });
    };
    job.Fail = [this, id, key](const std::string& message)
    {
      this->Running.erase(id);
      this->Qualities[id] = {key, nullptr, message};
    };
    this->Running[id] = this->Jobs.Start(std::move(job));
  }
}

std::vector<QualityLine> StudyQuality::Lines(const StudyState& state) const
{
  std::vector<QualityLine> lines;
  for (const SceneStructure& structure : state.Structures)
  {
    if (!structure.IsTouchable || !HasPresets(structure))
    {
      continue;
    }
    QualityLine line = MakeQualityLine(structure, this->Of(state, structure));
    const auto running = this->Running.find(structure.Id);
    if (running != this->Running.end())
    {
      const auto progress = this->Jobs.ProgressOf(running->second);
      line.MeasuringFraction = progress ? progress->Fraction : 0.0;
    }
    const auto known = this->Qualities.find(structure.Id);
    line.Problem = known != this->Qualities.end() ? known->second.Problem : std::string();
    lines.push_back(std::move(line));
  }
  return lines;
}

StudyState StudyQuality::WithRecommended(const StudyState& state) const
{
  StudyState next = state;
  for (SceneStructure& structure : next.Structures)
  {
    const QualityMeasurement* measured =
        HasPresets(structure) ? this->Of(state, structure) : nullptr;
    const int preset = measured != nullptr ? RecommendedPreset(*measured, next.Rate) : -1;
    structure = preset >= 0 ? WithPreset(structure, preset) : structure;
  }
  return next;
}
} // namespace palpate
