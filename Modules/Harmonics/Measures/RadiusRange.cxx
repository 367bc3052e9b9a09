#include "RadiusRange.h"

#include "RadialSpectrum.h"
#include "SphericalTriangle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace palpate
{
namespace
{
constexpr int LargestEvaluationCount = 500000; // of each of the two searches

struct RangeCell
{
  SphericalTriangle Triangle;
  double Upper;

  friend bool operator<(const RangeCell& a, const RangeCell& b) { return a.Upper < b.Upper; }
};

struct Extreme
{
  double Found;
  double Bound;
};

// The largest value of `sign` times the radius.
class ExtremeSearch
{
public:
  ExtremeSearch(const RadialModel& model, const RadialSpectrum& spectrum, double sign)
      : Model(model), Spectrum(spectrum), Sign(sign)
  {
  }

  Extreme Run(double tolerance)
  {
    for (const SphericalTriangle& face : SphericalTriangle::Icosahedron())
    {
      this->Add(face);
    }
    while (this->Bound() - this->Found > tolerance &&
           this->EvaluationCount < LargestEvaluationCount)
    {
      const SphericalTriangle best = this->Cells.top().Triangle;
      this->Cells.pop();
      for (const SphericalTriangle& part : best.Split())
      {
        this->Add(part);
      }
    }
    return {this->Found, this->Bound()};
  }

private:
  // Upper bound of the values everywhere.
  double Bound() const
  {
    return this->Cells.empty() ? this->Found : std::max(this->Found, this->Cells.top().Upper);
  }

  void Add(const SphericalTriangle& triangle)
  {
    const SphericalCap cap = triangle.Cap();
    const RadialModel::Sample sample = this->Model.Evaluate(cap.Center);
    const RadiusInterval interval = this->Spectrum.RadiusAround(sample, cap.Radius);
    this->Found = std::max(this->Found, this->Sign * sample.Radius);
    const double upper = this->Sign > 0.0 ? interval.Upper : -interval.Lower;
    if (upper > this->Found)
    {
      this->Cells.push({triangle, upper});
    }
    ++this->EvaluationCount;
  }

  const RadialModel& Model;
  const RadialSpectrum& Spectrum;
  double Sign;
  std::priority_queue<RangeCell> Cells;
  double Found = -std::numeric_limits<double>::infinity();
  int EvaluationCount = 0;
};
} // namespace

RadiusRange FindRadiusRange(const RadialModel& model, double tolerance)
{
  const RadialSpectrum spectrum(model);
  // No tolerance below the error of evaluation can be reached.
  const double reachable = std::max(4.0 * spectrum.EvaluationError(), tolerance);
  if (!std::isfinite(spectrum.EvaluationError()))
  {
    const double none = std::numeric_limits<double>::quiet_NaN();
    return {none, none, none, none};
  }
  const Extreme highest = ExtremeSearch(model, spectrum, 1.0).Run(reachable);
  const Extreme lowest = ExtremeSearch(model, spectrum, -1.0).Run(reachable);
  return {-lowest.Bound, -lowest.Found, highest.Found, highest.Bound};
}
} // namespace palpate
