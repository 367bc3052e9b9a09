#include "StructureStroke.h"

#include "ManyStructures.h"
#include "OrganContact.h"
#include "RandomShapes.h"

#include <stdexcept>

namespace palpate::bench
{
namespace
{
constexpr double Apart = 60.0;      // mm
constexpr double StrokeStep = 0.05; // mm per tick: 50 mm/s at 1 kHz
constexpr double StrokeDepth = 1.5; // mm

RadialModel OrganAtOrigin()
{
  test::Random random(12);
  const RadialModel organ = test::RandomOrgan(random, 12);
  return {organ.Degree(), organ.Coefficients(), Vector3::Zero()};
}

std::vector<Vector3> StrokeOverStructures(const RadialModel& organ, double toolRadius)
{
  std::vector<Vector3> path;
  Vector3 u = Vector3::UnitX();
  const Eigen::AngleAxisd turn(StrokeStep / 20.0, Vector3(0.2, 0.3, 1.0).normalized());
  while (path.size() < StructureTicks)
  {
    path.push_back(organ.PointWorld(u) + (toolRadius - StrokeDepth) * organ.Normal(u));
    u = (turn * u).normalized();
  }
  return path;
}

std::shared_ptr<const TouchScene> StrokeSceneOf(int count)
{
  auto scene = std::make_shared<TouchScene>(test::ManyStructures(count, Apart));
  const auto organ = std::make_shared<const RadialModel>(OrganAtOrigin());
  const Status status =
      MakeOrganContact(organ, RadialContactMode::Nearest, scene->Structures.front().Model);
  if (!status.IsOk())
  {
    throw std::runtime_error(status.Message());
  }
  return scene;
}
} // namespace

std::unique_ptr<ServoStroke> StructureStroke(int count)
{
  const std::shared_ptr<const TouchScene> scene = StrokeSceneOf(count);
  return std::make_unique<ServoStroke>(scene,
                                       StrokeOverStructures(OrganAtOrigin(), scene->Tool.Radius()));
}
} // namespace palpate::bench
