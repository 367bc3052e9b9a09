#include "GeodesicCurve.h"

#include "ChordDescent.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
// `count` chords of equal length along the points, with parameters between theirs.
std::vector<Vector3> Resampled(const SurfaceModel& surface, const std::vector<Vector3>& parameters,
                               int count)
{
  std::vector<Vector3> points(parameters.size());
  surface.PointBatch(parameters.data(), parameters.size(), points.data());
  std::vector<double> lengths{0.0};
  for (std::size_t k = 1; k < points.size(); ++k)
  {
    lengths.push_back(lengths.back() + (points[k] - points[k - 1]).norm());
  }
  std::vector<Vector3> nodes{parameters.front()};
  std::size_t next = 1;
  for (int k = 1; k < count; ++k)
  {
    const double wanted = lengths.back() * k / count;
    while (next + 1 < lengths.size() && lengths[next] < wanted)
    {
      ++next;
    }
    const double gap = lengths[next] - lengths[next - 1];
    const double share = gap > 0.0 ? (wanted - lengths[next - 1]) / gap : 0.0;
    const Vector3 between = (1.0 - share) * parameters[next - 1] + share * parameters[next];
    nodes.push_back(between.squaredNorm() > 0.0 ? Vector3(between.normalized()) : parameters[next]);
  }
  nodes.push_back(parameters.back());
  return nodes;
}
} // namespace

GeodesicCurve Straightened(const SurfaceModel& surface, const std::vector<Vector3>& start)
{
  constexpr int FewestChords = 24;
  constexpr int MostChords = 768;
  constexpr int MostSteps = 400;
  constexpr double Accuracy = 2e-6; // of the length
  GeodesicCurve curve;
  curve.Parameters = start;
  double chords = 0.0; // their length, with half as many
  bool isStraight = true;
  for (int count = FewestChords; count <= MostChords && !curve.HasConverged; count *= 2)
  {
    ChordDescent descent(surface, Resampled(surface, curve.Parameters, count));
    isStraight = descent.Run(MostSteps);
    const double before = curve.Length;
    const double length = descent.Length();
    // The chords' error is one of their squared length.
    curve.Length = count > FewestChords ? length + (length - chords) / 3.0 : length;
    curve.Uncertainty = std::abs(curve.Length - before);
    curve.HasConverged =
        isStraight && count > 2 * FewestChords && curve.Uncertainty <= Accuracy * curve.Length;
    curve.Parameters = descent.Parameters();
    curve.Points = descent.Points();
    chords = length;
  }
  return curve;
}
} // namespace palpate
