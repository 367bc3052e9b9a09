#include "TissueMap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace palpate
{
namespace
{
bool IsModulus(double modulus) noexcept
{
  return modulus >= TissueMap::LeastModulus && modulus <= TissueMap::MostModulus;
}

// Trilinear, of what each value stands for; 0 outside of the grid.
template <typename Meaning>
double Interpolate(const TissueMap::Samples& image, const Vector3& pointWorld,
                   const Meaning& meaning) noexcept
{
  const Vector3 index = image.Grid.PointIndex(pointWorld);
  const std::array<int, 3>& size = image.Grid.Size();
  std::array<std::size_t, 3> cell{};
  std::array<double, 3> part{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double last = size[axis] - 1.0;
    const double at = index[static_cast<Eigen::Index>(axis)];
    if (!(at >= 0.0 && at <= last))
    {
      return 0.0;
    }
    cell[axis] = static_cast<std::size_t>(std::min(std::floor(at), last - 1.0));
    part[axis] = at - static_cast<double>(cell[axis]);
  }
  const auto across = static_cast<std::size_t>(size[0]);
  const auto slice = across * static_cast<std::size_t>(size[1]);
  double value = 0.0;
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const std::size_t i = corner & 1U;
    const std::size_t j = (corner >> 1U) & 1U;
    const std::size_t k = corner >> 2U;
    const double weight = (i != 0 ? part[0] : 1.0 - part[0]) * (j != 0 ? part[1] : 1.0 - part[1]) *
                          (k != 0 ? part[2] : 1.0 - part[2]);
    value +=
        weight * meaning(static_cast<double>(
                     image.Values[cell[0] + i + across * (cell[1] + j) + slice * (cell[2] + k)]));
  }
  return value;
}
} // namespace

double TissueMap::Samples::At(const Vector3& pointWorld) const noexcept
{
  return Interpolate(*this, pointWorld, [](double value) { return value; });
}

void TissueMap::AddInclusion(std::shared_ptr<const Samples> fraction, double modulus)
{
  this->Layers.push_back({std::move(fraction), true, modulus});
}

void TissueMap::AddImage(std::shared_ptr<const Samples> moduli)
{
  this->Layers.push_back({std::move(moduli), false, this->Tissue});
}

Status TissueMap::Check() const
{
  const bool areModuli = IsModulus(this->Tissue) &&
                         std::all_of(this->Layers.begin(), this->Layers.end(),
                                     [](const Layer& layer) { return IsModulus(layer.Modulus); });
  if (!areModuli)
  {
    return Status::Failure("A modulus is not a number from 0.001 kPa to 1 GPa.");
  }
  if (!(this->Power >= 1.0 && this->Power <= MostExaggeration))
  {
    return Status::Failure("The exaggeration of contrasts is not a power from 1 to 5.");
  }
  for (const Layer& layer : this->Layers)
  {
    Status grid = layer.Image->Grid.Check();
    if (!grid.IsOk())
    {
      return grid;
    }
    if (layer.Image->Values.size() != layer.Image->Grid.NodeCount())
    {
      return Status::Failure("An image of the tissue has another size than its grid.");
    }
  }
  return Status::Success();
}

double TissueMap::Modulus(const Vector3& pointWorld) const noexcept
{
  double modulus = this->Tissue;
  for (const Layer& layer : this->Layers)
  {
    // A voxel without a value changes nothing.
    const auto change = [&layer, below = modulus](double value)
    {
      if (!layer.IsFraction)
      {
        return IsModulus(value) ? value - below : 0.0;
      }
      const double fraction = std::isfinite(value) ? std::clamp(value, 0.0, 1.0) : 0.0;
      return fraction * (layer.Modulus - below);
    };
    modulus += Interpolate(*layer.Image, pointWorld, change);
  }
  if (this->Power != 1.0 && modulus != this->Tissue)
  {
    modulus = std::clamp(this->Tissue * std::pow(modulus / this->Tissue, this->Power), LeastModulus,
                         MostModulus);
  }
  return modulus;
}
} // namespace palpate
