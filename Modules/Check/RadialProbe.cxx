#include "RadialProbe.h"

#include "IcosahedronDirections.h"
#include "SphericalHarmonicBasis.h"
#include "Units.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr int Frequency = 8;        // 642 directions
constexpr double LeastRadius = 0.1; // of the ball of the same volume

// Depths between voxel centres; outside of the box they are below zero.
class DepthSampler
{
public:
  DepthSampler(const VoxelMask& mask, const std::vector<float>& depths) : Mask(mask), Depths(depths)
  {
  }

  bool IsInBox(const Vector3& index) const
  {
    return index.minCoeff() >= 0.0 && index[0] < this->Mask.Size[0] - 1 &&
           index[1] < this->Mask.Size[1] - 1 && index[2] < this->Mask.Size[2] - 1;
  }

  double At(const Vector3& index) const
  {
    const auto i = static_cast<int>(index[0]);
    const auto j = static_cast<int>(index[1]);
    const auto k = static_cast<int>(index[2]);
    const Vector3 part = index - Vector3(i, j, k);
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      const int x = corner & 1;
      const int y = (corner >> 1) & 1;
      const int z = corner >> 2;
      sum += (x != 0 ? part[0] : 1.0 - part[0]) * (y != 0 ? part[1] : 1.0 - part[1]) *
             (z != 0 ? part[2] : 1.0 - part[2]) *
             static_cast<double>(this->Depths[this->Mask.Offset(i + x, j + y, k + z)]);
    }
    return sum;
  }

private:
  const VoxelMask& Mask;
  const std::vector<float>& Depths;
};

// The last crossing from inside to outside, in units of `step` (in box indices); 0 if there is
// none.
double LastCrossing(const DepthSampler& sampler, const Vector3& start, const Vector3& step)
{
  double found = 0.0;
  double before = -1.0;
  for (int n = 0;; ++n)
  {
    const Vector3 at = start + n * step;
    if (!sampler.IsInBox(at))
    {
      return found;
    }
    const double depth = sampler.At(at);
    if (before > 0.0 && depth <= 0.0)
    {
      found = n - 1 + before / (before - depth);
    }
    before = depth;
  }
}
} // namespace

RadialProbe::RadialProbe()
{
  this->Rays = IcosahedronDirections(Frequency).Directions();
  const SphericalHarmonicBasis basis(Degree);
  const auto rows = static_cast<Eigen::Index>(this->Rays.size());
  const auto columns = static_cast<Eigen::Index>(basis.Size());
  Eigen::MatrixXd transposed(columns, rows);
  for (Eigen::Index n = 0; n < rows; ++n)
  {
    basis.Evaluate(this->Rays[static_cast<std::size_t>(n)], transposed.col(n).data());
  }
  this->Harmonics = transposed.transpose();
  this->Inverse = this->Harmonics.householderQr().solve(Eigen::MatrixXd::Identity(rows, rows));
}

RadialOutline RadialProbe::Measure(const CheckedMask& part,
                                   const std::vector<float>& signedDepths) const
{
  const VoxelMask& mask = part.Voxels;
  RadialOutline outline;
  outline.CenterWorld = part.Centroid();
  const Matrix3 toIndex = part.ToWorld.Axes.inverse();
  const std::array<int, 3>& first = mask.StartIndex;
  const Vector3 start =
      toIndex * (outline.CenterWorld - part.ToWorld.Origin) - Vector3(first[0], first[1], first[2]);
  const double step = 0.5 * *std::min_element(mask.Spacing.begin(), mask.Spacing.end());
  const double volume = static_cast<double>(mask.Count()) * mask.VoxelVolume();
  const double least = LeastRadius * std::cbrt(0.75 * volume / Pi);
  const DepthSampler sampler(mask, signedDepths);
  Eigen::VectorXd radii(static_cast<Eigen::Index>(this->Rays.size()));
  for (std::size_t n = 0; n < this->Rays.size(); ++n)
  {
    const double radius = step * LastCrossing(sampler, start, toIndex * (step * this->Rays[n]));
    outline.Missed += radius <= 0.0 ? 1.0 / static_cast<double>(this->Rays.size()) : 0.0;
    radii[static_cast<Eigen::Index>(n)] = std::log(std::max(radius, least));
  }
  outline.Coefficients = this->Inverse * radii;
  const Eigen::VectorXd rest = radii - this->Harmonics * outline.Coefficients;
  outline.Residual = rest.norm() / std::sqrt(static_cast<double>(rest.size()));
  Eigen::Index worst = 0;
  rest.cwiseAbs().maxCoeff(&worst);
  outline.Rough =
      outline.CenterWorld + std::exp(radii[worst]) * this->Rays[static_cast<std::size_t>(worst)];
  return outline;
}
} // namespace palpate
