#include "BumpyTouchBenchmarks.h"

#include "ContactWedge.h"
#include "OrganContact.h"
#include "RandomShapes.h"
#include "SearchedWedge.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

namespace palpate::bench
{
namespace
{
constexpr std::size_t BumpTicks = 500;
constexpr double BumpStep = 0.05;      // mm a tick: 50 mm/s at 1 kHz
constexpr double BumpDepth = 1.5;      // mm
constexpr double BumpToolRadius = 6.0; // mm, of the sphere

// A probe that wanders `depth` below where a tool of this radius touches.
std::vector<Vector3> PathOn(const RadialModel& organ, double toolRadius)
{
  test::Random random(71);
  std::vector<Vector3> path;
  Vector3 place = Vector3::UnitX();
  Vector3 axis = test::RandomDirection(random);
  while (path.size() < BumpTicks)
  {
    axis = (axis + 0.02 * test::RandomDirection(random)).normalized();
    place = (Eigen::AngleAxisd(BumpStep / 20.0, axis) * place).normalized();
    path.push_back(organ.PointWorld(place) + (toolRadius - BumpDepth) * organ.Normal(place));
  }
  return path;
}

std::shared_ptr<const RadialModel> OrganOf(int degree)
{
  test::Random random(12);
  return std::make_shared<const RadialModel>(test::RandomOrgan(random, degree));
}

// The part of ticks whose places are more than `most` (mm) apart.
double PartApart(const std::vector<Vector3>& a, const std::vector<Vector3>& b, double most)
{
  std::size_t apart = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    apart += (a[i] - b[i]).norm() <= most ? 0 : 1;
  }
  return static_cast<double>(apart) / static_cast<double>(a.size());
}

std::string Disagreement(const std::vector<Vector3>& a, const std::vector<Vector3>& b)
{
  constexpr double MostApart = 0.02; // where one has found another way out
  const double part = PartApart(a, b, 1e-3);
  std::ostringstream text;
  text << 100.0 * part << " % of the places are more than 0.001 mm apart";
  return part <= MostApart ? std::string() : text.str();
}

class HollowCase
{
public:
  explicit HollowCase(int degree)
  {
    const auto organ = OrganOf(degree);
    this->Path = PathOn(*organ, BumpToolRadius);
    std::shared_ptr<const TouchableRadialModel> surface;
    if (TouchableRadialModel::Make(organ, surface).IsOk())
    {
      this->Nearest = surface->Search().Nearest(this->Path.front());
      this->Proving.emplace(surface, BumpToolRadius);
      this->Searching.emplace(surface, BumpToolRadius);
    }
  }

  void Prove()
  {
    this->Proving->Begin(this->Nearest);
    Follow(*this->Proving, this->Ours);
  }
  void Search()
  {
    this->Searching->Begin(this->Nearest.PointWorld + BumpToolRadius * this->Nearest.Normal);
    Follow(*this->Searching, this->Theirs);
  }
  std::string Compared() const { return Disagreement(this->Ours, this->Theirs); }

private:
  template <typename Wedge>
  void Follow(Wedge& wedge, std::vector<Vector3>& places) const
  {
    for (std::size_t i = 0; i < BumpTicks; ++i)
    {
      wedge.MoveTo(this->Path[i]);
      places[i] = wedge.CenterWorld();
    }
  }

  std::vector<Vector3> Path;
  ClosestPoint Nearest;
  std::optional<ContactWedge> Proving;
  std::optional<test::SearchedWedge> Searching;
  std::vector<Vector3> Ours{BumpTicks};
  std::vector<Vector3> Theirs{BumpTicks};
};

PairedBenchmark HollowBenchmark(int degree)
{
  const auto hollows = std::make_shared<HollowCase>(degree);
  return {"touch/sh/bumpy/degree" + std::to_string(degree),
          "a search of the whole surface a step (ours)",
          [hollows] { hollows->Prove(); },
          [hollows] { hollows->Search(); },
          [hollows] { return hollows->Compared(); },
          BumpTicks};
}
} // namespace

std::vector<PairedBenchmark> BumpyTouchBenchmarks()
{
  return {HollowBenchmark(12), HollowBenchmark(24)};
}
} // namespace palpate::bench
