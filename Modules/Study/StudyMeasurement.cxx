#include "StudyMeasurement.h"

#include "DecimalText.h"
#include "PointMeasures.h"

#include <array>
#include <cmath>
#include <tuple>

namespace palpate
{
namespace
{
struct KindFacts
{
  const char* Name;
  const char* Unit;
  std::size_t Points;
};

// In the order of MeasurementKind.
constexpr std::array<KindFacts, MeasurementKindCount> KindTable{
    {{"Line", "mm", 2},
     {"Angle", "deg", 3},
     {"Curve", "mm", 0},
     {"Curve along a surface", "mm", 0},
     {"Plane", "", 3},
     {"Distance of structures", "mm", 2},
     {"Thickness", "mm", 2}}};

const KindFacts& FactsOf(MeasurementKind kind)
{
  return KindTable.at(static_cast<std::size_t>(kind));
}

auto Fields(const StudyMeasurement& m)
{
  return std::tie(m.Kind, m.Name, m.PointsWorld, m.PathWorld, m.PathLength, m.StructureId,
                  m.IsOpen);
}

Vector3 MeanOf(const std::vector<Vector3>& points)
{
  Vector3 sum = Vector3::Zero();
  for (const Vector3& point : points)
  {
    sum += point;
  }
  return sum / static_cast<double>(points.size());
}
} // namespace

bool operator==(const StudyMeasurement& a, const StudyMeasurement& b)
{
  return Fields(a) == Fields(b);
}

const char* NameOf(MeasurementKind kind)
{
  return FactsOf(kind).Name;
}

const char* UnitOf(MeasurementKind kind)
{
  return FactsOf(kind).Unit;
}

std::size_t PointCountOf(MeasurementKind kind)
{
  return FactsOf(kind).Points;
}

bool HasValidPoints(const StudyMeasurement& measurement)
{
  const std::size_t count = measurement.PointsWorld.size();
  const std::size_t wanted = PointCountOf(measurement.Kind);
  if (measurement.IsOpen)
  {
    return count >= 1 && (wanted == 0 || count < wanted);
  }
  return wanted == 0 ? count >= 2 : count == wanted;
}

std::optional<double> ValueOf(const StudyMeasurement& measurement)
{
  const std::vector<Vector3>& points = measurement.PointsWorld;
  switch (measurement.Kind)
  {
  case MeasurementKind::Plane:
    return std::nullopt;
  case MeasurementKind::Angle:
    return points.size() < 3
               ? std::nullopt
               : std::optional(180.0 / M_PI * AngleAt(points[1], points[0], points[2]));
  default:
    return points.size() < 2              ? std::nullopt
           : measurement.PathLength > 0.0 ? std::optional(measurement.PathLength)
                                          : std::optional(PolylineLength(measurement.Line()));
  }
}

std::string ValueText(const StudyMeasurement& measurement, LengthUnit unit)
{
  const std::optional<double> value = ValueOf(measurement);
  if (!value)
  {
    return {};
  }
  const bool isAngle = measurement.Kind == MeasurementKind::Angle;
  return isAngle ? FixedText(*value, 1) + "\u00B0" : LengthText(unit, *value, 1);
}

Vector3 LabelPlaceOf(const StudyMeasurement& measurement)
{
  const std::vector<Vector3>& points = measurement.PointsWorld;
  switch (measurement.Kind)
  {
  case MeasurementKind::Plane:
    return MeanOf(points);
  case MeasurementKind::Angle:
    return points.size() < 3 ? points.back() : points[1];
  default:
    return PolylineMiddle(measurement.Line());
  }
}
} // namespace palpate
