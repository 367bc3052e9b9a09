#include "RigidToolBenchmarks.h"

#include "OrganContact.h"
#include "RandomShapes.h"
#include "SharedProxy.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace palpate::bench
{
namespace
{
constexpr std::size_t Ticks = 500;
constexpr double ToolRadius = 2.0; // mm
constexpr double Depth = 1.0;      // mm

// A tool that lies across the way of the hand, 50 mm/s at 1 kHz, and spheres where its balls are at
// the hand.
class Stroke
{
public:
  Stroke(int degree, const ToolShape& shape) : Shape(shape)
  {
    test::Random random(12);
    const auto organ = std::make_shared<const RadialModel>(test::RandomOrgan(random, degree));
    Vector3 place = Vector3::UnitX();
    Vector3 axis = test::RandomDirection(random);
    const auto lying = Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), axis);
    while (this->Path.size() < Ticks)
    {
      axis = (axis + 0.02 * test::RandomDirection(random)).normalized();
      place = (Eigen::AngleAxisd(0.05 / 20.0, axis) * place).normalized();
      const Vector3 normal = organ->Normal(place);
      this->Path.push_back({organ->PointWorld(place) + (ToolRadius - Depth) * normal, lying});
    }
    std::shared_ptr<const ContactModel> model;
    std::unique_ptr<ToolGaps> gaps;
    bool isMade = MakeOrganContact(organ, RadialContactMode::Nearest, model).IsOk() &&
                  model->MakeGaps(this->Shape, {}, gaps).IsOk();
    this->Spheres.resize(this->Shape.Skeleton()->Balls().size());
    for (auto& sphere : this->Spheres)
    {
      const double radius = this->Shape.Skeleton()
                                ->Balls()[static_cast<std::size_t>(&sphere - this->Spheres.data())]
                                .Radius;
      isMade = isMade && model->MakeTracker(ToolShape::Sphere(radius), {}, sphere).IsOk();
    }
    if (isMade)
    {
      this->Proxy.emplace(*this->Shape.Skeleton(), this->Shape.Skeleton()->Gyration());
      this->Proxy->Add(std::move(gaps));
    }
  }

  std::size_t Balls() const { return this->Spheres.size(); }
  void Together()
  {
    constexpr std::uint32_t Only = 0;
    this->Proxy->Begin(Outside(this->Path.front()), &Only, 1);
    for (std::size_t tick = 0; tick < Ticks; ++tick)
    {
      this->Proxy->Follow(this->Path[tick], &Only, 1);
      this->Ours[tick] = this->Proxy->Pose().PositionWorld;
    }
  }
  void Apart()
  {
    for (std::size_t n = 0; n < this->Balls(); ++n)
    {
      this->Spheres[n]->Release();
      this->Spheres[n]->Follow(this->BallOf(Outside(this->Path.front()), n));
    }
    for (std::size_t tick = 0; tick < Ticks; ++tick)
    {
      for (std::size_t n = 0; n < this->Balls(); ++n)
      {
        this->Theirs[tick] = this->Spheres[n]->Follow(this->BallOf(this->Path[tick], n)).ProxyWorld;
      }
    }
  }
  // Of one ball alone: several are not where spheres would be. The first ticks lead to the path.
  std::string Compared() const
  {
    for (std::size_t tick = 100; this->Balls() == 1 && tick < Ticks; ++tick)
    {
      if (!((this->Ours[tick] - this->Theirs[tick]).norm() < 1e-3))
      {
        return "the ball is elsewhere than the sphere in tick " + std::to_string(tick);
      }
    }
    return this->Proxy ? "" : "the tool could not be made";
  }

private:
  static ToolPose Outside(ToolPose pose)
  {
    pose.PositionWorld += 60.0 * Vector3::UnitX();
    return pose;
  }
  ToolPose BallOf(const ToolPose& pose, std::size_t n) const
  {
    return {pose.PositionWorld + pose.Orientation * this->Shape.Skeleton()->Balls()[n].Center,
            Eigen::Quaterniond::Identity()};
  }

  ToolShape Shape;
  std::vector<ToolPose> Path;
  std::optional<SharedProxy> Proxy;
  std::vector<std::unique_ptr<ContactTracker>> Spheres;
  std::vector<Vector3> Ours{Ticks};
  std::vector<Vector3> Theirs{Ticks};
};

PairedBenchmark StrokeBenchmark(const std::string& name, int degree, const ToolShape& shape)
{
  const auto stroke = std::make_shared<Stroke>(degree, shape);
  return {"touch/sh/" + name + "/degree" + std::to_string(degree),
          "spheres with trackers of their own (ours)",
          [stroke] { stroke->Together(); },
          [stroke] { stroke->Apart(); },
          [stroke] { return stroke->Compared(); },
          static_cast<double>(Ticks)};
}

ToolShape SurfaceOf500Points()
{
  const ToolShape shell = ToolShape::Ellipsoid({3.0, 4.0, 6.0}, 500);
  return ToolShape::FromSurfacePoints(shell.Points(), shell.Normals());
}
} // namespace

std::vector<PairedBenchmark> RigidToolBenchmarks()
{
  const ToolShape capsule = ToolShape::Capsule(ToolRadius, 10.0, 26);
  return {StrokeBenchmark("ball", 12, ToolShape::Capsule(ToolRadius, 0.0, 26)),
          StrokeBenchmark("capsule", 12, capsule),
          StrokeBenchmark("capsule", 20, capsule),
          StrokeBenchmark("drill", 12, ToolShape::Drill(2.5, 1.0, 40.0, 100)),
          StrokeBenchmark("ellipsoid", 12, ToolShape::Ellipsoid({2.0, 2.0, 6.0}, 100)),
          StrokeBenchmark("surface", 12, SurfaceOf500Points())};
}
} // namespace palpate::bench
