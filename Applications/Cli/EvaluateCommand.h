#pragma once

#include "Command.h"
#include "Vector3.h"

#include <vector>

namespace palpate::cli
{
/// `palpate evaluate MODEL`: a model's volume, area and power spectrum; its radius, gradient, point
/// and normal along directions; whether points are inside.
class EvaluateCommand : public Command
{
public:
  std::string Name() const override { return "evaluate"; }
  std::string Summary() const override
  {
    return "Radius, normals, volume, area and spectrum of a model";
  }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  std::vector<Vector3> UnitDirections() const;

  std::string Model;
  std::vector<std::string> DirectionWords;
  int Frequency = 0;
  std::vector<std::string> PointWords;
  bool Json = false;
};
} // namespace palpate::cli
