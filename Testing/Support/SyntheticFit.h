#pragma once

#include "FitResult.h"
#include "ModelMeasures.h"
#include "ModelMesh.h"
#include "PhantomSampler.h"
#include "ProstateLikeModel.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <cmath>

namespace palpate::test
{
/// A fit with everything that a report shows, made without the pipeline: the mask and the MR-like
/// volume of a prostate-like phantom on an anisotropic grid rotated about z by 20 degrees, its true
/// surface, and its lowest degrees as the model.
struct SyntheticFit
{
  explicit SyntheticFit(int modelDegree = 5)
  {
    const double c = std::cos(M_PI / 9.0);
    const double s = std::sin(M_PI / 9.0);
    PhantomGrid grid;
    grid.Direction << c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0;
    grid.Size = {96, 96, 20};
    grid.Spacing = {0.8, 0.8, 3.0};
    grid.CenterOn(Center);
    PhantomAppearance look;
    look.NoiseDeviation = 8.0;
    look.Subdivision = 1;
    this->Truth = MakeProstateLikeModel(12, 1, Center);
    const PhantomImages phantom = MakePhantom(this->Truth, grid, look);

    this->Mri.Image = phantom.Volume;
    this->Mri.Source = "/home/someone/secret-folder/t2.nii.gz";
    FitResult& fit = this->Result;
    fit.Input = "/home/someone/secret-folder/case_17.nii.gz";
    fit.CaseName = "case_17";
    fit.Structure.Label = 1;
    fit.Structure.Value = 1;
    fit.Structure.Name = "Prostate";
    fit.State = FitResult::Outcome::Fitted;
    fit.Mask = phantom.Mask;
    fit.Surface = MakeModelMesh(this->Truth, 30);
    fit.Model = this->Truth.WithDegree(modelDegree);
    fit.ModelSurface = MakeModelMesh(*fit.Radial(), 20);
    this->AddDistances();
    this->AddNumbers();
  }

  static inline const Vector3 Center{10.0, -20.0, 55.0};
  FitResult Result;
  Volume Mri;
  RadialModel Truth;

private:
  // Differences along the radius: close enough to distances for an image.
  void AddDistances()
  {
    vtkNew<vtkDoubleArray> distances;
    distances->SetName("DistanceToSurface");
    const IcosahedronDirections directions(20);
    for (const Vector3& u : directions.Directions())
    {
      distances->InsertNextValue(this->Result.Radial()->Radius(u) - this->Truth.Radius(u));
    }
    this->Result.ModelSurface->GetPointData()->AddArray(distances);
  }

  void AddNumbers()
  {
    FitResult& fit = this->Result;
    fit.MaskMilliliters = 43.217;
    fit.Coverage.Outcome = DirectionCoverage::Verdict::Good;
    fit.ComponentMilliliters = {43.217, 0.031};
    fit.SurfaceMilliliters = 43.301;
    fit.SurfaceToMask = {0.111, 0.144, 0.317, 0.871};
    fit.IsSampled = true;
    fit.StarShaped = true;
    fit.HiddenPercent = 0.37;
    fit.Condition = 1.733;
    fit.Rms = 0.219;
    fit.DegreesOfFreedom = 36.0;
    fit.ModelToSurface = {0.171, 0.222, 0.467, 0.933};
    fit.ModelToMask = {0.281, 0.352, 0.713, 1.577};
    fit.Dice = 0.9873;
    fit.ModelMilliliters = VolumeOf(*fit.Radial()) / 1000.0;
    fit.SurfaceAreaSquareMillimeters = 6021.5;
    fit.ModelAreaSquareMillimeters = 5987.25;
    for (int l = 0; l <= DegreeOf(fit.Model); ++l)
    {
      fit.RmsByDegree.push_back(3.0 * std::pow(0.6, l));
    }
    fit.Seconds = {{"surface", 0.101}, {"fit", 0.037}, {"total", 0.138}};
    fit.Notes = {"The mask has a second component of 0.031 ml that was left out."};
  }
};
} // namespace palpate::test
