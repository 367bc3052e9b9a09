#include "WedgePlaces.h"

#include "HarmonicWedge.h"
#include "IcosahedronDirections.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
// About three directions per shortest wavelength of the surface, and as many cells.
int FrequencyOf(const ParametricTouchSurface& surface)
{
  return std::max(6, surface.Model().Degree());
}

// The radius of the largest sphere up to `largest` that touches the surface from outside there and
// nowhere else, by shrinking (Ma, Bae and Choi, The Visual Computer 28, 2012). It may be too large
// by two hundredths: one that is allowed, and one that searches leave unproven, in a third of the
// time.
double RoomAbove(const ParametricTouchSurface& surface, const Vector3& parameter, double largest)
{
  constexpr int MostSpheres = 40;
  constexpr double Almost = 0.99;
  constexpr double Smaller = 0.9;
  constexpr double Proven = 0.97; // a third of the rest is left open
  const ParametricTouchSurface::Place place = surface.PlaceAt(parameter);
  double radius = largest;
  for (int sphere = 0; sphere < MostSpheres; ++sphere)
  {
    const auto nearest =
        surface.Search().Clearance(place.PointWorld + radius * place.Normal, Proven * radius);
    if (nearest.SignedDistance >= Almost * radius)
    {
      return radius;
    }
    const Vector3 across = nearest.PointWorld - place.PointWorld;
    const double rise = across.dot(place.Normal);
    const double touching = rise > 0.0 ? 0.5 * across.squaredNorm() / rise : 0.0;
    radius = std::clamp(touching, 0.5 * radius, Smaller * radius);
  }
  return 0.0;
}
} // namespace

WedgePlaces::WedgePlaces(const ParametricTouchSurface& surface, double radius, double reach)
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
// and a rim of cells.
void WedgePlaces::AddAround(const Vector3& parameter, double room)
{
  constexpr int Directions = 8;
  const Vector3 across = parameter.unitOrthogonal();
  const Vector3 other = parameter.cross(across);
  const bool isNeeded = room < this->Radius || !(room > 0.0);
  const auto add = [&](const Vector3& place, Mark mark)
  {
    Cell& cell = this->Cells[this->CellOf(place)];
    cell.Need = isNeeded ? std::max(cell.Need, mark) : cell.Need;
    cell.Room = mark == Needed ? std::min(cell.Room, static_cast<float>(room)) : cell.Room;
  };
  add(parameter, Needed);
  for (const auto& [distance, mark] :
       {std::pair(0.8, Needed), std::pair(1.6, Needed), std::pair(2.6, Rim)})
  {
    for (int n = 0; n < Directions; ++n)
    {
      const double turn = 2.0 * M_PI * n / Directions;
      const Vector3 aside = std::cos(turn) * across + std::sin(turn) * other;
      add(parameter + std::tan(distance / this->Frequency) * aside, mark);
    }
  }
}

// Where the tool hardly fits, hollows between the places that were tested may be narrower: there
// places twice as close are tested too.
void WedgePlaces::AddHollows(const ParametricTouchSurface& surface)
{
  constexpr double Close = 1.2; // of the tool
  this->AddHollows(surface, this->Frequency, {0.0, std::numeric_limits<double>::infinity()});
  this->AddHollows(surface, 2 * this->Frequency, {this->Radius, Close * this->Radius});
}

// Of the places with so much room up to now.
void WedgePlaces::AddHollows(const ParametricTouchSurface& surface, int frequency,
                             const std::pair<double, double>& known)
{
  constexpr double Larger = 1.1;
  const IcosahedronDirections sphere(frequency);
  for (const Vector3& parameter : sphere.Directions())
  {
    const double before = this->RoomAt(parameter);
    if (!(before > known.first && before < known.second))
    {
      continue;
    }
    const double room = RoomAbove(surface, parameter, Larger * this->Largest) / Larger;
    if (room < (1.0 - 1e-9) * this->Largest)
    {
      this->AddAround(parameter, room);
    }
  }
}

// A tool that touches both sheets next to a crossing is up to some radii away from it, since they
// meet at any angle.
void WedgePlaces::AddCrossings(const ParametricTouchSurface& surface, double radius)
{
  const std::vector<Vector3>& crossings = surface.CrossingsWorld();
  if (crossings.empty())
  {
    return;
  }
  // Of a surface that crosses itself nearly everywhere not all places are known.
  const double reach = crossings.size() < ParametricTouchSurface::MostCrossings
                           ? 4.0 * radius + 0.25 * surface.SmallestRadius()
                           : std::numeric_limits<double>::infinity();
  const IcosahedronDirections sphere(2 * this->Frequency);
  for (const Vector3& parameter : sphere.Directions())
  {
    const Vector3 place = surface.PlaceAt(parameter).PointWorld;
    if (std::any_of(crossings.begin(), crossings.end(),
                    [&](const Vector3& crossing)
                    { return (crossing - place).squaredNorm() < reach * reach; }))
    {
      this->AddAround(parameter, 0.0);
    }
  }
}
} // namespace palpate
