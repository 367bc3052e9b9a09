#pragma once

#include "Command.h"
#include "TradeRun.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::cli
{
/// `palpate tradeoff SCENE|FILE`: measures the speed and accuracy of each setting on this machine,
/// and recommends one.
class TradeoffCommand : public Command
{
public:
  std::string Name() const override { return "tradeoff"; }
  std::string Summary() const override
  {
    return "Measure speed and accuracy of each setting on this machine, and recommend one";
  }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  TradeRunSettings Settings() const;
  SceneSettings Scene() const;
  void Write(const TradeResult& result, Console& console) const;

  std::string Input;
  std::vector<std::string> Labels;
  std::vector<double> Iso; ///< one, or none
  double ToolRadius = 2.0; ///< mm
  std::vector<std::string> Structures;
  std::uint64_t Seed = 1;
  double Seconds = 10.0;
  int Runs = 5;
  std::filesystem::path OutputFolder;
  bool Json = false;
};
} // namespace palpate::cli
