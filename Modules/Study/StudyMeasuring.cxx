#include "StudyMeasuring.h"

#include "PointMeasures.h"

#include <algorithm>

namespace palpate
{
namespace
{
bool NeedsSurface(MeasurementKind kind)
{
  return kind == MeasurementKind::SurfaceCurve || kind == MeasurementKind::Gap ||
         kind == MeasurementKind::Thickness;
}

Status PlaceOnSurface(const StudyMeasurement& measurement, const PlacedPoint& point,
                      MeasuredSurfaces& surfaces, MeasuredSurfaces::Place& place)
{
  // A curve stays on the surface where it began.
  const bool isBound =
      measurement.Kind == MeasurementKind::SurfaceCurve && measurement.StructureId != 0;
  const auto nearest = surfaces.Nearest(point.PointWorld, FarthestPlacing,
                                        isBound ? measurement.StructureId : point.StructureId);
  if (!nearest)
  {
    return Status::Failure(
        isBound ? "The curve's surface is more than 10 mm away: place the point on it."
                : "No surface is within 10 mm: place the point on a structure that is displayed as "
                  "its model or its surface.");
  }
  place = *nearest;
  return Status::Success();
}

Status ExtendPath(StudyMeasurement& curve, const Vector3& place, MeasuredSurfaces& surfaces,
                  MeasuredSurfaces::PathOn on)
{
  SurfacePaths::Path part;
  const Status status =
      surfaces.FindPath(curve.StructureId, curve.PointsWorld.back(), place, on, part);
  if (status.IsOk())
  {
    const bool hasLength = curve.PathLength > 0.0 || curve.PathWorld.empty();
    curve.PathLength =
        (hasLength ? curve.PathLength : PolylineLength(curve.PathWorld)) + part.Length;
    const std::size_t shared = curve.PathWorld.empty() ? 0 : 1;
    curve.PathWorld.insert(curve.PathWorld.end(),
                           part.Points.begin() + static_cast<std::ptrdiff_t>(shared),
                           part.Points.end());
    curve.PointsWorld.push_back(place);
  }
  return status;
}

Status MeasureGap(StudyMeasurement& measurement, int other, MeasuredSurfaces& surfaces)
{
  if (other == measurement.StructureId)
  {
    return Status::Failure("The distance is that of two structures: place the second point on "
                           "another one.");
  }
  MeshGap gap;
  const Status status = surfaces.FindGap(measurement.StructureId, other, gap);
  if (status.IsOk())
  {
    measurement.PointsWorld = {gap.PointOfOne, gap.PointOfOther};
  }
  return status;
}

Status AddOnSurface(StudyMeasurement& measurement, const MeasuredSurfaces::Place& place,
                    MeasuredSurfaces& surfaces, MeasuredSurfaces::PathOn on)
{
  if (measurement.PointsWorld.empty())
  {
    measurement.StructureId = place.StructureId;
  }
  if (measurement.Kind == MeasurementKind::Thickness)
  {
    WallThickness wall;
    const Status status = surfaces.FindThickness(place.StructureId, place.PointWorld, wall);
    measurement.PointsWorld = {wall.PointOnSurface, wall.OppositePoint};
    return status;
  }
  if (measurement.PointsWorld.empty())
  {
    measurement.PointsWorld = {place.PointWorld};
    return Status::Success();
  }
  return measurement.Kind == MeasurementKind::Gap
             ? MeasureGap(measurement, place.StructureId, surfaces)
             : ExtendPath(measurement, place.PointWorld, surfaces, on);
}

std::string StructureName(const StudyState& state, int id)
{
  const auto found = std::find_if(state.Structures.begin(), state.Structures.end(),
                                  [id](const SceneStructure& one) { return one.Id == id; });
  const bool isNamed = found != state.Structures.end() && !found->Name.empty();
  return isNamed ? found->Name : "label " + std::to_string(id);
}

std::string BaseName(const StudyState& state, const StudyMeasurement& measurement)
{
  const std::string structure = StructureName(state, measurement.StructureId);
  switch (measurement.Kind)
  {
  case MeasurementKind::SurfaceCurve:
    return "Curve on " + structure;
  case MeasurementKind::Gap:
    return "Distance from " + structure;
  case MeasurementKind::Thickness:
    return "Thickness of " + structure;
  default:
    return NameOf(measurement.Kind);
  }
}

std::string FreeName(const StudyState& state, const StudyMeasurement& measurement)
{
  const std::string base =
      BaseName(state, measurement) + (NeedsSurface(measurement.Kind) ? ", " : " ");
  int number = 1;
  const auto isUsed = [&](const StudyMeasurement& one)
  { return one.Name == base + std::to_string(number); };
  while (std::any_of(state.Measurements.begin(), state.Measurements.end(), isUsed))
  {
    ++number;
  }
  return base + std::to_string(number);
}
} // namespace

const StudyMeasurement* OpenMeasurement(const StudyState& state)
{
  const auto found = std::find_if(state.Measurements.begin(), state.Measurements.end(),
                                  [](const StudyMeasurement& one) { return one.IsOpen; });
  return found != state.Measurements.end() ? &*found : nullptr;
}

Status AddPoint(StudyMeasurement& measurement, const PlacedPoint& point, MeasuredSurfaces& surfaces,
                MeasuredSurfaces::PathOn on)
{
  StudyMeasurement next = measurement;
  Status status = Status::Success();
  if (NeedsSurface(next.Kind))
  {
    MeasuredSurfaces::Place place;
    status = PlaceOnSurface(next, point, surfaces, place);
    status = status.IsOk() ? AddOnSurface(next, place, surfaces, on) : status;
  }
  else
  {
    next.PointsWorld.push_back(point.PointWorld);
  }
  if (status.IsOk())
  {
    next.IsOpen = next.PointsWorld.size() != PointCountOf(next.Kind);
    measurement = std::move(next);
  }
  return status;
}

Status AddPoint(StudyState& state, MeasurementKind kind, const PlacedPoint& point,
                MeasuredSurfaces& surfaces)
{
  const StudyMeasurement* open = OpenMeasurement(state);
  StudyMeasurement next;
  next.Kind = kind;
  const bool continues = open != nullptr && open->Kind == kind;
  next = continues ? *open : next;
  const Status status = AddPoint(next, point, surfaces, MeasuredSurfaces::PathOn::Model);
  if (!status.IsOk())
  {
    return status;
  }
  if (continues)
  {
    state.Measurements[static_cast<std::size_t>(open - state.Measurements.data())] = next;
  }
  else
  {
    EndMeasurement(state);
    next.Name = FreeName(state, next);
    state.Measurements.push_back(next);
  }
  return status;
}

bool EndMeasurement(StudyState& state)
{
  auto& all = state.Measurements;
  const auto open =
      std::find_if(all.begin(), all.end(), [](const StudyMeasurement& one) { return one.IsOpen; });
  if (open == all.end())
  {
    return false;
  }
  open->IsOpen = false;
  if (!HasValidPoints(*open))
  {
    all.erase(open);
  }
  return true;
}
} // namespace palpate
