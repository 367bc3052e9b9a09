#pragma once

#include "Command.h"
#include "ImageOptions.h"
#include "OrganRelations.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::cli
{
/// `palpate relate FILE...`: distances, contacts and shapes of the organs of one patient.
class RelateCommand : public Command
{
public:
  std::string Name() const override { return "relate"; }
  std::string Summary() const override
  {
    return "Measure organs and how they lie to each other: distances, contact, margins, thickness";
  }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  std::vector<std::filesystem::path> Inputs;
  ImageOptions Images;
  OrganRelationSettings Settings;
  std::string Definition = "subvoxel";
  std::string Thickness = "spheres";
  std::filesystem::path Output;
  int Jobs = 0;
  bool Json = false;
};
} // namespace palpate::cli
