#include "MastoidPhantom.h"

#include "SeededNoise.h"
#include "Vector3.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace palpate
{
namespace
{
// mm
constexpr int Size = 64; // voxels
constexpr double Spacing = 0.6;
constexpr double DomeRadius = 34.0;
const Vector3 DomeCenter(28.0, 0.0, 0.0);
constexpr double Cortex = 2.0;
constexpr double NerveRadius = 1.2;
constexpr double NerveWall = 1.2;
constexpr double SinusRadius = 4.0;
constexpr double SinusWall = 0.8;
constexpr double CellStep = 4.2; // from one air cell to the next

// HU
constexpr double SoftTissue = 50.0;
constexpr double CortexValue = 1500.0;
constexpr double InsideValue = 900.0;
constexpr double AirValue = -850.0;
constexpr double Noise = 25.0; // standard deviation

double DepthInBone(const Vector3& place)
{
  return DomeRadius - (place - DomeCenter).norm();
}

// Distance from the surface of a tube that runs upwards, negative inside.
double FromNerve(const Vector3& place)
{
  const double x = 8.0 + 0.012 * place.z() * place.z();
  const double y = 2.0 + 1.5 * std::sin(place.z() / 9.0);
  return std::hypot(place.x() - x, place.y() - y) - NerveRadius;
}

double FromSinus(const Vector3& place)
{
  const double x = 6.0 - 0.1 * place.z();
  return std::hypot(place.x() - x, place.y() - 13.0) - SinusRadius;
}

// A number in 0..1 that looks random and depends on a cell alone.
double Scatter(int i, int j, int k, int which)
{
  std::uint64_t bits =
      static_cast<std::uint64_t>(i + 64) + 128U * static_cast<std::uint64_t>(j + 64) +
      16384U * static_cast<std::uint64_t>(k + 64) + 2097152U * static_cast<std::uint64_t>(which);
  for (const int shift : {30, 27, 31}) // a round of SplitMix64 for each
  {
    bits = (bits ^ (bits >> static_cast<unsigned>(shift))) * 0xbf58476d1ce4e5b9U;
  }
  return static_cast<double>(bits >> 11U) * 0x1p-53;
}

// Distance from the nearest air cell: spheres of different sizes on a disturbed grid.
double FromAir(const Vector3& place)
{
  const auto cellOf = [](double x) { return static_cast<int>(std::floor(x / CellStep)); };
  double least = CellStep;
  for (int i = cellOf(place.x()) - 1; i <= cellOf(place.x()) + 1; ++i)
  {
    for (int j = cellOf(place.y()) - 1; j <= cellOf(place.y()) + 1; ++j)
    {
      for (int k = cellOf(place.z()) - 1; k <= cellOf(place.z()) + 1; ++k)
      {
        const Vector3 center = CellStep * Vector3(i + Scatter(i, j, k, 0), j + Scatter(i, j, k, 1),
                                                  k + Scatter(i, j, k, 2));
        const double radius = 1.0 + 0.9 * Scatter(i, j, k, 3);
        least = std::min(least, (place - center).norm() - radius);
      }
    }
  }
  return least;
}

// From one value to another where a signed distance becomes positive, within two voxels: as smooth
// as a scanner's, so that the surface has no steps.
double Edge(double inside, double outside, double distance)
{
  return inside + (outside - inside) * std::clamp(0.5 + 0.5 * distance / Spacing, 0.0, 1.0);
}

double ValueAt(const Vector3& place)
{
  const double depth = DepthInBone(place);
  const double nerve = FromNerve(place);
  const double sinus = FromSinus(place);
  const double wall = std::min(nerve - NerveWall, sinus - SinusWall);
  const double air = std::max({FromAir(place), Cortex + 1.0 - depth, -wall});
  double value = Edge(InsideValue, CortexValue, Cortex - depth);
  value = Edge(AirValue, value, air);
  value = Edge(CortexValue, value, wall);
  value = Edge(SoftTissue, value, std::min(nerve, sinus));
  return Edge(value, SoftTissue, -depth);
}

vtkSmartPointer<vtkImageData> MakeImage(int type)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  constexpr double First = -0.5 * Spacing * (Size - 1);
  image->SetDimensions(Size, Size, Size);
  image->SetSpacing(Spacing, Spacing, Spacing);
  image->SetOrigin(First, First, First);
  image->AllocateScalars(type, 1);
  return image;
}
} // namespace

MastoidImages MakeMastoid(const ProgressFunction& progress)
{
  MastoidImages images{MakeImage(VTK_SHORT), MakeImage(VTK_UNSIGNED_CHAR)};
  auto* values = static_cast<short*>(images.Volume->GetScalarPointer());
  auto* labels = static_cast<unsigned char*>(images.Labels->GetScalarPointer());
  SeededNoise noise(1, 0);
  for (vtkIdType voxel = 0; voxel < images.Volume->GetNumberOfPoints(); ++voxel)
  {
    if (voxel % (Size * Size) == 0)
    {
      ReportProgress(progress, static_cast<double>(voxel) / (Size * Size * Size),
                     "making the mastoid");
    }
    const Vector3 place(images.Volume->GetPoint(voxel));
    values[voxel] = static_cast<short>(std::lround(ValueAt(place) + Noise * noise.Next()));
    const bool isInBone = DepthInBone(place) > 0.0;
    labels[voxel] = isInBone && FromNerve(place) < 0.0   ? 1
                    : isInBone && FromSinus(place) < 0.0 ? 2
                                                         : 0;
  }
  return images;
}
} // namespace palpate
