#include "BodyComparison.h"

#include "MeshGap.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

namespace palpate
{
namespace
{
Status MapDistances(const ComparedBody& from, const ComparedBody& to,
                    const KernelProgress& progress, DistanceMap& map)
{
  if (Status status = from.SampleDistancesFrom(to, progress, map.Samples); !status.IsOk())
  {
    return status;
  }
  const std::vector<double>& values = map.Samples.Values;
  const auto points = static_cast<std::ptrdiff_t>(from.Surface().Points.size());
  map.Values.assign(values.begin(), values.begin() + points);
  map.Unsigned = Summarise(map.Samples);
  map.SignedMean = to.IsClosed() ? std::inner_product(values.begin(), values.end(),
                                                      map.Samples.Weights.begin(), 0.0)
                                 : std::numeric_limits<double>::quiet_NaN();
  return Status::Success();
}
} // namespace

double BodyComparison::Hausdorff95() const noexcept
{
  return std::max(this->OneToOther.Unsigned.Percentile95, this->OtherToOne.Unsigned.Percentile95);
}

std::vector<double> SurfaceDice(const ComparedBody& one, const DistanceMap& there,
                                const ComparedBody& other, const DistanceMap& back,
                                const std::vector<double>& tolerances)
{
  std::vector<double> dice;
  for (const double tolerance : tolerances)
  {
    const double within = one.Area() * ShareWithin(there.Samples, tolerance) +
                          other.Area() * ShareWithin(back.Samples, tolerance);
    dice.push_back(within / (one.Area() + other.Area()));
  }
  return dice;
}

Status CompareBodies(const ComparedBody& one, const ComparedBody& other,
                     const std::vector<double>& tolerances, const KernelProgress& progress,
                     BodyComparison& comparison)
{
  BodyComparison made;
  const bool areModels = one.IsModel() && other.IsModel();
  BodyOverlap overlap;
  if (!areModels && FindBodyOverlap(one, other, overlap).IsOk())
  {
    made.Overlap = overlap;
  }
  Status status = MapDistances(one, other, PartOf(progress, 0.2, 0.6), made.OneToOther);
  if (status.IsOk())
  {
    status = MapDistances(other, one, PartOf(progress, 0.6, 1.0), made.OtherToOne);
  }
  if (!status.IsOk())
  {
    return status;
  }
  if (areModels)
  {
    made.Overlap =
        BodyOverlap::OfModels(one, made.OneToOther.Values, other, made.OtherToOne.Values);
  }
  made.Both = TwoSidedDistances(made.OneToOther.Samples, made.OtherToOne.Samples);
  if (!made.Overlap || made.Overlap->Both == 0.0)
  {
    MeshGap gap;
    if (status = FindMeshGap(one.Surface(), other.Surface(), gap); !status.IsOk())
    {
      return status;
    }
    made.LeastDistance = gap.Distance;
  }
  const std::vector<double> dice =
      SurfaceDice(one, made.OneToOther, other, made.OtherToOne, tolerances);
  for (std::size_t i = 0; i < tolerances.size(); ++i)
  {
    made.Tolerances.push_back({tolerances[i], dice[i]});
  }
  if (other.IsClosed())
  {
    made.Bias = SideBias::Of(made.OneToOther.Samples, other.Centroid());
  }
  comparison = std::move(made);
  return Status::Success();
}
} // namespace palpate
