#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace palpate
{
/// Appends the durations of successive stages to a list, in seconds.
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
    this->Stages.emplace_back(stage, std::chrono::duration<double>(now - this->Start).count());
    this->Start = now;
  }

private:
  std::vector<std::pair<std::string, double>>& Stages;
  std::chrono::steady_clock::time_point Start;
};
} // namespace palpate
