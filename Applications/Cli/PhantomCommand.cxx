#include "PhantomCommand.h"

#include "AvailableMemory.h"
#include "CommandProgress.h"
#include "Console.h"
#include "DecimalText.h"
#include "FileType.h"
#include "FiniteNumber.h"
#include "ImageWriter.h"
#include "InputError.h"
#include "Interruption.h"
#include "ModelFile.h"
#include "ModelMeasures.h"
#include "OutputFolder.h"
#include "ProgramVersion.h"
#include "Progress.h"
#include "ProstateLikeModel.h"

#include "ScreenText.h"

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numeric>
#include <ostream>

namespace palpate::cli
{
namespace
{
constexpr double MostVoxels = 100000.0;    // along an axis
constexpr double MarginMillimeters = 10.0; // between the body and the grid's sides
// An intensity and two labels, and a second copy of both during writing.
constexpr double BytesPerVoxel = 2.0 * (sizeof(float) + 2.0);
const char* const TruthName = "truth.json";

double MaskMilliliters(vtkImageData* mask)
{
  const auto* first = static_cast<const unsigned char*>(mask->GetScalarPointer());
  const double voxels = std::accumulate(first, first + mask->GetNumberOfPoints(), 0.0);
  const double* spacing = mask->GetSpacing();
  return voxels * spacing[0] * spacing[1] * spacing[2] / 1000.0;
}

// An empty mask would be of no use to what reads it.
void CheckNodule(vtkImageData* mask)
{
  if (mask && MaskMilliliters(mask) <= 0.0)
  {
    throw InputError("--nodule: the nodule lies between the voxels' centres or outside the grid; "
                     "give a larger diameter, a finer --spacing or a larger --size");
  }
}
} // namespace

std::string PhantomCommand::Examples() const
{
  return "  palpate phantom --output p                        0.5 x 0.5 x 3 mm voxels, some noise\n"
         "  palpate phantom --output p --spacing 1,1,1 --noise 0 --bias 0   clean and isotropic\n"
         "  palpate phantom --output p --oblique 20 --seed 7  a rotated grid, another body\n"
         "  palpate phantom --output p --model model.json     the body of a fitted model\n"
         "  palpate phantom --output p --nodule 8,2           with a nodule of 8 mm, 2 mm deep";
}

void PhantomCommand::DeclareOptions(CLI::App& app)
{
  app.add_option("--output", this->OutputFolder,
                 "Folder for volume, mask, truth.json and the nodule's mask")
      ->type_name("DIR")
      ->check(FileType::OutputFolder({TruthName}))
      ->required();
  app.add_option("--spacing", this->Spacing, "Voxel size x,y,z in mm (default: 0.5,0.5,3)")
      ->type_name("MM,MM,MM")
      ->delimiter(',')
      ->expected(3)
      ->check(FiniteNumber::Between(0.01, 100.0));
  app.add_option("--oblique", this->ObliqueDegrees,
                 "Rotate the grid by this angle about the left-right axis and by half of it about "
                 "the front-back axis")
      ->type_name("DEG")
      ->check(FiniteNumber::Between(-180.0, 180.0));
  app.add_option("--format", this->Format, "File format of the images")
      ->check(CLI::IsMember({"nii.gz", "nrrd", "mha"}))
      ->capture_default_str();
  app.add_option("--model", this->ModelPath,
                 "The body: a model file (default: a prostate-like body)")
      ->check(FileType::Input("file", ".json"));
  app.add_option("--degree", this->Degree, "Degree of the prostate-like body")
      ->check(CLI::Range(0, 64))
      ->capture_default_str();
  app.add_option("--seed", this->Seed,
                 "Random seed of the body's bumps, the noise and the bias field")
      ->capture_default_str();
  app.add_option("--size", this->Size, "Voxels x,y,z (default: as many as the body needs)")
      ->delimiter(',')
      ->expected(3)
      ->check(CLI::Range(1, static_cast<int>(MostVoxels)));
  app.add_option(
         "--nodule", this->Nodule,
         "A ball-shaped nodule of this diameter, with its top this deep under the posterior "
         "surface: dark in the volume, and a mask of its own")
      ->type_name("MM,DEPTH")
      ->delimiter(',')
      ->expected(2)
      ->check(FiniteNumber::Between(0.0, 1000.0));
  app.add_option("--noise", this->Noise,
                 "Standard deviation of the Rician noise; the body's intensity is 220")
      ->check(FiniteNumber::Between(0.0, 1e4))
      ->capture_default_str();
  app.add_option("--bias", this->Bias, "The bias field lies within 1 +- this")
      ->check(FiniteNumber::Between(0.0, 0.99))
      ->capture_default_str();
  app.add_option("--partial-volume", this->PartialVolume,
                 "Average a voxel over N points along each axis (1 for none)")
      ->type_name("N")
      ->check(CLI::Range(1, 16))
      ->capture_default_str();
}

Matrix3 PhantomCommand::Direction() const
{
  const double angle = this->ObliqueDegrees * M_PI / 180.0;
  return (Eigen::AngleAxisd(angle, Vector3::UnitX()) *
          Eigen::AngleAxisd(0.5 * angle, Vector3::UnitY()))
      .toRotationMatrix();
}

RadialModel PhantomCommand::TrueModel() const
{
  if (this->ModelPath.empty())
  {
    return MakeProstateLikeModel(this->Degree, this->Seed, Vector3::Zero());
  }
  const ModelDocument document = ReadModel(this->ModelPath);
  const auto* model = std::get_if<RadialModel>(&document.Surface);
  if (!model)
  {
    throw InputError(
        this->ModelPath +
        ": a phantom cannot be made from a surface model; give a radial model (.json)");
  }
  return *model;
}

PhantomGrid PhantomCommand::GridAround(const RadialModel& model) const
{
  PhantomGrid grid;
  grid.Direction = this->Direction();
  if (!this->Spacing.empty())
  {
    grid.Spacing = Vector3(this->Spacing.data());
  }
  double voxels = 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double wanted = 2.0 * (PhantomSampler::RadiusBound(model) + MarginMillimeters);
    const double needed =
        this->Size.empty()
            ? std::clamp(std::ceil(wanted / grid.Spacing[static_cast<Eigen::Index>(axis)]), 1.0,
                         MostVoxels)
            : static_cast<double>(this->Size[axis]);
    voxels *= needed;
    grid.Size[axis] = static_cast<int>(needed);
  }
  if (voxels * BytesPerVoxel > static_cast<double>(AvailableMemoryBytes()))
  {
    throw InputError(this->OutputFolder + ": a phantom of " + std::to_string(grid.Size[0]) + " x " +
                     std::to_string(grid.Size[1]) + " x " + std::to_string(grid.Size[2]) +
                     " voxels is larger than the free memory; give a coarser --spacing or a "
                     "smaller --size");
  }
  grid.CenterOn(model.CenterWorld());
  return grid;
}

PhantomAppearance PhantomCommand::Appearance(const RadialModel& model) const
{
  PhantomAppearance look;
  look.NoiseDeviation = this->Noise;
  look.BiasAmplitude = this->Bias;
  look.Subdivision = this->PartialVolume;
  look.Seed = this->Seed;
  if (!this->Nodule.empty())
  {
    look.Nodule.emplace();
    const Status placed =
        PhantomNodule::Place(model, this->Nodule[0], this->Nodule[1], *look.Nodule);
    if (!placed.IsOk())
    {
      throw InputError("--nodule: " + placed.Message());
    }
  }
  return look;
}

void PhantomCommand::WriteTruth(const RadialModel& model, const std::filesystem::path& file) const
{
  ModelProvenance provenance;
  provenance.Program = ProgramVersion();
  provenance.Input = this->ModelPath;
  if (this->ModelPath.empty())
  {
    provenance.Settings.emplace_back("seed", std::to_string(this->Seed));
  }
  if (!this->Nodule.empty())
  {
    provenance.Settings.emplace_back("nodule diameter", ExactText(this->Nodule[0]) + " mm");
    provenance.Settings.emplace_back("nodule depth", ExactText(this->Nodule[1]) + " mm");
  }
  WriteModel(file, {model, provenance});
}

void PhantomCommand::PrintFiles(Console& console, const RadialModel& model,
                                const PhantomImages& phantom) const
{
  const std::filesystem::path folder = this->OutputFolder;
  const auto name = [&folder](const std::string& file)
  { return Printable((folder / file).string()); };
  const int* size = phantom.Volume->GetDimensions();
  console.Output() << name(this->ImageName("volume")) << ": " << size[0] << " x " << size[1]
                   << " x " << size[2] << " voxels\n"
                   << std::fixed << std::setprecision(3) << name(this->ImageName("mask")) << ": "
                   << MaskMilliliters(phantom.Mask) << " ml\n"
                   << name(TruthName) << ": degree " << model.Degree() << ", "
                   << VolumeOf(model) / 1000.0 << " ml\n";
  if (phantom.Nodule)
  {
    console.Output() << name(this->ImageName("nodule")) << ": " << MaskMilliliters(phantom.Nodule)
                     << " ml\n";
  }
}

int PhantomCommand::Run(Console& console)
{
  const Interruption interruption;
  CheckOutputFolder(this->OutputFolder);
  const RadialModel model = this->TrueModel();
  const PhantomGrid grid = this->GridAround(model);
  const ProgressFunction progress = ProgressOn(console);
  const auto goOn = [&progress](double part)
  { ReportProgress(progress, part, "making the phantom"); };
  const PhantomImages phantom = MakePhantom(model, grid, this->Appearance(model), goOn);
  console.EndProgress();
  CheckNodule(phantom.Nodule);

  WriteOutputSet(this->OutputFolder,
                 [&](const std::filesystem::path& stage)
                 {
                   WriteImage(stage / this->ImageName("volume"), phantom.Volume);
                   WriteImage(stage / this->ImageName("mask"), phantom.Mask);
                   this->WriteTruth(model, stage / TruthName);
                   if (phantom.Nodule)
                   {
                     WriteImage(stage / this->ImageName("nodule"), phantom.Nodule);
                   }
                 },
                 {this->ImageName("nodule")}); // of an earlier phantom
  this->PrintFiles(console, model, phantom);
  return 0;
}
} // namespace palpate::cli
