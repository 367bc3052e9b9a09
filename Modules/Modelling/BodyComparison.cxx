#include "BodyComparison.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
std::vector<double> Lengths(const DistanceMap& map)
{
  std::vector<double> lengths;
  lengths.reserve(map.Values.size());
  for (const double value : map.Values)
  {
    lengths.push_back(std::abs(value));
  }
  return lengths;
}

Status MapDistances(const ComparedBody& from, const ComparedBody& to,
                    const KernelProgress& progress, DistanceMap& map)
{
  if (Status status = to.DistancesOf(from.Surface().Points, progress, map.Values); !status.IsOk())
  {
    return status;
  }
  map.Unsigned = Summarise(Lengths(map), from.Weights());
  map.SignedMean = to.IsClosed() ? 0.0 : std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < map.Values.size(); ++i)
  {
    map.SignedMean += from.Weights()[i] * map.Values[i];
  }
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
  const std::vector<double> lengthsThere = Lengths(there);
  const std::vector<double> lengthsBack = Lengths(back);
  std::vector<double> dice;
  for (const double tolerance : tolerances)
  {
    const double within = one.Area() * ShareWithin(one.Surface(), lengthsThere, tolerance) +
                          other.Area() * ShareWithin(other.Surface(), lengthsBack, tolerance);
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
  made.Both = TwoSidedDistances(Lengths(made.OneToOther), one.Weights(), Lengths(made.OtherToOne),
                                other.Weights());
  const std::vector<double> dice =
      SurfaceDice(one, made.OneToOther, other, made.OtherToOne, tolerances);
  for (std::size_t i = 0; i < tolerances.size(); ++i)
  {
    made.Tolerances.push_back({tolerances[i], dice[i]});
  }
  if (other.IsClosed())
  {
    made.Bias =
        SideBias::Of(one.Surface().Points, made.OneToOther.Values, one.Weights(), other.Centroid());
  }
  comparison = std::move(made);
  return Status::Success();
}
} // namespace palpate
