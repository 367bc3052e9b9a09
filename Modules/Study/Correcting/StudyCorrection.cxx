#include "StudyCorrection.h"

#include <algorithm>
#include <tuple>

namespace palpate
{
namespace
{
auto Fields(const StudyCorrection& c)
{
  return std::tie(c.StructureId, c.Steps, c.Neighbors);
}

struct StepTitle
{
  std::string operator()(const SurfacePull& /*pull*/) const { return "Pull the surface"; }
  std::string operator()(const IslandRemoval& /*removal*/) const { return "Remove islands"; }
  std::string operator()(const CavityFilling& /*filling*/) const { return "Fill cavities"; }
  std::string operator()(const SurfaceSmoothing& /*smoothing*/) const
  {
    return "Smooth the surface";
  }
  std::string operator()(const PlaneCut& /*cut*/) const { return "Cut at a plane"; }
};
} // namespace

bool operator==(const StudyCorrection& a, const StudyCorrection& b)
{
  return Fields(a) == Fields(b);
}

SurfacePull PullAt(const PullWidth& width, const Vector3& placeWorld)
{
  SurfacePull pull;
  pull.PlaceWorld = placeWorld;
  pull.Width = std::clamp(width.Width, PullWidth::Least, PullWidth::Largest);
  pull.SecondWidth = width.HasTwo ? PullWidth::Second * pull.Width : 0.0;
  return pull;
}

std::optional<double> OffsetOnNormal(const Vector3& place, const Vector3& normal,
                                     const Vector3& from, const Vector3& to)
{
  constexpr double LeastSine = 0.42; // of 25 degrees
  const Vector3 sight = (to - from).normalized();
  const double along = normal.dot(sight);
  const double square = 1.0 - along * along;
  if (!(square > LeastSine * LeastSine))
  {
    return std::nullopt;
  }
  const Vector3 apart = place - from;
  return (along * sight.dot(apart) - normal.dot(apart)) / square;
}

std::string NameOf(const CorrectionStep& step)
{
  return std::visit(StepTitle(), step);
}
} // namespace palpate
