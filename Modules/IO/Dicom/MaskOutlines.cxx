#include "MaskOutlines.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

namespace palpate
{
namespace
{
// Twice a position, so that points between two pixels are whole: column, row.
using HalfPixels = std::array<int, 2>;
// From each point of an outline to the next one.
using OutlineSteps = std::map<HalfPixels, HalfPixels>;

// Adds the steps through the square between four pixel centres, the first of them at this column
// and row. Going around the corners, each run of inside ones is passed from the edge where it
// begins to the edge where it ends.
void AddSteps(const std::array<bool, 4>& isInside, int column, int row, OutlineSteps& steps)
{
  constexpr std::array<HalfPixels, 4> Edges{{{1, 0}, {2, 1}, {1, 2}, {0, 1}}}; // behind each corner
  const auto at = [&](std::size_t edge) {
    return HalfPixels{2 * column + Edges[edge][0], 2 * row + Edges[edge][1]};
  };
  for (std::size_t corner = 0; corner < 4; ++corner)
  {
    if (isInside[corner] && !isInside[(corner + 1) % 4])
    {
      std::size_t first = corner;
      while (isInside[(first + 3) % 4])
      {
        first = (first + 3) % 4;
      }
      steps[at((first + 3) % 4)] = at(corner);
    }
  }
}

OutlineSteps StepsOf(const std::vector<int>& values, int columns, int value)
{
  const int rows = static_cast<int>(values.size()) / columns;
  const auto isInside = [&](int column, int row)
  {
    return column >= 0 && column < columns && row >= 0 && row < rows &&
           values[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                  static_cast<std::size_t>(column)] == value;
  };
  OutlineSteps steps;
  const auto first = std::find(values.begin(), values.end(), value) - values.begin();
  const auto end = std::find(values.rbegin(), values.rend(), value).base() - values.begin();
  for (int row = static_cast<int>(first / columns) - 1; row < (end + columns - 1) / columns; ++row)
  {
    for (int column = -1; column < columns; ++column)
    {
      AddSteps({isInside(column, row), isInside(column + 1, row), isInside(column + 1, row + 1),
                isInside(column, row + 1)},
               column, row, steps);
    }
  }
  return steps;
}

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

// Follows the steps from the first one, and takes them away. Points within straight lines are left
// out.
PixelOutline TakeOutline(OutlineSteps& steps)
{
  PixelOutline all;
  for (auto step = steps.begin(); step != steps.end();)
  {
    all.emplace_back(step->first[0] / 2.0, step->first[1] / 2.0);
    const HalfPixels next = step->second;
    steps.erase(step);
    step = steps.find(next);
  }
  PixelOutline outline;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const Eigen::Vector2d& before = all[(i + all.size() - 1) % all.size()];
    if (Cross(all[i] - before, all[(i + 1) % all.size()] - all[i]) != 0.0)
    {
      outline.push_back(all[i]);
    }
  }
  return outline;
}

// Negative around pixels, positive around holes, by the direction of the steps.
double SignedArea(const PixelOutline& outline)
{
  double twice = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i)
  {
    twice += Cross(outline[i], outline[(i + 1) % outline.size()]);
  }
  return twice / 2.0;
}

bool Encloses(const PixelOutline& outline, const Eigen::Vector2d& point)
{
  bool isInside = false;
  for (std::size_t i = 0; i < outline.size(); ++i)
  {
    const Eigen::Vector2d& a = outline[i];
    const Eigen::Vector2d& b = outline[(i + 1) % outline.size()];
    const bool crosses = (a[1] > point[1]) != (b[1] > point[1]);
    isInside ^= crosses && point[0] < a[0] + (b[0] - a[0]) * (point[1] - a[1]) / (b[1] - a[1]);
  }
  return isInside;
}

// Joins a hole to the outline at the closest points of both.
void Join(PixelOutline& outline, PixelOutline hole)
{
  double least = std::numeric_limits<double>::max();
  std::size_t from = 0;
  std::size_t to = 0;
  for (std::size_t i = 0; i < outline.size(); ++i)
  {
    for (std::size_t j = 0; j < hole.size(); ++j)
    {
      const double distance = (outline[i] - hole[j]).squaredNorm();
      if (distance < least)
      {
        least = distance;
        from = i;
        to = j;
      }
    }
  }
  std::rotate(hole.begin(), hole.begin() + static_cast<std::ptrdiff_t>(to), hole.end());
  hole.push_back(hole.front());
  hole.push_back(outline[from]);
  outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(from) + 1, hole.begin(), hole.end());
}
} // namespace

std::optional<std::vector<PixelOutline>> MaskOutlines(const std::vector<int>& values, int columns,
                                                      int value, std::size_t most)
{
  OutlineSteps steps = StepsOf(values, columns, value);
  std::vector<PixelOutline> outlines;
  std::vector<PixelOutline> holes;
  while (!steps.empty())
  {
    if (outlines.size() + holes.size() == most)
    {
      return std::nullopt;
    }
    PixelOutline outline = TakeOutline(steps);
    (SignedArea(outline) < 0.0 ? outlines : holes).push_back(std::move(outline));
  }
  // The innermost outline around a hole is the smallest one.
  std::sort(outlines.begin(), outlines.end(),
            [](const PixelOutline& a, const PixelOutline& b)
            { return SignedArea(a) > SignedArea(b); });
  const std::vector<PixelOutline> bare = outlines;
  for (PixelOutline& hole : holes)
  {
    const auto around = std::find_if(bare.begin(), bare.end(),
                                     [&hole](const PixelOutline& outline)
                                     { return Encloses(outline, hole.front()); });
    Join(outlines[static_cast<std::size_t>(around - bare.begin())], std::move(hole));
  }
  return outlines;
}
} // namespace palpate
