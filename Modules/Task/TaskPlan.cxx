#include "TaskPlan.h"

#include <cstdint>
#include <random>
#include <utility>

namespace palpate
{
namespace
{
// Of targets, endlessly: each once before any again.
class ShuffledTargets
{
public:
  ShuffledTargets(std::vector<std::size_t> targets, std::mt19937_64& random)
      : Targets(std::move(targets)), Random(random), Next(Targets.size())
  {
  }

  std::size_t Draw()
  {
    if (this->Next == this->Targets.size())
    {
      // std::shuffle differs between standard libraries.
      for (std::size_t left = this->Targets.size(); left > 1; --left)
      {
        std::swap(this->Targets[left - 1], this->Targets[this->Random() % left]);
      }
      this->Next = 0;
    }
    return this->Targets[this->Next++];
  }

private:
  std::vector<std::size_t> Targets;
  std::mt19937_64& Random;
  std::size_t Next;
};

// Those for training; all if there are none.
std::vector<std::size_t> TargetsFor(const TaskSettings& task, bool isTraining)
{
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < task.Targets.size(); ++i)
  {
    if (task.Targets[i].IsTraining == isTraining)
    {
      found.push_back(i);
    }
  }
  return found.empty() ? TargetsFor(task, !isTraining) : found;
}
} // namespace

std::vector<std::vector<int>> WilliamsRows(int count)
{
  // 0, 1, n - 1, 2, n - 2, ...: successive differences are all different.
  std::vector<int> first;
  for (int i = 0; i < count; ++i)
  {
    first.push_back(i % 2 == 1 ? (i + 1) / 2 : (count - i / 2) % count);
  }
  std::vector<std::vector<int>> rows;
  for (int shift = 0; shift < count; ++shift)
  {
    rows.push_back(first);
    for (int& condition : rows.back())
    {
      condition = (condition + shift) % count;
    }
  }
  for (int row = 0; count % 2 == 1 && count > 1 && row < count; ++row)
  {
    const std::vector<int>& square = rows[static_cast<std::size_t>(row)];
    std::vector<int> reversed(square.rbegin(), square.rend());
    rows.push_back(std::move(reversed));
  }
  return rows;
}

std::vector<TaskTrial> PlanOf(const TaskSettings& task, int participant)
{
  std::seed_seq seed{static_cast<std::uint32_t>(task.Seed),
                     static_cast<std::uint32_t>(participant)};
  std::mt19937_64 random(seed);
  ShuffledTargets training(TargetsFor(task, true), random);
  ShuffledTargets measured(TargetsFor(task, false), random);
  const auto rows = WilliamsRows(static_cast<int>(task.Conditions.size()));
  std::vector<TaskTrial> trials;
  for (const int condition : rows[static_cast<std::size_t>(participant - 1) % rows.size()])
  {
    for (int i = 0; i < task.TrainingTrials + task.Trials; ++i)
    {
      TaskTrial trial;
      trial.Number = static_cast<int>(trials.size()) + 1;
      trial.IsTraining = i < task.TrainingTrials;
      trial.Condition = static_cast<std::size_t>(condition);
      trial.Target = trial.IsTraining ? training.Draw() : measured.Draw();
      trial.EndsBlock = task.PauseAfter > 0 && trial.Number % task.PauseAfter == 0;
      trials.push_back(trial);
    }
  }
  trials.back().EndsBlock = false;
  return trials;
}
} // namespace palpate
