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
} // namespace

WedgePlaces::WedgePlaces(const ParametricTouchSurface& surface, double radius)
    : Frequency(FrequencyOf(surface)),
      Cells(6 * static_cast<std::size_t>(Frequency * Frequency), Fits)
{
  this->AddHollows(surface, radius);
  this->AddCrossings(surface, radius + surface.Margin());
}

bool WedgePlaces::IsEmpty() const noexcept
{
  return std::all_of(this->Cells.begin(), this->Cells.end(),
                     [](Cell cell) { return cell == Fits; });
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
void WedgePlaces::AddAround(const Vector3& parameter)
{
  constexpr int Directions = 8;
  const Vector3 across = parameter.unitOrthogonal();
  const Vector3 other = parameter.cross(across);
  this->Cells[this->CellOf(parameter)] = Needed;
  for (const auto& [distance, mark] :
       {std::pair(0.8, Needed), std::pair(1.6, Needed), std::pair(2.6, Rim)})
  {
    for (int n = 0; n < Directions; ++n)
    {
      const double turn = 2.0 * M_PI * n / Directions;
      const Vector3 aside = std::cos(turn) * across + std::sin(turn) * other;
      Cell& cell =
          this->Cells[this->CellOf(parameter + std::tan(distance / this->Frequency) * aside)];
      cell = std::max(cell, mark);
    }
  }
}

void WedgePlaces::AddHollows(const ParametricTouchSurface& surface, double radius)
{
  const IcosahedronDirections sphere(this->Frequency);
  for (const Vector3& parameter : sphere.Directions())
  {
    if (HarmonicWedgeOf<ParametricTouchSurface>::IsNeededAt(surface, parameter, radius))
    {
      this->AddAround(parameter);
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
      this->AddAround(parameter);
    }
  }
}
} // namespace palpate
