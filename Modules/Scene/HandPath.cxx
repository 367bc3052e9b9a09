#include "HandPath.h"

#include "DecimalText.h"
#include "Refusal.h"
#include "ServoScene.h"
#include "Units.h"
#include "WholeFile.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <sstream>
#include <utility>

namespace palpate
{
namespace
{
constexpr std::uintmax_t LargestPath = std::uintmax_t{256} << 20;

HandPath::Place ParseLine(const std::string& line, const std::filesystem::path& path, int number)
{
  std::istringstream stream(line);
  std::vector<double> numbers;
  for (std::string word; std::getline(stream, word, ',');)
  {
    numbers.push_back(ParseNumber(word).value_or(NAN));
  }
  const bool areFinite = std::all_of(numbers.begin(), numbers.end(),
                                     [](double value) { return std::isfinite(value); });
  if (numbers.size() != 4 || !areFinite)
  {
    Refuse(path, "does not have four numbers in line " + std::to_string(number),
           "write time_s,x_mm,y_mm,z_mm on each line");
  }
  return {numbers[0], Vector3(numbers[1], numbers[2], numbers[3])};
}

// Finds the first contact of a tool with a scene along rays from far outside to the centre.
class SceneProbe
{
public:
  explicit SceneProbe(const TouchScene& scene)
      : Bounds(scene.BoundsWorld()),
        Reach(0.5 * Bounds.diagonal().norm() + scene.Tool.BoundingRadius())
  {
  }

  // As in a servo, so that only near structures are queried.
  Status MakeTrackers(TouchScene scene)
  {
    constexpr double AnyTime = 1.0; // time constant of velocities, which are not used
    for (TouchStructure& structure : scene.Structures)
    {
      structure.Friction = {};
    }
    return ServoScene::Make(std::make_shared<const TouchScene>(std::move(scene)), AnyTime,
                            this->Felt);
  }

  Vector3 Center() const { return this->Bounds.center(); }
  /// Distance from the centre beyond which there is no structure.
  double Extent() const { return this->Reach; }

  // Distance from the centre of the first contact of a tool that approaches along `direction`;
  // negative if there is none.
  double FirstTouch(const Vector3& direction)
  {
    constexpr int Steps = 200;
    constexpr int Halvings = 12;
    const double farthest = 1.05 * this->Reach;
    double outside = farthest;
    this->Touches(this->Center() + outside * direction, true);
    for (int n = Steps - 1; n >= 0; --n)
    {
      double inside = farthest * n / Steps;
      if (!this->Touches(this->Center() + inside * direction, false))
      {
        outside = inside;
        continue;
      }
      for (int halving = 0; halving < Halvings; ++halving)
      {
        const double between = 0.5 * (inside + outside);
        (this->Touches(this->Center() + between * direction, true) ? inside : outside) = between;
      }
      return inside;
    }
    return -1.0;
  }

private:
  bool Touches(const Vector3& pointWorld, bool afresh)
  {
    if (afresh)
    {
      this->Felt->Leave();
    }
    this->Step.Last.PositionWorld = afresh ? pointWorld : this->Step.Now.PositionWorld;
    this->Step.Now.PositionWorld = pointWorld;
    return this->Felt->Follow(this->Step).Structure >= 0;
  }

  Eigen::AlignedBox3d Bounds;
  double Reach;
  std::unique_ptr<ServoScene> Felt;
  FollowStep Step;
};

// A path built place by place.
class Walk
{
public:
  Walk(const Vector3& start, double speed) : Places{{0.0, start}}, Speed(speed) {}

  void GoTo(const Vector3& point)
  {
    const double path = (point - this->Places.back().PointWorld).norm();
    // Coinciding places would take no time.
    this->Places.push_back({this->Places.back().Time + std::max(path / this->Speed, 1e-3), point});
  }
  double Time() const { return this->Places.back().Time; } ///< s
  HandPath Path() { return HandPath(std::move(this->Places)); }

private:
  std::vector<HandPath::Place> Places;
  double Speed;
};

Vector3 RandomDirection(std::mt19937_64& random)
{
  std::normal_distribution<double> normal;
  const double x = normal(random);
  const double y = normal(random);
  return Vector3(x, y, normal(random)).stableNormalized();
}

// Spiral about the z axis from pole to pole; `part` from 0 to 1.
Vector3 OnSpiral(double part)
{
  constexpr double Turns = 8.0;
  const double polar = Pi * (0.02 + 0.96 * part);
  const double azimuth = 2.0 * Pi * Turns * part;
  return {std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
          std::cos(polar)};
}
// Whether a tool there would pass by a cut, which may be as near as the surface above it.
bool IsBehindCut(const TouchScene& scene, const Vector3& place, double depth)
{
  const double reach = depth + scene.Tool.BoundingRadius();
  const auto isNear = [&](const ScanCut& cut)
  { return place.dot(cut.NormalWorld) + reach > cut.Offset - cut.Depth; };
  return std::any_of(scene.Structures.begin(), scene.Structures.end(),
                     [&](const TouchStructure& structure)
                     { return std::any_of(structure.Cuts.begin(), structure.Cuts.end(), isNear); });
}
} // namespace

Vector3 HandPath::At(double time) const noexcept
{
  if (this->Places.empty())
  {
    return Vector3::Zero();
  }
  const auto next = std::lower_bound(this->Places.begin(), this->Places.end(), time,
                                     [](const Place& place, double t) { return place.Time < t; });
  if (next == this->Places.begin())
  {
    return next->PointWorld;
  }
  const Place& last = *(next - 1);
  if (next == this->Places.end())
  {
    return last.PointWorld;
  }
  const double part = (time - last.Time) / (next->Time - last.Time);
  return (1.0 - part) * last.PointWorld + part * next->PointWorld;
}

HandPath ReadHandPath(const std::filesystem::path& path)
{
  std::istringstream stream(ReadWholeFile(path, LargestPath));
  std::vector<HandPath::Place> places;
  std::string line;
  std::getline(stream, line);
  for (int number = 2; std::getline(stream, line); ++number)
  {
    if (!line.empty() && line.back() == '\r')
    {
      line.pop_back();
    }
    if (line.empty())
    {
      continue;
    }
    places.push_back(ParseLine(line, path, number));
    if (places.size() > 1 && !(places.back().Time > places[places.size() - 2].Time))
    {
      Refuse(path, "has a time in line " + std::to_string(number) + " that does not increase",
             "sort the lines by time");
    }
  }
  if (places.empty())
  {
    Refuse(path, "contains no positions",
           "write the line time_s,x_mm,y_mm,z_mm, then one position per line");
  }
  return HandPath(std::move(places));
}

Status SweepOf(const TouchScene& scene, double depth, double speed, double longest, HandPath& path)
{
  constexpr int Knots = 400;
  SceneProbe probe(scene);
  Status status = probe.MakeTrackers(scene);
  if (!status.IsOk())
  {
    return status;
  }
  const double outside = 1.05 * probe.Extent();
  Vector3 last = OnSpiral(0.0);
  Walk walk(probe.Center() + outside * last, speed);
  bool wasTouched = true; // the first way is along its direction
  for (int knot = 0; knot <= Knots && walk.Time() < longest; ++knot)
  {
    const Vector3 direction = OnSpiral(static_cast<double>(knot) / Knots);
    const double touch = probe.FirstTouch(direction);
    const Vector3 place = probe.Center() + std::max(touch - depth, 0.0) * direction;
    const bool isTouched = touch >= 0.0 && !IsBehindCut(scene, place, depth);
    if (isTouched != wasTouched)
    {
      walk.GoTo(probe.Center() + outside * (wasTouched ? last : direction)); // never through a wall
    }
    wasTouched = isTouched;
    last = direction;
    walk.GoTo(isTouched ? place : Vector3(probe.Center() + outside * direction));
  }
  walk.GoTo(probe.Center() + outside * OnSpiral(1.0));
  path = walk.Path();
  return status;
}

Status PressesOf(const TouchScene& scene, const HandPresses& presses, HandPath& path)
{
  SceneProbe probe(scene);
  Status status = probe.MakeTrackers(scene);
  if (!status.IsOk())
  {
    return status;
  }
  std::mt19937_64 random(presses.Seed);
  const double outside = 1.05 * probe.Extent();
  Walk walk(probe.Center() + outside * Vector3::UnitZ(), presses.Speed);
  for (int n = 0; n < presses.Count; ++n)
  {
    const Vector3 direction = RandomDirection(random);
    const Vector3 aside =
        presses.Aside * direction.cross(RandomDirection(random)).stableNormalized();
    const double touch = probe.FirstTouch(direction);
    if (touch < 0.0)
    {
      continue;
    }
    const Vector3 deepest = probe.Center() + std::max(touch - presses.Depth, 0.0) * direction;
    const Vector3 before = presses.Aside * direction;
    for (const Vector3& point : {Vector3(deepest + before), deepest, Vector3(deepest + aside),
                                 Vector3(deepest + aside + before)})
    {
      walk.GoTo(point);
    }
  }
  path = walk.Path();
  return status;
}
} // namespace palpate
