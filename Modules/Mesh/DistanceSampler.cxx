#include "DistanceSampler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace palpate
{
namespace
{
constexpr double LargestCell = 1.0 / 4096.0; // of the area
constexpr double HalvedShare = 0.33;         // of the sum of products of area and variation
constexpr double LargestChange = 0.005;      // of a number by the last pass
constexpr std::size_t MostAdded = 250'000;
constexpr double LargestGap = 1e-3; // between the largest distance and its bound, of the former
constexpr std::size_t MostSearched = 60'000;
constexpr double Least = 1e-6; // mm; rounding of distances is below
constexpr double CornerWeight = 1.0 / 12.0;
constexpr double CentreWeight = 0.75;

/// A part of a triangle, by numbers of samples.
struct TrianglePart
{
  std::array<int, 3> Corners;
  int Centre;
  double Area; ///< mm^2
};

/// Places, points and distances of samples, which grow together.
class SampleStore
{
public:
  SampleStore(const SampledSurface& surface, const DistanceFunction& distances)
      : Surface(surface), Distances(distances)
  {
  }

  int Add(const Vector3& place)
  {
    this->Places.push_back(place);
    this->Points.push_back(this->Surface.PointAt ? this->Surface.PointAt(place) : place);
    return static_cast<int>(this->Places.size()) - 1;
  }
  int AddMiddle(int a, int b) { return this->Add(0.5 * (this->Places[a] + this->Places[b])); }
  int AddCentre(const std::array<int, 3>& corners)
  {
    return this->Add(
        (this->Places[corners[0]] + this->Places[corners[1]] + this->Places[corners[2]]) / 3.0);
  }

  /// Measures those that were added since the last call.
  Status Measure()
  {
    const auto begin = static_cast<std::ptrdiff_t>(this->Values.size());
    const std::vector<Vector3> added(this->Points.begin() + begin, this->Points.end());
    std::vector<double> distances;
    if (Status status = this->Distances(added, distances); !status.IsOk())
    {
      return status;
    }
    this->Values.insert(this->Values.end(), distances.begin(), distances.end());
    return Status::Success();
  }

  /// Without sign.
  double Distance(int sample) const { return std::abs(this->Values[sample]); }

  std::vector<Vector3> Places;
  std::vector<Vector3> Points;
  std::vector<double> Values;

private:
  const SampledSurface& Surface;
  const DistanceFunction& Distances;
};

double AreaOf(const SampleStore& store, const std::array<int, 3>& t)
{
  const Vector3& a = store.Points[t[0]];
  return 0.5 * (store.Points[t[1]] - a).cross(store.Points[t[2]] - a).norm();
}

// Halves a cell at its longest edge; centres are not set.
std::pair<TrianglePart, TrianglePart> Halves(const TrianglePart& cell, SampleStore& store)
{
  std::size_t longest = 0;
  double most = -1.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double length =
        (store.Points[cell.Corners[(i + 1) % 3]] - store.Points[cell.Corners[i]]).squaredNorm();
    if (length > most)
    {
      most = length;
      longest = i;
    }
  }
  const std::size_t next = (longest + 1) % 3;
  const int middle = store.AddMiddle(cell.Corners[longest], cell.Corners[next]);
  std::pair<TrianglePart, TrianglePart> halves(cell, cell);
  halves.first.Corners[next] = middle;
  halves.second.Corners[longest] = middle;
  halves.first.Area = halves.second.Area = 0.5 * cell.Area;
  return halves;
}

/// The quadrature of SampleDistances.
class Quadrature
{
public:
  Quadrature(const SampledSurface& surface, const DistanceFunction& distances)
      : Store(surface, distances)
  {
    for (const Vector3& place : surface.Places.Points)
    {
      this->Store.Add(place);
    }
    for (const std::array<int, 3>& t : surface.Places.Triangles)
    {
      this->Cells.push_back({t, -1, AreaOf(this->Store, t)});
      this->Area += this->Cells.back().Area;
    }
    this->SplitLargeCells();
    for (TrianglePart& cell : this->Cells)
    {
      cell.Centre = this->Store.AddCentre(cell.Corners);
    }
  }

  Status Run()
  {
    if (Status status = this->Store.Measure(); !status.IsOk())
    {
      return status;
    }
    const std::size_t most = this->Store.Points.size() + MostAdded;
    DistanceSummary before = this->Summary();
    bool isRefined = !(this->Area > 0.0);
    while (!isRefined && this->Store.Points.size() < most)
    {
      if (Status status = this->Refine(); !status.IsOk())
      {
        return status;
      }
      const DistanceSummary after = this->Summary();
      const auto isNear = [](double a, double b)
      { return std::abs(a - b) <= std::max(Least, LargestChange * b); };
      isRefined = isNear(before.Mean, after.Mean) && isNear(before.Rms, after.Rms) &&
                  isNear(before.Percentile95, after.Percentile95);
      before = after;
    }
    return Status::Success();
  }

  const std::vector<TrianglePart>& Parts() const { return this->Cells; }
  SampleStore& Samples() { return this->Store; }

  std::vector<double> Weights() const
  {
    std::vector<double> weights(this->Store.Points.size(), 0.0);
    if (!(this->Area > 0.0))
    {
      std::fill(weights.begin(), weights.end(), 1.0 / static_cast<double>(weights.size()));
      return weights;
    }
    for (const TrianglePart& cell : this->Cells)
    {
      const double part = cell.Area / this->Area;
      weights[cell.Centre] += CentreWeight * part;
      for (const int corner : cell.Corners)
      {
        weights[corner] += CornerWeight * part;
      }
    }
    return weights;
  }

private:
  void SplitLargeCells()
  {
    for (std::size_t i = 0; i < this->Cells.size(); ++i)
    {
      while (this->Cells[i].Area > LargestCell * this->Area)
      {
        const auto [first, second] = Halves(this->Cells[i], this->Store);
        this->Cells[i] = first;
        this->Cells.push_back(second);
      }
    }
  }

  DistanceSummary Summary() const { return Summarise({{}, this->Store.Values, this->Weights()}); }

  double Variation(const TrianglePart& cell) const
  {
    const auto [low, high] =
        std::minmax({this->Store.Distance(cell.Corners[0]), this->Store.Distance(cell.Corners[1]),
                     this->Store.Distance(cell.Corners[2]), this->Store.Distance(cell.Centre)});
    return cell.Area * (high - low);
  }

  Status Refine()
  {
    std::vector<WeightedValue> variations;
    double sum = 0.0;
    for (const TrianglePart& cell : this->Cells)
    {
      const double variation = this->Variation(cell);
      variations.push_back({variation, variation});
      sum += variation;
    }
    const double least = WeightedQuantile(variations, HalvedShare * sum);
    const std::size_t count = this->Cells.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      if (variations[i].Value >= least && variations[i].Value > 0.0)
      {
        auto [first, second] = Halves(this->Cells[i], this->Store);
        first.Centre = this->Store.AddCentre(first.Corners);
        second.Centre = this->Store.AddCentre(second.Corners);
        this->Cells[i] = first;
        this->Cells.push_back(second);
      }
    }
    return this->Store.Measure();
  }

  SampleStore Store;
  std::vector<TrianglePart> Cells;
  double Area = 0.0;
};

/// Branch and bound for the largest distance. Its samples have no weight.
class LargestSearch
{
public:
  LargestSearch(const std::vector<TrianglePart>& cells, SampleStore& store) : Store(store)
  {
    for (const TrianglePart& cell : cells)
    {
      this->See(cell.Centre);
      std::for_each(cell.Corners.begin(), cell.Corners.end(), [this](int i) { this->See(i); });
    }
    for (const TrianglePart& cell : cells)
    {
      this->Keep(cell);
    }
  }

  Status Run()
  {
    const std::size_t end = this->Store.Points.size() + MostSearched;
    while (!this->Open.empty() && this->Store.Points.size() < end)
    {
      this->Choose((end - this->Store.Points.size()) / SamplesPerSplit + 1);
      const std::vector<Bounded> chosen = std::exchange(this->Open, {});
      std::vector<TrianglePart> parts;
      for (const Bounded& one : chosen)
      {
        this->Split(one.Part, parts);
      }
      const std::size_t begin = this->Store.Values.size();
      if (Status status = this->Store.Measure(); !status.IsOk())
      {
        return status;
      }
      for (std::size_t i = begin; i < this->Store.Values.size(); ++i)
      {
        this->See(static_cast<int>(i));
      }
      std::for_each(parts.begin(), parts.end(),
                    [this](const TrianglePart& part) { this->Keep(part); });
    }
    return Status::Success();
  }

  double Largest() const { return this->Best; }
  Vector3 Farthest() const { return this->At; }

private:
  static constexpr std::size_t SamplesPerSplit = 6;

  struct Bounded
  {
    double Bound;
    TrianglePart Part;
  };

  void See(int sample)
  {
    if (this->Store.Distance(sample) > this->Best)
    {
      this->Best = this->Store.Distance(sample);
      this->At = this->Store.Points[sample];
    }
  }

  // No distance in the cell exceeds that at one of its points by more than the way from there.
  double Bound(const TrianglePart& cell) const
  {
    const Vector3& centre = this->Store.Points[cell.Centre];
    double reach = 0.0;
    double corners = 0.0; // from the mean over the corners
    double ways = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Vector3& corner = this->Store.Points[cell.Corners[i]];
      reach = std::max(reach, (corner - centre).norm());
      corners += this->Store.Distance(cell.Corners[i]) / 3.0;
      ways = std::max(ways, ((this->Store.Points[cell.Corners[(i + 1) % 3]] - corner).norm() +
                             (this->Store.Points[cell.Corners[(i + 2) % 3]] - corner).norm()) /
                                3.0);
    }
    return std::min(this->Store.Distance(cell.Centre) + reach, corners + ways);
  }

  void Keep(const TrianglePart& cell)
  {
    const double bound = this->Bound(cell);
    if (bound > this->Best + std::max(Least, LargestGap * this->Best))
    {
      this->Open.push_back({bound, cell});
    }
  }

  // Those with the largest bounds.
  void Choose(std::size_t most)
  {
    if (this->Open.size() > most)
    {
      const auto end = this->Open.begin() + static_cast<std::ptrdiff_t>(most);
      std::nth_element(this->Open.begin(), end, this->Open.end(),
                       [](const Bounded& a, const Bounded& b) { return a.Bound > b.Bound; });
      this->Open.erase(end, this->Open.end());
    }
  }

  // Into four, of which one has the same centre.
  void Split(const TrianglePart& cell, std::vector<TrianglePart>& parts)
  {
    const auto [a, b, c] = cell.Corners;
    const int ab = this->Store.AddMiddle(a, b);
    const int bc = this->Store.AddMiddle(b, c);
    const int ca = this->Store.AddMiddle(c, a);
    const double area = 0.25 * cell.Area;
    for (const std::array<int, 3>& corners :
         {std::array<int, 3>{a, ab, ca}, {ab, b, bc}, {ca, bc, c}})
    {
      parts.push_back({corners, this->Store.AddCentre(corners), area});
    }
    parts.push_back({{ab, bc, ca}, cell.Centre, area});
  }

  SampleStore& Store;
  std::vector<Bounded> Open;
  double Best = 0.0;
  Vector3 At = Vector3::Zero();
};
} // namespace

Status SampleDistances(const SampledSurface& surface, const DistanceFunction& distances,
                       DistanceSamples& samples)
{
  Quadrature quadrature(surface, distances);
  if (Status status = quadrature.Run(); !status.IsOk())
  {
    return status;
  }
  DistanceSamples made;
  made.Weights = quadrature.Weights();
  SampleStore& store = quadrature.Samples();
  LargestSearch search(quadrature.Parts(), store);
  if (Status status = search.Run(); !status.IsOk())
  {
    return status;
  }
  made.Largest = search.Largest();
  made.Farthest = search.Farthest();
  store.Points.resize(made.Weights.size());
  store.Values.resize(made.Weights.size());
  made.Points = std::move(store.Points);
  made.Values = std::move(store.Values);
  samples = std::move(made);
  return Status::Success();
}
} // namespace palpate
