#include "PhantomSampler.h"

#include "RadialSpectrum.h"
#include "SeededNoise.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace palpate
{
namespace
{
// Random streams of the phantom's seed; each row has its own, starting at FirstRowStream.
constexpr std::uint64_t BiasStream = 0;
constexpr std::uint64_t FirstRowStream = 1;

// Nine smooth functions of voxel position scaled to [-1, 1]^3, each within [-1, 1].
std::array<double, 9> SmoothTerms(const Vector3& s)
{
  return {s.x(),         s.y(),         s.z(),         s.x() * s.x(), s.y() * s.y(),
          s.z() * s.z(), s.x() * s.y(), s.y() * s.z(), s.z() * s.x()};
}

vtkSmartPointer<vtkImageData> EmptyImage(const PhantomGrid& grid, int type, const char* name)
{
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> direction = grid.Direction;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(grid.Size.data());
  image->SetSpacing(grid.Spacing.data());
  image->SetOrigin(grid.OriginWorld.data());
  image->SetDirectionMatrix(direction.data());
  image->AllocateScalars(type, 1);
  image->GetPointData()->GetScalars()->SetName(name);
  return image;
}
} // namespace

PhantomSampler::PhantomSampler(const RadialModel& model, const PhantomGrid& grid,
                               const PhantomAppearance& appearance)
    : Model(model), Grid(grid), Appearance(appearance),
      StepWorld(grid.Direction * grid.Spacing.asDiagonal()), HalfDiagonal(0.5 * grid.Spacing.norm())
{
  this->LargestRadius = RadiusBound(model);
  this->SlopeBound = RadialSpectrum(model).Slope();
  SeededNoise noise(appearance.Seed, BiasStream);
  double sum = 0.0;
  for (double& term : this->BiasTerms)
  {
    term = noise.Next();
    sum += std::abs(term);
  }
  for (double& term : this->BiasTerms)
  {
    term *= appearance.BiasAmplitude / sum;
  }
}

double PhantomSampler::RadiusBound(const RadialModel& model)
{
  const RadialSpectrum spectrum(model);
  return spectrum.MeanRadius() + spectrum.Relief();
}

double PhantomSampler::BiasAt(const Vector3& index) const
{
  Vector3 scaled;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int last = this->Grid.Size[static_cast<std::size_t>(axis)] - 1;
    scaled[axis] = last > 0 ? 2.0 * index[axis] / last - 1.0 : 0.0;
  }
  const std::array<double, 9> terms = SmoothTerms(scaled);
  double bias = 1.0;
  for (std::size_t t = 0; t < terms.size(); ++t)
  {
    bias += this->BiasTerms[t] * terms[t];
  }
  return bias;
}

double PhantomSampler::TissueAt(const Vector3& offset, double distance, double radius) const
{
  if (this->Appearance.Nodule && this->Appearance.Nodule->Contains(offset))
  {
    return this->Appearance.NoduleIntensity;
  }
  if (distance > radius)
  {
    return this->Appearance.Background;
  }
  if (distance > radius - this->Appearance.CapsuleThickness)
  {
    return this->Appearance.Capsule;
  }
  return distance <= this->Appearance.InnerZoneFraction * radius ? this->Appearance.InnerZone
                                                                 : this->Appearance.Body;
}

double PhantomSampler::VariationWithin(double distance) const
{
  const double nearest = distance - this->HalfDiagonal;
  if (nearest <= 0.0)
  {
    return std::numeric_limits<double>::infinity();
  }
  return this->HalfDiagonal * std::hypot(1.0, this->SlopeBound / nearest);
}

bool PhantomSampler::IsCutByNodule(const Vector3& offset) const
{
  return this->Appearance.Nodule &&
         std::abs(this->Appearance.Nodule->SignedDistance(offset)) <= this->HalfDiagonal;
}

double PhantomSampler::SubdividedMean(const Vector3& offset) const
{
  const int parts = this->Appearance.Subdivision;
  const auto part = [parts](int p) { return (p + 0.5) / parts - 0.5; };
  double sum = 0.0;
  for (int c = 0; c < parts; ++c)
  {
    for (int b = 0; b < parts; ++b)
    {
      for (int a = 0; a < parts; ++a)
      {
        const Vector3 point = offset + this->StepWorld * Vector3(part(a), part(b), part(c));
        const double distance = point.norm();
        const Vector3 direction = distance > 0.0 ? Vector3(point / distance) : Vector3::UnitZ();
        sum += this->TissueAt(point, distance, this->Model.Radius(direction));
      }
    }
  }
  return sum / (static_cast<double>(parts) * parts * parts);
}

double PhantomSampler::VoxelMean(const Vector3& offset, double distance, double radius) const
{
  const double variation = this->VariationWithin(distance);
  // The boundary between inner zone and body lies at a fraction <= 1 of R, so the same bound holds.
  const bool isPure =
      std::abs(distance - radius) > variation &&
      std::abs(distance - radius + this->Appearance.CapsuleThickness) > variation &&
      std::abs(distance - this->Appearance.InnerZoneFraction * radius) > variation &&
      !this->IsCutByNodule(offset);
  return isPure ? this->TissueAt(offset, distance, radius) : this->SubdividedMean(offset);
}

void PhantomSampler::SampleRow(int j, int k, float* intensities, unsigned char* mask) const
{
  for (int i = 0; i < this->Grid.Size[0]; ++i)
  {
    const Vector3 index(i, j, k);
    const Vector3 offset = this->Grid.PointWorld(index) - this->Model.CenterWorld();
    const double distance = offset.norm();
    double mean = this->Appearance.Background;
    bool isInside = false;
    if (distance - this->HalfDiagonal <= this->LargestRadius)
    {
      const Vector3 direction = distance > 0.0 ? Vector3(offset / distance) : Vector3::UnitZ();
      const double radius = this->Model.Radius(direction);
      isInside = distance <= radius;
      mean = this->VoxelMean(offset, distance, radius);
    }
    mask[i] = isInside ? 1 : 0;
    intensities[i] = static_cast<float>(mean * this->BiasAt(index));
  }
  if (this->Appearance.NoiseDeviation > 0.0)
  {
    this->AddNoise(j, k, intensities);
  }
}

void PhantomSampler::SampleNoduleRow(int j, int k, unsigned char* mask) const
{
  for (int i = 0; i < this->Grid.Size[0]; ++i)
  {
    const Vector3 offset = this->Grid.PointWorld(Vector3(i, j, k)) - this->Model.CenterWorld();
    mask[i] = this->Appearance.Nodule && this->Appearance.Nodule->Contains(offset) ? 1 : 0;
  }
}

void PhantomSampler::AddNoise(int j, int k, float* intensities) const
{
  const auto row = static_cast<std::uint64_t>(k) * static_cast<std::uint64_t>(this->Grid.Size[1]) +
                   static_cast<std::uint64_t>(j);
  SeededNoise noise(this->Appearance.Seed, FirstRowStream + row);
  const double deviation = this->Appearance.NoiseDeviation;
  for (int i = 0; i < this->Grid.Size[0]; ++i)
  {
    const double real = intensities[i] + deviation * noise.Next();
    const bool isMagnitude = this->Appearance.NoiseKind == PhantomAppearance::Noise::Rician;
    intensities[i] =
        static_cast<float>(isMagnitude ? std::hypot(real, deviation * noise.Next()) : real);
  }
}

PhantomImages MakePhantom(const RadialModel& model, const PhantomGrid& grid,
                          const PhantomAppearance& appearance,
                          const std::function<void(double)>& progress)
{
  const PhantomSampler sampler(model, grid, appearance);
  PhantomImages images{EmptyImage(grid, VTK_FLOAT, "Intensity"),
                       EmptyImage(grid, VTK_UNSIGNED_CHAR, "Label"), nullptr};
  auto* intensities = static_cast<float*>(images.Volume->GetScalarPointer());
  auto* labels = static_cast<unsigned char*>(images.Mask->GetScalarPointer());
  unsigned char* nodule = nullptr;
  if (appearance.Nodule)
  {
    images.Nodule = EmptyImage(grid, VTK_UNSIGNED_CHAR, "Label");
    nodule = static_cast<unsigned char*>(images.Nodule->GetScalarPointer());
  }
  const vtkIdType rowLength = grid.Size[0];
  const vtkIdType rowsPerSlice = grid.Size[1];
  // Slice by slice, so that the calling thread can report progress.
  for (int k = 0; k < grid.Size[2]; ++k)
  {
    vtkSMPTools::For(0, rowsPerSlice,
                     [&](vtkIdType first, vtkIdType last)
                     {
                       for (vtkIdType j = first; j < last; ++j)
                       {
                         const vtkIdType start = (k * rowsPerSlice + j) * rowLength;
                         sampler.SampleRow(static_cast<int>(j), k, intensities + start,
                                           labels + start);
                         if (nodule)
                         {
                           sampler.SampleNoduleRow(static_cast<int>(j), k, nodule + start);
                         }
                       }
                     });
    progress((k + 1.0) / grid.Size[2]);
  }
  return images;
}
} // namespace palpate
