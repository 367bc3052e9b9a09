#include "ModelEvaluation.h"

#include "InputError.h"
#include "ModelMeasures.h"
#include "TouchableSurfaceModel.h"

#include <cmath>
#include <memory>

namespace palpate::cli
{
namespace
{
ModelEvaluation::PointSample SamplePoint(const RadialModel& model, const Vector3& point)
{
  const Vector3 arm = point - model.CenterWorld();
  const double distance = arm.norm();
  const double radius =
      model.Radius(distance > 0.0 ? Vector3(arm / distance) : Vector3(Vector3::UnitZ()));
  return {point, distance <= radius, distance - radius, radius};
}

void Evaluate(const RadialModel& model, const std::vector<Vector3>& directions,
              const std::vector<Vector3>& pointsWorld, ModelEvaluation& result)
{
  result.IsRadial = true;
  result.CenterWorld = model.CenterWorld();
  result.Volume = VolumeOf(model);
  result.Area = AreaOf(model);
  result.Power = model.PowerSpectrum();
  for (const Vector3& u : directions)
  {
    const RadialModel::Sample sample = model.Evaluate(u);
    result.Directions.push_back(
        {u, sample.Radius, sample.SurfaceGradient, model.PointWorld(u), model.Normal(u)});
  }
  for (const Vector3& point : pointsWorld)
  {
    result.Points.push_back(SamplePoint(model, point));
  }
}

void SamplePoints(const SurfaceModel& surface, const std::vector<Vector3>& pointsWorld,
                  ModelEvaluation& result)
{
  std::shared_ptr<const TouchableSurfaceModel> touch;
  if (const Status status = TouchableSurfaceModel::Make(surface, touch); !status.IsOk())
  {
    throw InputError(result.File + ": " + status.Message());
  }
  for (const Vector3& point : pointsWorld)
  {
    const TouchableSurfaceModel::ClosestPoint nearest = touch->Search().Nearest(point);
    const double distance = std::abs(nearest.SignedDistance);
    const bool isInside = !touch->IsOutside(point, nearest);
    result.Points.push_back({point, isInside, isInside ? -distance : distance, std::nullopt});
  }
}

void Evaluate(const SurfaceModel& surface, const std::vector<Vector3>& directions,
              const std::vector<Vector3>& pointsWorld, ModelEvaluation& result)
{
  const double volume = surface.Volume();
  result.InsideOut = volume < 0.0;
  result.Volume = std::abs(volume);
  result.Area = surface.Area();
  result.Power = surface.PowerSpectrum();
  const double side = result.InsideOut ? -1.0 : 1.0;
  for (const Vector3& u : directions)
  {
    result.Directions.push_back(
        {u, std::nullopt, std::nullopt, surface.Point(u), side * surface.Normal(u)});
  }
  if (!pointsWorld.empty())
  {
    SamplePoints(surface, pointsWorld, result);
  }
}
} // namespace

ModelEvaluation EvaluateModel(const std::string& file, const OrganModel& surface,
                              const std::vector<Vector3>& directions,
                              const std::vector<Vector3>& pointsWorld)
{
  ModelEvaluation result;
  result.File = file;
  std::visit(
      [&](const auto& s)
      {
        result.Degree = s.Degree();
        Evaluate(s, directions, pointsWorld, result);
      },
      surface);
  return result;
}
} // namespace palpate::cli
