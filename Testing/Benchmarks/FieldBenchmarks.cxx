#include "FieldBenchmarks.h"

#include "FieldSampler.h"
#include "ItkInterpolators.h"
#include "RandomShapes.h"
#include "RayCaster.h"
#include "SkullPhantom.h"

#include "vtkImageBSplineCoefficients.h"
#include "vtkImageBSplineInterpolator.h"
#include "vtkImageData.h"
#include "vtkImageInterpolator.h"
#include "vtkImplicitVolume.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

namespace palpate::bench
{
namespace
{
constexpr int SkullNodes = 160;
constexpr int Points = 26 * 770;
constexpr int ImageSide = 96;
constexpr int TouchRays = 4000;
constexpr double TouchReach = 10.0; // mm

void MakeSkullImage(const SkullPhantom& skull, vtkImageData* image)
{
  image->SetDimensions(skull.Grid.Size().data());
  image->SetSpacing(skull.Grid.Spacing().data());
  image->SetOrigin(skull.Grid.OriginWorld().data());
  image->AllocateScalars(VTK_SHORT, 1);
  std::copy(skull.Samples.begin(), skull.Samples.end(),
            static_cast<short*>(image->GetScalarPointer()));
}

// Queries of a servo: the points of a sphere that slides over the bone, tick by tick.
std::vector<Vector3> PointsOfATool(const SkullPhantom& skull)
{
  constexpr double Radius = 2.0; // mm
  test::Random random(31);
  const std::vector<Vector3> sphere = test::RandomDirections(random, 26);
  std::vector<Vector3> points;
  for (int tick = 0; points.size() < Points; ++tick)
  {
    const double turn = 1e-3 * tick; // about 0.06 mm
    const Vector3 u(std::cos(turn), 0.8 * std::sin(turn), 0.5);
    for (const Vector3& offset : sphere)
    {
      points.push_back(skull.PointInBoneWorld(u) + 2.0 * u + Radius * offset);
    }
  }
  return points;
}

// A camera in front of the face, one ray per pixel.
std::vector<FieldRay> ImageRays(const SkullPhantom& skull)
{
  const Vector3 half = skull.HalfAxes();
  const Vector3 eye = skull.CenterWorld - Vector3(0.0, 3.0 * half[1], 0.0);
  std::vector<FieldRay> rays;
  for (int y = 0; y < ImageSide; ++y)
  {
    for (int x = 0; x < ImageSide; ++x)
    {
      const double right = 2.2 * (x + 0.5) / ImageSide - 1.1;
      const double up = 2.2 * (y + 0.5) / ImageSide - 1.1;
      const Vector3 aim = skull.CenterWorld + Vector3(right * half[0], 0.0, up * half[2]);
      rays.push_back({eye, (aim - eye).normalized()});
    }
  }
  return rays;
}

// From a few millimetres off the bone towards it, in all directions.
std::vector<FieldRay> RaysOfATool(const SkullPhantom& skull)
{
  test::Random random(32);
  std::vector<FieldRay> rays;
  while (rays.size() < TouchRays)
  {
    const Vector3 u = test::RandomDirection(random);
    const Vector3 v = test::RandomDirection(random);
    rays.push_back({skull.PointInBoneWorld(u) + 6.0 * u, (0.5 * v - u).normalized()});
  }
  return rays;
}

// First hits by VTK's means: steps of half a voxel, and bisection once the sign has changed.
class SteppingCaster
{
public:
  SteppingCaster(vtkAbstractImageInterpolator* interpolator, const FieldGrid& grid)
      : Interpolator(interpolator), First(grid.OriginWorld()),
        Last(grid.PointWorld(Vector3(grid.Size()[0] - 1, grid.Size()[1] - 1, grid.Size()[2] - 1))),
        Step(0.5 * grid.Spacing().minCoeff())
  {
  }

  double FirstHit(const FieldRay& ray, double tMax) const
  {
    const Eigen::Array3d a = (this->First - ray.Origin).array() / ray.Direction.array();
    const Eigen::Array3d b = (this->Last - ray.Origin).array() / ray.Direction.array();
    double t = std::max(a.min(b).maxCoeff(), 0.0);
    const double end = std::min(a.max(b).minCoeff(), tMax);
    const bool startsInside = t < end && this->IsInside(ray, t);
    while (t < end)
    {
      const double next = std::min(t + this->Step, end);
      if (this->IsInside(ray, next) != startsInside)
      {
        return this->Bisect(ray, t, next, startsInside);
      }
      t = next;
    }
    return INFINITY;
  }

private:
  bool IsInside(const FieldRay& ray, double t) const
  {
    const Vector3 p = ray.Origin + t * ray.Direction;
    double value = 0.0;
    this->Interpolator->Interpolate(p.data(), &value);
    return value >= SkullPhantom::BoneIso;
  }
  double Bisect(const FieldRay& ray, double low, double high, bool isInsideLow) const
  {
    constexpr int Halvings = 20;
    for (int n = 0; n < Halvings; ++n)
    {
      const double middle = 0.5 * (low + high);
      (this->IsInside(ray, middle) == isInsideLow ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  vtkAbstractImageInterpolator* Interpolator;
  Vector3 First;
  Vector3 Last;
  double Step;
};

class FieldCase
{
public:
  FieldCase()
      : Skull(SkullNodes), Itk(MakeItkInterpolators(Skull.Grid, Skull.Samples)),
        PointsWorld(PointsOfATool(Skull)), Ours(PointsWorld.size()), Theirs(PointsWorld.size())
  {
    MakeSkullImage(this->Skull, this->Image);
    this->Implicit->SetVolume(this->Image);
    this->Linear->SetInterpolationModeToLinear();
    this->Linear->Initialize(this->Image);
    this->Coefficients->SetInputData(this->Image);
    this->Coefficients->Update();
    this->Cubic->Initialize(this->Coefficients->GetOutput());
  }

  void AreInside(FieldInterpolation interpolation)
  {
    const FieldSampler& sampler = this->SamplerOf(interpolation);
    sampler.AreInsideWorld(0, this->PointsWorld.data(), this->PointsWorld.size(),
                           this->Ours.data());
  }
  void AreInsideByVtk()
  {
    for (std::size_t p = 0; p < this->PointsWorld.size(); ++p)
    {
      const double value = this->Implicit->EvaluateFunction(this->PointsWorld[p].data());
      this->Theirs[p] = value >= SkullPhantom::BoneIso ? 1 : 0;
    }
  }
  void AreInsideByItk(FieldInterpolation interpolation)
  {
    interpolation == FieldInterpolation::Trilinear
        ? this->Itk->AreInsideLinear(SkullPhantom::BoneIso, this->PointsWorld, this->Theirs)
        : this->Itk->AreInsideBSpline(SkullPhantom::BoneIso, this->PointsWorld, this->Theirs);
  }
  // Points whose value equals the iso-value up to rounding may differ; the cubic's is kept in
  // float.
  std::string InsideDisagreement() const
  {
    const auto size = static_cast<int>(this->Ours.size());
    int different = 0;
    for (int p = 0; p < size; ++p)
    {
      const auto at = static_cast<std::size_t>(p);
      different += this->Ours[at] != this->Theirs[at] ? 1 : 0;
    }
    const auto inside = std::count(this->Ours.begin(), this->Ours.end(), 1);
    const bool isRight = different <= 1 && inside > size / 10 && inside < size - size / 10;
    return isRight ? std::string() : std::to_string(different) + " points differ";
  }

  void Cast(FieldInterpolation interpolation, const std::vector<FieldRay>& rays, double tMax)
  {
    const RayCaster& caster = this->CasterOf(interpolation);
    this->OurHits.resize(rays.size());
    this->Intervals.assign(rays.size(), {0.0, tMax});
    caster.CastAllWorld(rays.data(), this->Intervals.data(), rays.size(), this->OurHits.data());
  }
  void Step(FieldInterpolation interpolation, const std::vector<FieldRay>& rays, double tMax)
  {
    vtkAbstractImageInterpolator* interpolator = this->Linear;
    if (interpolation == FieldInterpolation::TricubicBSpline)
    {
      interpolator = this->Cubic;
    }
    const SteppingCaster caster(interpolator, this->Skull.Grid);
    this->TheirHits.resize(rays.size());
    std::transform(rays.begin(), rays.end(), this->TheirHits.begin(),
                   [&caster, tMax](const FieldRay& ray) { return caster.FirstHit(ray, tMax); });
  }
  // Steps may miss parts thinner than they are, where rays graze.
  std::string HitDisagreement() const
  {
    constexpr double Tolerance = 1e-3; // mm: VTK rounds positions to 2^-17 voxels
    std::size_t different = 0;
    for (std::size_t r = 0; r < this->OurHits.size(); ++r)
    {
      const FieldHit& hit = this->OurHits[r];
      const double t = hit.Kind == HitKind::Missed ? INFINITY : hit.T;
      const bool same = t == this->TheirHits[r] || std::abs(t - this->TheirHits[r]) <= Tolerance;
      different += same ? 0 : 1;
    }
    const bool isRight = 200 * different <= this->OurHits.size();
    return isRight ? std::string() : std::to_string(different) + " rays differ";
  }

  const SkullPhantom& Phantom() const { return this->Skull; }

private:
  const FieldSampler& SamplerOf(FieldInterpolation interpolation) const
  {
    return interpolation == FieldInterpolation::Trilinear ? this->LinearSampler
                                                          : this->CubicSampler;
  }
  const RayCaster& CasterOf(FieldInterpolation interpolation) const
  {
    return interpolation == FieldInterpolation::Trilinear ? this->LinearCaster : this->CubicCaster;
  }

  SkullPhantom Skull;
  std::unique_ptr<ItkInterpolators> Itk;
  std::vector<Vector3> PointsWorld;
  FieldSampler LinearSampler{Skull.MakeField(FieldInterpolation::Trilinear)};
  FieldSampler CubicSampler{Skull.MakeField(FieldInterpolation::TricubicBSpline)};
  RayCaster LinearCaster{Skull.MakeField(FieldInterpolation::Trilinear)};
  RayCaster CubicCaster{Skull.MakeField(FieldInterpolation::TricubicBSpline)};
  std::vector<unsigned char> Ours;
  std::vector<unsigned char> Theirs;
  std::vector<RayInterval> Intervals;
  std::vector<FieldHit> OurHits;
  std::vector<double> TheirHits;
  vtkNew<vtkImageData> Image;
  vtkNew<vtkImplicitVolume> Implicit;
  vtkNew<vtkImageInterpolator> Linear;
  vtkNew<vtkImageBSplineCoefficients> Coefficients;
  vtkNew<vtkImageBSplineInterpolator> Cubic;
};

PairedBenchmark FirstHits(const std::shared_ptr<FieldCase>& theCase, const std::string& name,
                          const std::string& against, FieldInterpolation interpolation,
                          const std::vector<FieldRay>& rays, double tMax)
{
  return {name,
          against,
          [theCase, interpolation, rays, tMax] { theCase->Cast(interpolation, rays, tMax); },
          [theCase, interpolation, rays, tMax] { theCase->Step(interpolation, rays, tMax); },
          [theCase] { return theCase->HitDisagreement(); },
          static_cast<double>(rays.size())};
}
} // namespace

std::vector<PairedBenchmark> FieldBenchmarks()
{
  constexpr auto Linear = FieldInterpolation::Trilinear;
  constexpr auto Cubic = FieldInterpolation::TricubicBSpline;
  const auto theCase = std::make_shared<FieldCase>();
  const auto raster = ImageRays(theCase->Phantom());
  const auto tool = RaysOfATool(theCase->Phantom());
  const auto agree = [theCase] { return theCase->InsideDisagreement(); };
  const auto inside = [theCase](FieldInterpolation interpolation)
  { return [theCase, interpolation] { theCase->AreInside(interpolation); }; };
  return {{"field/inside", "vtkImplicitVolume", inside(Linear),
           [theCase] { theCase->AreInsideByVtk(); }, agree, Points},
          {"field/inside/itk", "itk::LinearInterpolateImageFunction", inside(Linear),
           [theCase] { theCase->AreInsideByItk(Linear); }, agree, Points},
          {"field/inside/tricubic", "itk::BSplineInterpolateImageFunction", inside(Cubic),
           [theCase] { theCase->AreInsideByItk(Cubic); }, agree, Points},
          FirstHits(theCase, "field/firsthit", "vtkImageInterpolator, half steps", Linear, raster,
                    INFINITY),
          FirstHits(theCase, "field/firsthit/tool", "vtkImageInterpolator, half steps", Linear,
                    tool, TouchReach),
          FirstHits(theCase, "field/firsthit/tricubic", "vtkImageBSplineInterpolator, half steps",
                    Cubic, raster, INFINITY),
          FirstHits(theCase, "field/firsthit/tricubic/tool",
                    "vtkImageBSplineInterpolator, half steps", Cubic, tool, TouchReach)};
}
} // namespace palpate::bench
