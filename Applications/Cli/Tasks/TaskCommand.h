#pragma once

#include "Command.h"
#include "TaskPower.h"
#include "TaskSettings.h"
#include "TaskSimulation.h"

#include <filesystem>
#include <string>

namespace palpate::cli
{
/// `palpate task`: tasks that measure what touch is worth: makes, checks, plans and simulates them,
/// and evaluates what people or simulated hands did.
class TaskCommand : public Command
{
public:
  std::string Name() const override { return "task"; }
  std::string Summary() const override
  {
    return "Make, check, plan, simulate and evaluate tasks that people do by touch";
  }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  int Init(Console& console) const;
  int Check(Console& console) const;
  int Plan(Console& console) const;
  int Simulate(Console& console) const;
  int Evaluate(const std::filesystem::path& folder, Console& console) const;

  std::string Action;
  std::string Input;
  std::filesystem::path Output;
  TaskSimulation Simulation;
  int Studies = 2000;
  bool Json = false;
};
} // namespace palpate::cli
