#include "TouchQuality.h"

#include "BumpyBody.h"
#include "ClosestPointSearch.h"
#include "FacetContactModel.h"
#include "FieldBuilder.h"
#include "FieldContactModel.h"
#include "ForceQuality.h"
#include "IcosahedronDirections.h"
#include "OrganContact.h"
#include "PublishedShell.h"
#include "Units.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <limits>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace palpate::bench
{
namespace
{
using Clock = std::chrono::steady_clock;

constexpr std::size_t QualityTicks = 60000; // a minute
constexpr int Runs = 5;
constexpr double Seizure = 2.0; // mm

double NanosecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

double QuantileOf(std::vector<double> values, double part)
{
  const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

double ClockNanoseconds()
{
  std::vector<double> times;
  while (times.size() < 10001)
  {
    times.push_back(NanosecondsSince(Clock::now()));
  }
  return QuantileOf(times, 0.5);
}

void RequireQuality(const Status& status)
{
  if (!status.IsOk())
  {
    throw std::runtime_error(status.Message());
  }
}

// The path of a tool and the true positions of its proxy.
struct Path
{
  Path(const ClosestPointSearch& search, double toolRadius) : ToolRadius(toolRadius)
  {
    test::Random random(64);
    const RadialModel& body = search.Model();
    Vector3 u = test::RandomDirection(random);
    Vector3 axis = u.unitOrthogonal();
    this->Start = body.PointWorld(u) + (toolRadius + 1.0) * body.Normal(u);
    for (std::size_t tick = 0; tick < QualityTicks; ++tick)
    {
      const double step = 0.06 + 0.04 * std::sin(1.7e-3 * static_cast<double>(tick));  // mm
      const double depth = 1.75 - 1.25 * std::cos(4.1e-3 * static_cast<double>(tick)); // mm
      axis = (axis + 0.02 * test::RandomDirection(random)).normalized();
      u = (Eigen::AngleAxisd(step / body.Radius(u), axis) * u).normalized();
      const Vector3 probe = body.PointWorld(u) + (toolRadius - depth) * body.Normal(u);
      const ClosestPoint nearest = search.Nearest(probe);
      this->Probes.push_back(probe);
      this->Proxies.push_back(nearest.PointWorld + toolRadius * nearest.Normal);
    }
  }

  double ToolRadius;
  Vector3 Start; // free
  std::vector<Vector3> Probes;
  std::vector<Vector3> Proxies;
};

// One touch model on its path.
class Rehearsal
{
public:
  Rehearsal(const ContactModel& model, const ToolShape& tool, const Path& path)
      : Followed(path), Times(QualityTicks, std::numeric_limits<double>::infinity()),
        Felt(QualityTicks)
  {
    RequireQuality(model.MakeTracker(tool, {}, this->Tracker));
    for (int run = 0; run < Runs; ++run)
    {
      this->Run();
    }
  }

  TouchQualityRow Assess(const std::string& name, const ClosestPointSearch& search) const
  {
    static const double clock = ClockNanoseconds();
    TouchQualityRow row{};
    row.Name = name;
    row.MedianNanoseconds = QuantileOf(this->Times, 0.5) - clock;
    row.RareNanoseconds = QuantileOf(this->Times, 0.999) - clock;
    row.LongestNanoseconds = QuantileOf(this->Times, 1.0) - clock;
    this->AssessPlaces(search, row);
    this->AssessForces(row);
    return row;
  }

private:
  void Run()
  {
    this->Tracker->Release();
    this->Tracker->Follow({this->Followed.Start, Eigen::Quaterniond::Identity()});
    for (std::size_t tick = 0; tick < QualityTicks; ++tick)
    {
      const ToolPose pose{this->Followed.Probes[tick], Eigen::Quaterniond::Identity()};
      const auto start = Clock::now();
      const Contact& contact = this->Tracker->Follow(pose);
      this->Times[tick] = std::min(this->Times[tick], NanosecondsSince(start));
      this->Felt[tick] = contact.ProxyWorld;
    }
  }

  void AssessPlaces(const ClosestPointSearch& search, TouchQualityRow& row) const
  {
    bool wasWrong = false;
    for (std::size_t tick = 0; tick < QualityTicks; ++tick)
    {
      const double gap =
          search.Nearest(this->Felt[tick]).SignedDistance - this->Followed.ToolRadius;
      row.SurfaceMean += std::abs(gap) / static_cast<double>(QualityTicks);
      row.SurfaceMaximum = std::max(row.SurfaceMaximum, std::abs(gap));
      const bool isWrong = !((this->Felt[tick] - this->Followed.Proxies[tick]).norm() <= Seizure);
      row.Seizures += isWrong && !wasWrong ? 1 : 0;
      wasWrong = isWrong;
    }
  }

  void AssessForces(TouchQualityRow& row) const
  {
    test::ForceQuality quality;
    for (std::size_t tick = 0; tick < QualityTicks; ++tick)
    {
      const Vector3& probe = this->Followed.Probes[tick];
      quality.Add(this->Felt[tick] - probe, this->Followed.Proxies[tick] - probe);
    }
    row.AngleMean = quality.MeanAngle();
    row.AngleRare = quality.AngleQuantile(0.99);
    row.AngleMaximum = quality.AngleQuantile(1.0);
    row.JumpMean = quality.FeltJumps().RelativeMean();
    row.JumpMaximum = quality.FeltJumps().RelativeMaximum();
    row.IdealJumpMean = quality.IdealJumps().RelativeMean();
    row.IdealJumpMaximum = quality.IdealJumps().RelativeMaximum();
  }

  const Path& Followed;
  std::unique_ptr<ContactTracker> Tracker;
  std::vector<double> Times;
  std::vector<Vector3> Felt;
};

std::shared_ptr<const ContactModel> RadialOf(const std::shared_ptr<const RadialModel>& body,
                                             RadialContactMode mode)
{
  std::shared_ptr<const ContactModel> model;
  RequireQuality(MakeOrganContact(body, mode, model));
  return model;
}

std::shared_ptr<const ContactModel> FacetsOf(const RadialModel& body, int frequency)
{
  const IcosahedronDirections sphere(frequency);
  std::vector<Vector3> corners;
  for (const Vector3& u : sphere.Directions())
  {
    corners.push_back(body.PointWorld(u));
  }
  std::shared_ptr<const ContactModel> model;
  RequireQuality(FacetContactModel::Make(corners, sphere.Triangles(), model));
  return model;
}

// A cube of 64 mm around the body, inside where its radius exceeds the distance.
std::shared_ptr<const ScalarField> FieldOf(const RadialModel& body, int nodes,
                                           FieldInterpolation interpolation)
{
  const double spacing = 64.0 / nodes;
  const Vector3 corner = body.CenterWorld() - Vector3::Constant(0.5 * spacing * (nodes - 1));
  const FieldGrid grid({nodes, nodes, nodes}, corner, Vector3::Constant(spacing),
                       Matrix3::Identity());
  std::vector<float> samples;
  samples.reserve(grid.NodeCount());
  for (int k = 0; k < nodes; ++k)
  {
    for (int j = 0; j < nodes; ++j)
    {
      for (int i = 0; i < nodes; ++i)
      {
        const Vector3 offset = grid.PointWorld(Vector3(i, j, k)) - body.CenterWorld();
        const double distance = offset.norm(); // never 0: the centre lies between nodes
        samples.push_back(static_cast<float>(body.Radius(offset / distance) - distance));
      }
    }
  }
  FieldBuilder builder(grid);
  builder.AddMaterial({builder.AddChannel(SamplesOfGrid(samples.data(), grid)), 0.0});
  builder.SetInterpolation(interpolation);
  std::shared_ptr<const ScalarField> field;
  RequireQuality(builder.Build(field));
  return field;
}

std::shared_ptr<const ContactModel> FieldContactOf(const std::shared_ptr<const ScalarField>& field)
{
  std::shared_ptr<const ContactModel> model;
  RequireQuality(FieldContactModel::Make(field, 0, model));
  return model;
}

std::shared_ptr<const ContactModel> PublishedOf(const std::shared_ptr<const ScalarField>& field)
{
  std::shared_ptr<const ContactModel> model;
  RequireQuality(test::MakePublishedShell(field, 0, model));
  return model;
}

void AddHarmonicRows(const std::shared_ptr<const RadialModel>& body,
                     const ClosestPointSearch& search, std::vector<TouchQualityRow>& rows)
{
  const auto nearest = RadialOf(body, RadialContactMode::Nearest);
  for (const double radius : {0.0, 1.0, 4.0})
  {
    std::ostringstream name;
    name << "spherical harmonics, " << (radius > 0.0 ? "sphere of " : "point");
    radius > 0.0 ? name << radius << " mm" : name;
    rows.push_back(Rehearsal(*nearest, ToolShape::Sphere(radius), Path(search, radius))
                       .Assess(name.str(), search));
  }
  const auto radial = RadialOf(body, RadialContactMode::Radial);
  rows.push_back(Rehearsal(*radial, ToolShape::Sphere(0.0), Path(search, 0.0))
                     .Assess("spherical harmonics, the published radial law, point", search));
}
} // namespace

std::vector<TouchQualityRow> TouchQuality()
{
  test::Random random(63);
  const auto body = std::make_shared<const RadialModel>(test::BumpyBody(random));
  const ClosestPointSearch search(body);
  std::vector<TouchQualityRow> rows;
  AddHarmonicRows(body, search, rows);
  const Path path(search, 1.0);
  const auto add = [&](const ContactModel& model, const ToolShape& tool, const std::string& name)
  { rows.push_back(Rehearsal(model, tool, path).Assess(name, search)); };
  for (const int frequency : {20, 40, 80})
  {
    add(*FacetsOf(*body, frequency), ToolShape::Sphere(1.0),
        std::to_string(20 * frequency * frequency / 1000) + ",000 facets, sphere of 1 mm");
  }
  const ToolShape shell = ToolShape::SpherePoints(1.0, ToolShape::NeighbourCount);
  for (const int nodes : {128, 256})
  {
    const std::string size = std::to_string(nodes) + "³ voxels, ";
    const auto linear = FieldOf(*body, nodes, FieldInterpolation::Trilinear);
    const auto cubic = FieldOf(*body, nodes, FieldInterpolation::TricubicBSpline);
    add(*FieldContactOf(linear), shell, size + "trilinear, 26 points on 1 mm");
    add(*FieldContactOf(cubic), shell, size + "tricubic, 26 points on 1 mm");
    add(*PublishedOf(linear), shell, size + "the published law, 26 points on 1 mm");
  }
  return rows;
}

std::string ToMarkdown(const std::vector<TouchQualityRow>& rows)
{
  constexpr double Percent = 100.0;
  std::ostringstream text;
  text << "| touched | tick: median, µs | 99.9 % | longest | place to surface: mean, mm | most | "
          "force angle error: mean | 99 % | most | force jump a tick: mean | most | ideal's: mean "
          "| most | seizures |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  text << std::setprecision(2);
  for (const TouchQualityRow& row : rows)
  {
    text << "| " << row.Name << " | " << MicrosecondsPerNanosecond * row.MedianNanoseconds << " | "
         << MicrosecondsPerNanosecond * row.RareNanoseconds << " | "
         << MicrosecondsPerNanosecond * row.LongestNanoseconds << " | " << row.SurfaceMean << " | "
         << row.SurfaceMaximum << " | " << DegreesPerRadian * row.AngleMean << "° | "
         << DegreesPerRadian * row.AngleRare << "° | " << DegreesPerRadian * row.AngleMaximum
         << "° | " << Percent * row.JumpMean << " % | " << Percent * row.JumpMaximum << " % | "
         << Percent * row.IdealJumpMean << " % | " << Percent * row.IdealJumpMaximum << " % | "
         << row.Seizures << " |\n";
  }
  return text.str();
}
} // namespace palpate::bench
