#include "Calibre.h"

#include "EdgeRings.h"
#include "LevelLoops.h"
#include "MeshSheets.h"
#include "SurfaceTopology.h"
#include "TubeAxis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace palpate
{
namespace
{
constexpr double SectionsPerDiameter = 4.0;
constexpr double BranchPart = 0.3;   // of the larger curve
constexpr double BranchLength = 0.6; // of the mean diameter
constexpr double VolumeSlack = 0.2;

std::string ShortText(double number)
{
  std::array<char, 32> text{};
  (void)std::snprintf(text.data(), text.size(), "%.1f", number);
  return text.data();
}

// The triangles of the sheet with most of them.
IndexedMesh LargestSheet(const IndexedMesh& mesh)
{
  const MeshSheets sheets(mesh, EdgeRings(mesh));
  std::vector<int> counts(static_cast<std::size_t>(sheets.SheetCount), 0);
  for (const int sheet : sheets.SheetOf)
  {
    counts[static_cast<std::size_t>(std::max(0, sheet))] += sheet >= 0 ? 1 : 0;
  }
  const auto most =
      static_cast<int>(std::max_element(counts.begin(), counts.end()) - counts.begin());
  IndexedMesh largest;
  largest.Points = mesh.Points;
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    if (sheets.SheetOf[t] == most)
    {
      largest.Triangles.push_back(mesh.Triangles[t]);
    }
  }
  return largest;
}

// Distances along edges from a point: Dijkstra's algorithm. Points elsewhere are at 0.
class EdgeDistances
{
public:
  explicit EdgeDistances(const IndexedMesh& mesh) : Mesh(mesh), Neighbours(mesh.Points.size())
  {
    for (const std::array<int, 3>& t : mesh.Triangles)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        this->Neighbours[t[k]].push_back(t[(k + 1) % 3]);
      }
    }
  }

  std::vector<double> From(int start) const
  {
    constexpr double Far = std::numeric_limits<double>::infinity();
    std::vector<double> distances(this->Mesh.Points.size(), Far);
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    distances[start] = 0.0;
    queue.emplace(0.0, start);
    while (!queue.empty())
    {
      const auto [distance, at] = queue.top();
      queue.pop();
      for (const int next : this->Neighbours[at])
      {
        const double by = distance + (this->Mesh.Points[next] - this->Mesh.Points[at]).norm();
        if (distance <= distances[at] && by < distances[next])
        {
          distances[next] = by;
          queue.emplace(by, next);
        }
      }
    }
    for (double& distance : distances)
    {
      distance = std::isfinite(distance) ? distance : 0.0;
    }
    return distances;
  }

private:
  const IndexedMesh& Mesh;
  std::vector<std::vector<int>> Neighbours;
};

int FarthestOf(const std::vector<double>& distances)
{
  return static_cast<int>(std::max_element(distances.begin(), distances.end()) - distances.begin());
}

// The centre of the longest curve at each level of the distance from an end.
struct FirstAxis
{
  std::vector<Vector3> Centers;
  double Double = 0.0; // mm along which there are two curves of like length
};

Vector3 MeanOf(const Loop& loop)
{
  Vector3 mean = Vector3::Zero();
  double whole = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Vector3& next = loop[(i + 1) % loop.size()];
    const double length = (next - loop[i]).norm();
    mean += 0.5 * length * (loop[i] + next);
    whole += length;
  }
  return whole > 0.0 ? Vector3(mean / whole) : loop.front();
}

FirstAxis AxisOfLevels(const IndexedMesh& mesh, const std::vector<double>& distances, double from,
                       double to, double step)
{
  FirstAxis axis;
  double isDouble = 0.0;
  for (double level = from; level <= to; level += step)
  {
    std::vector<double> above(distances);
    for (double& value : above)
    {
      value -= level;
    }
    const std::vector<Loop> loops = LevelLoopsOf(mesh, above);
    std::vector<std::pair<double, std::size_t>> lengths;
    for (std::size_t n = 0; n < loops.size(); ++n)
    {
      lengths.emplace_back(-LengthOf(loops[n]), n);
    }
    std::sort(lengths.begin(), lengths.end());
    if (lengths.empty())
    {
      continue;
    }
    axis.Centers.push_back(MeanOf(loops[lengths.front().second]));
    const bool hasTwo = lengths.size() > 1 && lengths[1].first < BranchPart * lengths[0].first;
    isDouble = hasTwo ? isDouble + step : 0.0;
    axis.Double = std::max(axis.Double, isDouble);
  }
  return axis;
}

// Of the axis and its sections, by the trapezoidal rule; of what lies beyond the last ones, as much
// as of a cone and a cylinder in the mean.
double VolumeAlong(const Calibre& calibre)
{
  const std::vector<CalibreSection>& sections = calibre.Sections;
  double volume = 2.0 / 3.0 *
                  (sections.front().Along * sections.front().Area +
                   (calibre.Length - sections.back().Along) * sections.back().Area);
  for (std::size_t i = 0; i + 1 < sections.size(); ++i)
  {
    volume += 0.5 * (sections[i + 1].Along - sections[i].Along) *
              (sections[i].Area + sections[i + 1].Area);
  }
  return volume;
}
} // namespace

double CalibreSection::Diameter() const noexcept
{
  return std::sqrt(4.0 / M_PI * this->Area);
}

const CalibreSection& Calibre::At(double part) const
{
  std::vector<const CalibreSection*> sorted;
  for (const CalibreSection& section : this->Sections)
  {
    sorted.push_back(&section);
  }
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const CalibreSection* one, const CalibreSection* other)
                   { return one->Area < other->Area; });
  return *sorted[static_cast<std::size_t>(
      std::lround(part * static_cast<double>(sorted.size() - 1)))];
}

Status MeasureCalibre(const IndexedMesh& mesh, Calibre& measured)
{
  measured = {};
  const IndexedMesh tube = LargestSheet(mesh);
  const double volume = std::abs(MeasureEnclosed(tube).Volume);
  if (tube.Triangles.empty() || !(volume > 0.0))
  {
    return Status::Failure("has no inside");
  }
  const EdgeDistances paths(tube);
  const int end = FarthestOf(paths.From(tube.Triangles.front()[0]));
  const std::vector<double> distances = paths.From(end);
  const double length = distances[static_cast<std::size_t>(FarthestOf(distances))];
  const double diameter = std::sqrt(4.0 / M_PI * volume / length);
  if (!(length >= Calibre::LeastLength * diameter))
  {
    return Status::Failure("is not long: " + ShortText(length / diameter) +
                           " times its mean diameter, of " + ShortText(Calibre::LeastLength));
  }
  measured.IsLong = true;
  const double step = diameter / SectionsPerDiameter;
  const FirstAxis first =
      AxisOfLevels(tube, distances, 2.0 * diameter, length - 2.0 * diameter, step);
  if (first.Double > BranchLength * diameter)
  {
    return Status::Failure("has branches or rings: two sections along " + ShortText(first.Double) +
                           " mm");
  }
  Calibre made = measured;
  Status status = TubeAxis::Measure(tube, first.Centers, step, made);
  if (status.IsOk())
  {
    const double share = VolumeAlong(made) / volume;
    status = std::abs(share - 1.0) <= VolumeSlack
                 ? Status::Success()
                 : Status::Failure("is no single tube: sections along its axis hold " +
                                   ShortText(100.0 * share) + " % of its volume");
  }
  if (status.IsOk())
  {
    measured = std::move(made);
  }
  return status;
}
} // namespace palpate
