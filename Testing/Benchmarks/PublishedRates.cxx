#include "PublishedRates.h"

#include "ClosestPointSearch.h"
#include "FacetContactModel.h"
#include "FieldBuilder.h"
#include "FieldContactModel.h"
#include "FieldSampler.h"
#include "IcosahedronDirections.h"
#include "OrganContact.h"
#include "ProceduralFields.h"
#include "PublishedShell.h"
#include "RandomShapes.h"
#include "ServoStroke.h"
#include "Units.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <iomanip>
#include <memory>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace palpate::bench
{
namespace
{
constexpr int Places = 4000;
constexpr double RateStep = 0.05; // mm per tick: 50 mm/s at 1 kHz

// The centre of a tool that just touches the true surface next to a probe, and the normal there.
struct TrueTouch
{
  Vector3 Place;
  Vector3 Normal;
};
using Truth = std::function<TrueTouch(const Vector3& probe)>;

void RequireRate(const Status& status)
{
  if (!status.IsOk())
  {
    throw std::runtime_error(status.Message());
  }
}

// Directions that rotate about an axis, some `angle` (rad) per place.
std::vector<Vector3> Turn(double angle)
{
  std::vector<Vector3> directions;
  Vector3 u = Vector3::UnitX();
  const Eigen::AngleAxisd turn(angle, Vector3(0.2, 0.3, 1.0).normalized());
  while (directions.size() < Places)
  {
    directions.push_back(u);
    u = (turn * u).normalized();
  }
  return directions;
}

// 12,300,000: three digits, in groups.
std::string Thousands(double number)
{
  const double unit = std::pow(10.0, std::max(0.0, std::floor(std::log10(number)) - 2.0));
  std::string digits = std::to_string(std::llround(unit * std::round(number / unit)));
  for (auto place = static_cast<std::ptrdiff_t>(digits.size()) - 3; place > 0; place -= 3)
  {
    digits.insert(static_cast<std::size_t>(place), ",");
  }
  return digits;
}

VolumeQuestions QuestionsOf(const std::shared_ptr<const ScalarField>& field, const ToolShape& tool,
                            const std::vector<Vector3>& path)
{
  constexpr std::size_t Published = 60;
  constexpr int Runs = 20;
  const FieldSampler sampler(field);
  std::vector<Vector3> points;
  for (const Vector3& probe : path)
  {
    for (const Vector3& offset : tool.Points())
    {
      points.emplace_back(probe + offset);
    }
  }
  std::vector<unsigned char> inside(points.size());
  double shortest = INFINITY;
  for (int run = 0; run < Runs; ++run)
  {
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t first = 0; first + Published <= points.size(); first += Published)
    {
      sampler.AreInsideWorld(0, &points[first], Published, &inside[first]);
    }
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    shortest = std::min(shortest, spent.count());
  }
  const std::size_t updates = points.size() / Published;
  const auto touching = std::accumulate(inside.begin(), inside.end(), std::size_t{0});
  return {static_cast<double>(touching) / Places, shortest / static_cast<double>(updates)};
}

PublishedRateRow MeasureRate(const std::string& name,
                             const std::shared_ptr<const ContactModel>& model,
                             const ToolShape& tool, const std::vector<Vector3>& path,
                             const Truth& truth)
{
  constexpr int Strokes = 20;
  auto scene = std::make_shared<TouchScene>();
  scene->Tool = tool;
  scene->Structures.push_back({name, model, {0.5, 0.0}, {}});
  ServoStroke hand(scene, path);
  std::vector<double> ticks;
  for (int stroke = 0; stroke < Strokes; ++stroke)
  {
    hand.StrokeTimed(ticks);
  }
  PublishedRateRow row{};
  row.Touched = name;
  row.TicksPerSecond =
      1e9 * static_cast<double>(ticks.size()) / std::accumulate(ticks.begin(), ticks.end(), 0.0);
  for (std::size_t tick = 0; tick < hand.Ticks(); ++tick)
  {
    const TrueTouch ideal = truth(hand.Probes()[tick]);
    const Vector3 push = hand.Proxies()[tick] - hand.Probes()[tick];
    const double off = std::abs((hand.Proxies()[tick] - ideal.Place).dot(ideal.Normal));
    const double angle = std::atan2(push.cross(ideal.Normal).norm(), push.dot(ideal.Normal));
    row.PlaceMean += off / Places;
    row.PlaceMaximum = std::max(row.PlaceMaximum, off);
    row.AngleMean += angle / Places;
    row.AngleMaximum = std::max(row.AngleMaximum, angle);
  }
  return row;
}

// An organ of degree 12, stroked by a point 1.5 mm deep.
void AddHarmonics(PublishedComparison& made)
{
  constexpr double Depth = 1.5;
  constexpr int Frequency = 20; // 8,000 facets
  test::Random random(12);
  const auto organ = std::make_shared<const RadialModel>(test::RandomOrgan(random, 12));
  const ClosestPointSearch search(organ);
  const Truth truth = [&](const Vector3& probe)
  {
    const ClosestPoint nearest = search.Nearest(probe);
    return TrueTouch{nearest.PointWorld, nearest.Normal};
  };
  std::vector<Vector3> path;
  for (const Vector3& u : Turn(RateStep / 20.0))
  {
    path.push_back(organ->PointWorld(u) - Depth * organ->Normal(u));
  }
  const IcosahedronDirections sphere(Frequency);
  std::vector<Vector3> corners;
  for (const Vector3& u : sphere.Directions())
  {
    corners.push_back(organ->PointWorld(u));
  }
  std::shared_ptr<const ContactModel> radial;
  std::shared_ptr<const ContactModel> nearest;
  std::shared_ptr<const ContactModel> facets;
  RequireRate(MakeOrganContact(organ, RadialContactMode::Radial, radial));
  RequireRate(MakeOrganContact(organ, RadialContactMode::Nearest, nearest));
  RequireRate(FacetContactModel::Make(corners, sphere.Triangles(), facets));
  const ToolShape point = ToolShape::Sphere(0.0);
  made.Rows.push_back(
      MeasureRate("degree 12, the published radial law", radial, point, path, truth));
  made.Rows.back().System = "spherical harmonics of a prostate";
  made.Rows.back().PublishedHertz = "850 to 1,200";
  made.Rows.push_back(MeasureRate("degree 12, nearest point", nearest, point, path, truth));
  made.Rows.push_back(MeasureRate("8,000 facets, god-object", facets, point, path, truth));
  made.Rows.back().PublishedHertz = "400 to 900";
}

// A sphere of 30 mm in voxels of 0.5 mm, stroked by one of 2 mm half a voxel deep.
void AddVoxels(PublishedComparison& made)
{
  constexpr int Nodes = 140;
  constexpr double Spacing = 0.5;
  constexpr double ToolRadius = 2.0;
  const FieldGrid grid({Nodes, Nodes, Nodes}, Vector3::Zero(), Vector3::Constant(Spacing),
                       Matrix3::Identity());
  const test::SphereField sphere{Vector3(69.3, 70.1, 68.7), 60.0};
  const auto samples = test::SampleAtIndices<float>(grid.Size(), sphere);
  FieldBuilder builder(grid);
  builder.AddMaterial({builder.AddChannel(SamplesOfGrid(samples.data(), grid)), 0.0});
  std::shared_ptr<const ScalarField> field;
  RequireRate(builder.Build(field));
  const Vector3 center = grid.PointWorld(sphere.Center);
  const double contact = Spacing * sphere.Radius + ToolRadius;
  const Truth truth = [&](const Vector3& probe)
  {
    const Vector3 normal = (probe - center).normalized();
    return TrueTouch{center + contact * normal, normal};
  };
  std::vector<Vector3> path;
  for (const Vector3& u : Turn(RateStep / 30.0))
  {
    path.push_back(center + (contact - 0.5 * Spacing) * u);
  }
  std::shared_ptr<const ContactModel> published;
  std::shared_ptr<const ContactModel> solved;
  RequireRate(test::MakePublishedShell(field, 0, published));
  RequireRate(FieldContactModel::Make(field, 0, solved));
  const ToolShape tool = ToolShape::SpherePoints(ToolRadius, ToolShape::NeighbourCount);
  made.Rows.push_back(MeasureRate("26 points, the published law", published, tool, path, truth));
  made.Rows.back().System = "sub-voxel surface of a skull";
  made.Rows.back().PublishedHertz = "6,000";
  made.Rows.push_back(MeasureRate("26 points, solved planes", solved, tool, path, truth));
  made.Questions = QuestionsOf(field, tool, path);
}
} // namespace

PublishedComparison ComparePublished()
{
  PublishedComparison made;
  AddHarmonics(made);
  AddVoxels(made);
  return made;
}

std::string ToMarkdown(const PublishedComparison& comparison)
{
  constexpr double Nano = 1e9;
  std::ostringstream text;
  text << "| published system | touched here by | ticks a second | published, Hz | proxy off the "
          "true place: mean, mm | most | force off the true normal: mean | most "
          "|\n|---|---|---|---|---|---|---|---|\n";
  for (const PublishedRateRow& row : comparison.Rows)
  {
    text << "| " << row.System << " | " << row.Touched << " | " << Thousands(row.TicksPerSecond)
         << " | " << row.PublishedHertz << " | " << std::setprecision(2) << row.PlaceMean << " | "
         << row.PlaceMaximum << " | " << DegreesPerRadian * row.AngleMean << "° | "
         << DegreesPerRadian * row.AngleMaximum << "° |\n";
  }
  const VolumeQuestions& asked = comparison.Questions;
  text << "\nThe published law of 26 points asks 26 inside tests and, in the mean, " << asked.Rays
       << " rays a tick. About 60 inside tests an update were published; 60 take "
       << std::setprecision(3) << Nano * asked.SixtyInsideSeconds
       << " ns here, which alone would be " << Thousands(1.0 / asked.SixtyInsideSeconds)
       << " updates a second.\n";
  return text.str();
}
} // namespace palpate::bench
