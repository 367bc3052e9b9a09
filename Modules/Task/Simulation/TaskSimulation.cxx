#include "TaskSimulation.h"

#include "HandSkill.h"
#include "InputError.h"
#include "SceneFile.h"
#include "SimulatedParticipant.h"
#include "TaskHand.h"
#include "TaskRun.h"
#include "TouchRun.h"

#include <array>
#include <map>
#include <random>
#include <utility>

namespace palpate
{
namespace
{
std::uint64_t SeedOf(std::uint64_t seed, int participant, int trial)
{
  std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U),
                         static_cast<std::uint32_t>(participant),
                         static_cast<std::uint32_t>(trial)};
  std::array<std::uint32_t, 2> words{};
  sequence.generate(words.begin(), words.end());
  return (std::uint64_t{words[0]} << 32U) | words[1];
}

// Each scene is made once for all participants, in each condition that changes it.
class TaskScenes
{
public:
  const PreparedTouch& Of(const TaskTarget& target, const TaskCondition& condition,
                          const ProgressFunction& progress)
  {
    const auto key = std::make_pair(target.Scene, condition.Patch);
    auto found = this->Made.find(key);
    if (found == this->Made.end())
    {
      SceneSettings settings = ReadScene(target.Scene, condition.Patch);
      settings.Device = "simulated";
      // A task's hands make their own way.
      TouchScript script;
      script.Path = HandPath({{0.0, Vector3::Zero()}});
      found = this->Made.emplace(key, PrepareTouch(settings, script, progress)).first;
    }
    return found->second;
  }

private:
  std::map<std::pair<std::filesystem::path, std::filesystem::path>, PreparedTouch> Made;
};

void SimulateTrial(const TaskSettings& task, const TaskSimulation& simulation, int participant,
                   TaskRun& run, const PreparedTouch& touch)
{
  const TaskTarget& target = task.Targets[run.Trial()->Target];
  std::mt19937_64 person(SeedOf(simulation.Seed, participant, 0));
  const HandSkill skill = HandSkill::OfLevel(simulation.Level).OnePerson(person);
  const std::uint64_t seed = SeedOf(simulation.Seed, participant, run.Trial()->Number);
  run.Start();
  TaskHand hand(touch, task, task.Conditions[run.Trial()->Condition].HasForce, skill,
                target.Side.normalized(), seed);
  const TaskAnswer answer =
      SimulatedParticipant(hand, skill, seed, touch.Settings).Do(task.Kind, target);
  run.End(answer, hand.Watched().Measured());
}
} // namespace

void SimulateTask(const TaskSettings& task, const TaskSimulation& simulation,
                  const std::filesystem::path& folder, const ProgressFunction& progress)
{
  TaskScenes scenes;
  for (int number = 1; number <= simulation.Participants; ++number)
  {
    TaskParticipant participant{number, {}, simulation.Level, simulation.Seed};
    TaskRun run(task, participant, folder);
    while (run.State() != TaskState::Finished)
    {
      if (run.State() == TaskState::Paused)
      {
        run.Resume();
      }
      const double before = number - 1.0;
      const double done =
          (before + (run.Trial()->Number - 1.0) / static_cast<double>(run.Plan().size())) /
          simulation.Participants;
      ReportProgress(progress, done, "participant " + std::to_string(number));
      const PreparedTouch& touch = scenes.Of(task.Targets[run.Trial()->Target],
                                             task.Conditions[run.Trial()->Condition], progress);
      SimulateTrial(task, simulation, number, run, touch);
    }
  }
}
} // namespace palpate
