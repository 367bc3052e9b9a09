#include "FieldVolume.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
// Corners of a cube: bit 0 is i, 1 is j, 2 is k. The paths of axes from corner 0 to corner 7.
constexpr std::array<std::array<std::size_t, 2>, 6> Paths{
    {{1, 3}, {1, 5}, {2, 3}, {2, 6}, {4, 5}, {4, 6}}};

// The part of an edge from a value above zero to one that is not.
float PartAbove(float above, float below)
{
  return above / (above - below);
}

// The part of a tetrahedron with one corner above zero.
float Tip(float above, float a, float b, float c)
{
  return PartAbove(above, a) * PartAbove(above, b) * PartAbove(above, c);
}

// With a and b above zero, c and d not.
float Wedge(float a, float b, float c, float d)
{
  const float ac = PartAbove(a, c);
  const float ad = PartAbove(a, d);
  const float bd = PartAbove(b, d);
  return ac * ad + ac * bd * (1.0f - ad) + (1.0f - ac) * PartAbove(b, c) * bd;
}

// The part of a tetrahedron above zero.
float PartAbove(std::array<float, 4> v)
{
  const auto order = [&v](std::size_t a, std::size_t b)
  {
    const float high = std::max(v[a], v[b]);
    v[b] = std::min(v[a], v[b]);
    v[a] = high;
  };
  order(0, 1);
  order(2, 3);
  order(0, 2);
  order(1, 3);
  order(1, 2);
  if (v[3] > 0.0f || !(v[0] > 0.0f))
  {
    return v[3] > 0.0f ? 1.0f : 0.0f;
  }
  if (v[1] > 0.0f)
  {
    return v[2] > 0.0f ? 1.0f - Tip(-v[3], -v[0], -v[1], -v[2]) : Wedge(v[0], v[1], v[2], v[3]);
  }
  return Tip(v[0], v[1], v[2], v[3]);
}

// The part above a level of a cube.
class CubeVolume
{
public:
  CubeVolume(const ShapeField& field, float level)
      : Field(&field), Level(level), Row(field.Grid.Offset(0, 1, 0)),
        Slice(field.Grid.Offset(0, 0, 1))
  {
  }

  // Of the cube whose lowest corner is node `at`.
  float operator()(std::size_t at) const
  {
    std::array<float, 8> corner{};
    for (std::size_t c = 0; c < corner.size(); ++c)
    {
      corner[c] = this->Field->Values[at + this->CornerOffset(c)] - this->Level;
    }
    float sum = 0.0f;
    for (const std::array<std::size_t, 2>& path : Paths)
    {
      sum += PartAbove({corner[0], corner[path[0]], corner[path[1]], corner[7]});
    }
    return sum / 6.0f;
  }

  std::size_t CornerOffset(std::size_t corner) const
  {
    return (corner & 1) + (corner >> 1 & 1) * this->Row + (corner >> 2) * this->Slice;
  }

private:
  const ShapeField* Field;
  float Level;
  std::size_t Row;
  std::size_t Slice;
};

class CubeVolumes
{
public:
  CubeVolumes(const ShapeField& field, float level)
      : Field(&field), Cube(field, level), Above(field.Values.size())
  {
    std::transform(field.Values.begin(), field.Values.end(), this->Above.begin(),
                   [level](float value) -> unsigned char { return value > level ? 1 : 0; });
  }

  // In cubes.
  double Sum() const
  {
    const ShapeGrid& grid = this->Field->Grid;
    double sum = 0.0;
    for (int k = 0; k + 1 < grid.Size[2]; ++k)
    {
      for (int j = 0; j + 1 < grid.Size[1]; ++j)
      {
        sum += this->SumRow(grid.Offset(0, j, k), static_cast<std::size_t>(grid.Size[0]) - 1);
      }
    }
    return sum;
  }

private:
  double SumRow(std::size_t first, std::size_t count) const
  {
    double sum = 0.0;
    unsigned column = this->Column(first);
    for (std::size_t at = first; at < first + count; ++at)
    {
      const unsigned next = this->Column(at + 1);
      const unsigned corners = column + next;
      column = next;
      sum += corners == 0 ? 0.0 : corners == 8 ? 1.0 : this->Cube(at);
    }
    return sum;
  }

  // Corners above the level on one side of a cube.
  unsigned Column(std::size_t at) const
  {
    const std::size_t row = this->Cube.CornerOffset(2);
    const std::size_t slice = this->Cube.CornerOffset(4);
    return static_cast<unsigned>(this->Above[at]) + this->Above[at + row] +
           this->Above[at + slice] + this->Above[at + slice + row];
  }

  const ShapeField* Field;
  CubeVolume Cube;
  std::vector<unsigned char> Above;
};

// A level and the volume above it.
struct LevelVolume
{
  double Level;
  double Volume;
};
} // namespace

double VolumeAbove(const ShapeField& field, float level)
{
  return CubeVolumes(field, level).Sum() * field.Grid.CellVolume();
}

double VolumeAround(const ShapeField& field, const std::vector<std::size_t>& nodes,
                    std::vector<unsigned char>& marks)
{
  const CubeVolume cube(field, 0.0f);
  std::vector<std::size_t> cubes; // by their lowest corners
  double sum = 0.0;
  for (const std::size_t node : nodes)
  {
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      const std::size_t at = node - cube.CornerOffset(corner);
      if (marks[at] == 0)
      {
        marks[at] = 1;
        cubes.push_back(at);
        sum += cube(at);
      }
    }
  }
  for (const std::size_t at : cubes)
  {
    marks[at] = 0;
  }
  return sum * field.Grid.CellVolume();
}

double FindLevel(const LevelSearch& search, const std::function<double(double level)>& volumeAbove)
{
  LevelVolume low{search.Lowest, std::numeric_limits<double>::infinity()};
  LevelVolume high{search.Highest, 0.0};
  LevelVolume best{0.0, std::numeric_limits<double>::infinity()};
  LevelVolume before{0.0, 0.0};
  double slope = -std::max(search.Area, std::numeric_limits<double>::min());
  double level = 0.0;
  for (int step = 0; step < search.MaximumSteps; ++step)
  {
    const LevelVolume at{level, volumeAbove(level)};
    const double excess = at.Volume - search.Volume;
    if (std::abs(excess) < std::abs(best.Volume - search.Volume))
    {
      best = at;
    }
    if (std::abs(best.Volume - search.Volume) <= search.Tolerance * search.Volume)
    {
      break;
    }
    (excess > 0.0 ? low : high) = at;
    if (step > 0 && at.Volume != before.Volume)
    {
      slope = (at.Volume - before.Volume) / (at.Level - before.Level);
    }
    before = at;
    const double secant = at.Level - excess / slope;
    // Where many nodes have nearly the same value the secant stalls; halving does not.
    const bool isSafe = step % 3 != 2 && secant > low.Level && secant < high.Level;
    level = isSafe ? secant : 0.5 * (low.Level + high.Level);
  }
  return best.Level;
}

float LevelOfVolume(const ShapeField& field, double volume, double area)
{
  const auto [lowest, highest] = std::minmax_element(field.Values.begin(), field.Values.end());
  LevelSearch search;
  search.Lowest = *lowest;
  search.Highest = *highest;
  search.Volume = volume;
  search.Area = area;
  return static_cast<float>(FindLevel(search, [&field](double level)
                                      { return VolumeAbove(field, static_cast<float>(level)); }));
}
} // namespace palpate
