#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace palpate
{
/// Adds the durations of successive stages to a list, in seconds: one entry for all that have the
/// same name.
class StageClock
{
public:
  explicit StageClock(std::vector<std::pair<std::string, double>>& stages)
      : Stages(stages), Start(std::chrono::steady_clock::now())
  {
  }

  /// Ends `stage`, which began at the last call (or the construction).
  void EndStage(const std::string& stage)
  {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - this->Start).count();
    this->Start = now;
    for (auto& earlier : this->Stages)
    {
      if (earlier.first == stage)
      {
        earlier.second += seconds;
        return;
      }
    }
    this->Stages.emplace_back(stage, seconds);
  }

private:
  std::vector<std::pair<std::string, double>>& Stages;
  std::chrono::steady_clock::time_point Start;
};
} // namespace palpate
