#include "WedgePlaces.h"

#include "IcosahedronDirections.h"
#include "TangentSphere.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
// About nine directions per shortest wavelength of the surface, up to degree 40, and as many cells:
// a hollow's edge is known to a small part of a tool's radius, so that few places next to it need
// the wedge.
int FrequencyOf(const TouchableSurfaceModel& surface)
{
  constexpr int Most = 120;
  return std::min(3 * std::max(6, surface.Model().Degree()), Most);
}

// Places between those that are tested have less room. To know a tool's room matters more than
// whether it fits, since free motion relies on it.
constexpr double LargerTool = 1.05;
constexpr double LargerRoom = 1.1;
} // namespace

WedgePlaces::WedgePlaces(const TouchableSurfaceModel& surface, double radius, double reach)
    : Frequency(FrequencyOf(surface)), Radius(radius), Largest(radius + reach),
      Cells(6 * static_cast<std::size_t>(Frequency * Frequency),
            Cell{Fits, static_cast<float>(Largest)})
{
  this->AddCrossings(surface, radius + surface.Margin());
  this->AddHollows(surface);
}

bool WedgePlaces::IsEmpty() const noexcept
{
  return std::all_of(this->Cells.begin(), this->Cells.end(),
                     [](const Cell& cell) { return cell.Need == Fits; });
}

std::size_t WedgePlaces::CellOf(const Vector3& parameter) const noexcept
{
  int axis = 0;
  const double longest = parameter.cwiseAbs().maxCoeff(&axis);
  const int side = 2 * axis + (parameter[axis] < 0.0 ? 1 : 0);
  const auto along = [&](int other)
  {
    const double at = 0.5 * (parameter[other] / longest + 1.0) * this->Frequency;
    return std::clamp(static_cast<int>(at), 0, this->Frequency - 1);
  };
  const int cell =
      (side * this->Frequency + along((axis + 1) % 3)) * this->Frequency + along((axis + 2) % 3);
  return static_cast<std::size_t>(cell);
}

// The cells of a parameter and of those around it, as far as the next directions that are tested,
// and a rim of cells. `free` (mm) is the radius of the largest sphere that touches only there, 0
// without any, as next to a crossing; `width` is the distance of these directions, rad.
void WedgePlaces::AddAround(const Vector3& parameter, double free, double width)
{
  constexpr int Directions = 8;
  const Vector3 across = parameter.unitOrthogonal();
  const Vector3 other = parameter.cross(across);
  const bool isNeeded = free < LargerTool * this->Radius || !(free > 0.0);
  const auto room = static_cast<float>(free / LargerRoom);
  const auto add = [&](const Vector3& place, Mark mark, bool isNear)
  {
    Cell& cell = this->Cells[this->CellOf(place)];
    cell.Need = isNeeded ? std::max(cell.Need, mark) : cell.Need;
    cell.Room = isNear ? std::min(cell.Room, room) : cell.Room;
  };
  add(parameter, Needed, true);
  const auto addRing = [&](double distance, Mark mark, bool isNear)
  {
    for (int n = 0; n < Directions; ++n)
    {
      const double turn = 2.0 * M_PI * n / Directions;
      const Vector3 aside = std::cos(turn) * across + std::sin(turn) * other;
      add(parameter + std::tan(distance * width) * aside, mark, isNear);
    }
  };
  addRing(0.8, Needed, true);
  addRing(1.6, free > 0.0 ? Rim : Needed, true);
  if (!(free > 0.0))
  {
    addRing(2.6, Rim, false);
  }
}

void WedgePlaces::AddHollows(const TouchableSurfaceModel& surface)
{
  const double most = LargerRoom * this->Largest;
  const IcosahedronDirections sphere(this->Frequency);
  for (const Vector3& parameter : sphere.Directions())
  {
    if (!(this->RoomAt(parameter) > 0.0))
    {
      continue; // next to a crossing
    }
    const auto sample = surface.Model().EvaluateSecondOrder(parameter);
    const double free = LargestTangentSphere(surface.Search(), sample, NormalOf(sample), most);
    if (free < (1.0 - 1e-9) * most)
    {
      this->AddAround(parameter, free, 1.0 / this->Frequency);
    }
  }
}

// A tool that touches both sheets next to a crossing is up to some radii away from it, since they
// meet at any angle.
void WedgePlaces::AddCrossings(const TouchableSurfaceModel& surface, double radius)
{
  const std::vector<Vector3>& crossings = surface.CrossingsWorld();
  if (crossings.empty())
  {
    return;
  }
  // Of a surface that crosses itself nearly everywhere not all places are known.
  const double reach = crossings.size() < TouchableSurfaceModel::MostCrossings
                           ? 4.0 * radius + 0.25 * surface.SmallestRadius()
                           : std::numeric_limits<double>::infinity();
  // Wider, since a tessellation knows crossings as finely as its triangles.
  const double width = 3.0 / this->Frequency;
  const IcosahedronDirections sphere(this->Frequency);
  for (const Vector3& parameter : sphere.Directions())
  {
    const Vector3 place = surface.PlaceAt(parameter).PointWorld;
    if (std::any_of(crossings.begin(), crossings.end(),
                    [&](const Vector3& crossing)
                    { return (crossing - place).squaredNorm() < reach * reach; }))
    {
      this->AddAround(parameter, 0.0, width);
    }
  }
}
} // namespace palpate
