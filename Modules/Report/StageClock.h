#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace palpate
{
/// Writes the seconds of successive stages into a list.
class StageClock
{
public:
  explicit StageClock(std::vector<std::pair<std::string, double>>& stages)
      : Stages(stages), Start(std::chrono::steady_clock::now())
  {
  }

  /// Everything since the last call (or the construction) was `stage`.
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
