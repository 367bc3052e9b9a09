#pragma once

#include "Command.h"
#include "PhantomSampler.h"
#include "RadialModel.h"
#include "Vector3.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace palpate::cli
{
/// `palpate phantom`: an MR-like volume, a mask and the true coefficients of a body, with the
/// ground truth available on any machine.
class PhantomCommand : public Command
{
public:
  std::string Name() const override { return "phantom"; }
  std::string Summary() const override
  {
    return "Make an MR volume and a mask of a body with known coefficients";
  }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  Matrix3 Direction() const;
  PhantomGrid GridAround(const RadialModel& model) const;
  PhantomAppearance Appearance(const RadialModel& model) const;
  RadialModel TrueModel() const;
  void WriteTruth(const RadialModel& model, const std::filesystem::path& file) const;
  /// Of the file of one of the images.
  std::string ImageName(const std::string& image) const { return image + "." + this->Format; }
  void PrintFiles(Console& console, const RadialModel& model, const PhantomImages& phantom) const;

  std::string OutputFolder;
  std::string ModelPath;
  std::string Format = "nii.gz";
  std::vector<double> Spacing; ///< mm; empty for the default
  std::vector<int> Size;       ///< voxels; empty for as many as the body needs
  std::vector<double> Nodule;  ///< diameter and depth, mm; empty for none
  double ObliqueDegrees = 0.0;
  double Noise = 10.0;
  double Bias = 0.15;
  int PartialVolume = 4;
  int Degree = 12;
  std::uint32_t Seed = 1;
};
} // namespace palpate::cli
