#pragma once

#include "Command.h"
#include "ImageOptions.h"
#include "MaskChecks.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::cli
{
/// `palpate check INPUT...`: whether masks can be believed. It also makes the groups that it
/// compares with, since it measures cases of all structures, while `cohort` has models of one.
class CheckCommand : public Command
{
public:
  std::string Name() const override { return "check"; }
  std::string Summary() const override
  {
    return "Check masks for holes, leaks, cuts, missing slices, swapped names and odd shapes";
  }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  int MakeGroup(const MaskChecks& measured, Console& console) const;
  /// Null, with a note, if the group cannot hold the rate of false alarms.
  const CheckGroup* UsableGroup(const CheckGroup& group, Console& console) const;

  std::vector<std::filesystem::path> Inputs;
  ImageOptions Images;
  CheckSettings Settings;
  std::filesystem::path GroupFile;
  std::filesystem::path GroupToMake;
  double Percent = 5.0;
  bool ShowsNames = false;
  std::filesystem::path Output;
  int Jobs = 0;
  bool IsStrict = false;
  bool Json = false;
};
} // namespace palpate::cli
