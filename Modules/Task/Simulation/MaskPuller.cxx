#include "MaskPuller.h"

#include "MeshConversion.h"
#include "Refusal.h"
#include "TouchContact.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
constexpr int MostPulls = 25;
constexpr double LeastSeenError = 1.0; // mm, of a place that is pulled
constexpr double SeenAround = 3.0;     // mm, about 7 degrees of a gland: an error is seen over it
constexpr std::size_t Looks = 400;     // places that are compared
constexpr int Corrections = 2;         // of the motion, by what is seen
// 9, 14, 22 and 35 degrees of a gland of 22 mm, mm.
constexpr std::array<double, 4> Widths{3.5, 5.4, 8.4, 13.4};

// How much of what is wanted a pull would leave.
double LeftBy(const SurfaceCorrection& pulls, const SurfacePull& pull,
              const std::vector<double>& wanted)
{
  Eigen::Matrix3Xd after;
  if (!pulls.Preview(pull, after).IsOk())
  {
    return std::numeric_limits<double>::infinity();
  }
  double left = 0.0;
  for (std::size_t n = 0; n < wanted.size(); ++n)
  {
    const auto column = static_cast<Eigen::Index>(n);
    const Vector3 motion = after.col(column) - pulls.Displacements().col(column);
    left += std::abs(wanted[n] - motion.dot(pulls.Directions()[n]));
  }
  return left;
}
} // namespace

void MaskPuller::Correct(CorrectedShape& mask)
{
  for (int n = 0; n < MostPulls; ++n)
  {
    const SurfaceCorrection& pulls = mask.Pulls();
    const std::vector<double> wanted = this->Wanted(pulls);
    const Place worst = this->Worst(pulls, wanted);
    if (std::abs(worst.Wanted) < LeastSeenError)
    {
      return;
    }
    SurfacePull pull = this->Pull(pulls, worst);
    if (this->Hand.Watched().IsOver())
    {
      return; // what is held is not let go any more
    }
    double least = std::numeric_limits<double>::infinity();
    for (const double width : Widths)
    {
      SurfacePull wide = pull;
      wide.Width = width;
      const double left = LeftBy(pulls, wide, wanted);
      pull.Width = left < least ? width : pull.Width;
      least = std::min(least, left);
    }
    std::vector<CorrectionStep> steps = mask.Steps();
    steps.emplace_back(pull);
    mask.Do(steps);
    this->FeelAgain(mask);
  }
}

// How far each point is from the edge, outwards.
std::vector<double> MaskPuller::Wanted(const SurfaceCorrection& pulls) const
{
  std::vector<Vector3> points;
  for (std::size_t n = 0; n < pulls.Points().size(); ++n)
  {
    points.push_back(pulls.PointNow(n));
  }
  std::vector<double> distances;
  RequireInput(this->Truth.DistancesOf(points, {}, distances), "the mask");
  for (double& distance : distances)
  {
    distance = -distance; // inside of the organ the surface has to go outwards
  }
  return distances;
}

MaskPuller::Place MaskPuller::Worst(const SurfaceCorrection& pulls,
                                    const std::vector<double>& wanted)
{
  Place worst;
  const std::vector<Vector3>& points = pulls.Points();
  const std::size_t stride = points.size() / Looks + 1;
  for (std::size_t n = 0; n < points.size(); n += stride)
  {
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t other = 0; other < points.size(); ++other)
    {
      const bool isNear = (points[other] - points[n]).squaredNorm() < SeenAround * SeenAround;
      sum += isNear ? wanted[other] : 0.0;
      count += isNear ? 1.0 : 0.0;
    }
    const double seen = sum / count + this->Hand.Error(this->Skill.SeenErrorDeviation);
    worst = std::abs(seen) > std::abs(worst.Wanted) ? Place{n, seen} : worst;
  }
  return worst;
}

void MaskPuller::Touch(const Vector3& place, const Vector3& normal)
{
  const Vector3 seen = this->Hand.See(place, normal);
  this->Hand.TravelTo(seen + (this->Hand.ToolRadius() + TaskHand::Hover) * normal);
  if (this->Hand.HasForce())
  {
    this->Hand.ReachForContact(-normal, TaskHand::LongestReach);
  }
  else
  {
    this->Hand.MoveTo(seen);
  }
}

// Grips the surface where the tool is, leads it by what is seen, and lets it go. It is not felt
// meanwhile.
SurfacePull MaskPuller::Pull(const SurfaceCorrection& pulls, const Place& worst)
{
  this->Touch(pulls.PointNow(worst.Point), pulls.Directions()[worst.Point]);
  const std::size_t gripped = pulls.NearestNow(this->Hand.TipWorld());
  const Vector3 normal = pulls.Directions()[gripped];
  SurfacePull pull;
  pull.PlaceWorld = pulls.PointNow(gripped);
  const Vector3 start = this->Hand.ProbeWorld();
  TouchScene nothing = this->Hand.Scene();
  nothing.Structures.clear();
  this->Hand.Feel(std::move(nothing));
  for (int n = 0; n < Corrections; ++n)
  {
    const double left = worst.Wanted - (this->Hand.ProbeWorld() - start).dot(normal);
    this->Hand.MoveTo(this->Hand.AimWorld() +
                      (left + this->Hand.Error(this->Skill.PullDeviation)) * normal);
  }
  pull.TargetWorld = pull.PlaceWorld + this->Hand.ProbeWorld() - start;
  this->Hand.MoveTo(this->Hand.AimWorld() + (this->Hand.ToolRadius() + TaskHand::Hover) * normal);
  return pull;
}

void MaskPuller::FeelAgain(CorrectedShape& mask)
{
  const SurfaceCorrection& pulls = mask.Pulls();
  IndexedMesh mesh{pulls.Points(), mask.Triangles()};
  for (std::size_t n = 0; n < mesh.Points.size(); ++n)
  {
    mesh.Points[n] = pulls.PointNow(n);
  }
  TouchScene scene = this->Hand.FirstScene();
  scene.Structures.front().Model = MakeFacetContact(ToPolyData(mesh), {}).Model;
  this->Hand.Feel(std::move(scene));
}
} // namespace palpate
