#include "LeftOutModes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr double Epsilon = std::numeric_limits<double>::epsilon();
constexpr double Tie = 8.0 * Epsilon; // relative
constexpr int MostSecularSteps = 100; // typically 3; bisection alone needs some 60
// A case that explains its direction up to this fraction is alone in it: the others have no mode
// there, and what remains is rounding.
constexpr double AloneInDirection = 1e-9;
} // namespace

LeftOutSolver::LeftOutSolver(const ShapeModes& modes)
    : Modes(modes), Cases(modes.Scores.rows()),
      Factor(static_cast<double>(Cases) /
             static_cast<double>(std::max<Eigen::Index>(Cases - 1, 1))),
      Scatter(modes.Deviations.cwiseAbs2() * static_cast<double>(Cases - 1)), Poles(Scatter.size()),
      Weights(Scatter.size()), Offsets(Scatter.size()), Terms(Scatter.size()),
      Differences(Scatter.size())
{
}

// Modes of equal scatter count as one with a common term, and the rest of them, like modes in which
// the case has no score, stay as they are.
void LeftOutSolver::Deflate(Eigen::Index leftOut)
{
  this->Count = 0;
  this->Roots.clear();
  for (Eigen::Index k = 0; k < this->Scatter.size(); ++k)
  {
    const double score = this->Modes.Scores(leftOut, k);
    const double weight = this->Factor * score * score;
    if (weight <= Epsilon * Epsilon * this->Scatter[k])
    {
      this->Roots.push_back({this->Scatter[k], this->Factor * weight});
    }
    else if (this->Count > 0 &&
             this->Poles[this->Count - 1] - this->Scatter[k] <= Tie * this->Scatter[k])
    {
      this->Weights[this->Count - 1] += weight;
      this->Roots.push_back({this->Scatter[k], 0.0});
    }
    else
    {
      this->Poles[this->Count] = this->Scatter[k];
      this->Weights[this->Count] = weight;
      ++this->Count;
    }
  }
}

LeftOutSolver::Sums LeftOutSolver::SumsAt(Eigen::Index pole, double offset)
{
  const Eigen::Index upper = pole + 1;
  const Eigen::Index lower = this->Count - upper;
  auto differences = this->Differences.head(this->Count);
  auto terms = this->Terms.head(this->Count);
  differences = this->Offsets.head(this->Count) - offset;
  terms = this->Weights.head(this->Count) / differences;
  Sums sums;
  sums.Upper = terms.head(upper).sum();
  sums.Lower = terms.tail(lower).sum();
  terms /= differences;
  sums.UpperSlope = terms.head(upper).sum();
  sums.LowerSlope = terms.tail(lower).sum();
  return sums;
}

// Each sum is replaced by a constant and one pole with the same value and slope.
double LeftOutSolver::Step(Eigen::Index pole, double offset, const Sums& sums) const
{
  const double above = this->Offsets[pole] - offset;
  const double upper = sums.UpperSlope * above * above;
  double rest = 1.0 - sums.Upper + sums.UpperSlope * above;
  if (pole + 1 == this->Count)
  {
    return above - upper / rest;
  }
  const double below = this->Offsets[pole + 1] - offset;
  const double lower = sums.LowerSlope * below * below;
  rest -= sums.Lower - sums.LowerSlope * below;
  // rest x^2 - half x 2 + constant = 0; its root between the poles, without cancellation.
  const double half = 0.5 * (rest * (above + below) - upper - lower);
  const double constant = rest * above * below - upper * below - lower * above;
  const double root = std::sqrt(std::max(half * half - rest * constant, 0.0));
  return half <= 0.0 ? constant / (half - root) : (half + root) / rest;
}

// The function falls from `low` to `high`, offsets from the origin.
double LeftOutSolver::FindRoot(Eigen::Index pole, double low, double high, double start, Sums& sums)
{
  double offset = start;
  for (int step = 0; step < MostSecularSteps; ++step)
  {
    sums = this->SumsAt(pole, offset);
    const double value = sums.Value();
    (value > 0.0 ? low : high) = offset;
    if (std::abs(value) <= 4.0 * Epsilon * sums.Size() ||
        high - low <= 2.0 * Epsilon * std::max(std::abs(low), std::abs(high)))
    {
      break;
    }
    const double next = offset + this->Step(pole, offset, sums);
    offset = next > low && next < high ? next : 0.5 * (low + high);
  }
  return offset;
}

// Between this pole and the next smaller one. The closer one is the origin, so that the difference
// to it is known to its last digits.
void LeftOutSolver::AddRoot(Eigen::Index pole)
{
  const auto poles = this->Poles.head(this->Count);
  const double gap = poles[pole] - poles[pole + 1];
  this->Offsets.head(this->Count) = poles - poles[pole];
  const bool isAbove = this->SumsAt(pole, -0.5 * gap).Value() > 0.0;
  const double origin = isAbove ? poles[pole] : poles[pole + 1];
  this->Offsets.head(this->Count) = poles - origin;
  Sums sums;
  const double offset = isAbove ? this->FindRoot(pole, -0.5 * gap, 0.0, -0.5 * gap, sums)
                                : this->FindRoot(pole, 0.0, 0.5 * gap, 0.5 * gap, sums);
  this->Roots.push_back({origin + offset, this->Factor / sums.Slope()});
}

// Between the smallest pole and 0, where it is if no other case varies in that direction: always if
// the group has as many modes as it can.
void LeftOutSolver::AddLastRoot()
{
  const Eigen::Index last = this->Count - 1;
  const double origin = this->Poles[last];
  this->Offsets.head(this->Count) = this->Poles.head(this->Count) - origin;
  Sums sums = this->SumsAt(last, -origin);
  double scatter = 0.0;
  if (this->Scatter.size() < this->Cases - 1 && sums.Value() > AloneInDirection)
  {
    scatter = origin + this->FindRoot(last, -origin, 0.0, -0.5 * origin, sums);
  }
  this->Roots.push_back({scatter, this->Factor / sums.Slope()});
}

LeftOutModes LeftOutSolver::Solve(Eigen::Index leftOut)
{
  LeftOutModes result;
  this->Deflate(leftOut);
  for (Eigen::Index pole = 0; pole + 1 < this->Count; ++pole)
  {
    this->AddRoot(pole);
  }
  if (this->Count > 0)
  {
    this->AddLastRoot();
  }
  std::sort(this->Roots.begin(), this->Roots.end(),
            [](const Root& a, const Root& b) { return a.Scatter > b.Scatter; });
  if (!this->Roots.empty() && this->Roots.back().Scatter <= 0.0)
  {
    result.Outside = this->Roots.back().Square;
    this->Roots.pop_back();
  }
  const auto count = static_cast<Eigen::Index>(this->Roots.size());
  result.Variances.resize(count);
  result.Squares.resize(count);
  for (Eigen::Index k = 0; k < count; ++k)
  {
    const Root& root = this->Roots[static_cast<std::size_t>(k)];
    result.Variances[k] = root.Scatter / static_cast<double>(this->Cases - 2);
    result.Squares[k] = root.Square;
  }
  return result;
}
} // namespace palpate
