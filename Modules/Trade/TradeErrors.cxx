#include "TradeErrors.h"

#include "Units.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double Rare = 0.99;
constexpr double Most = 1.0;

// Jumps of a force during contact.
class Jumps
{
public:
  void Begin() { this->HasLast = false; }
  void Add(bool isTouching, const Vector3& force)
  {
    if (isTouching && this->HasLast)
    {
      this->Sizes.push_back((force - this->Last).norm());
    }
    this->Last = force;
    this->HasLast = isTouching;
  }
  const std::vector<double>& All() const { return this->Sizes; }

private:
  std::vector<double> Sizes;
  Vector3 Last = Vector3::Zero();
  bool HasLast = false;
};

// Accumulates ticks.
class Comparison
{
public:
  explicit Comparison(double stiffness) : Stiffness(stiffness) {}

  void BeginStroke()
  {
    this->FeltJumps.Begin();
    this->IdealJumps.Begin();
    this->WasSeized = false;
  }

  void Add(const TradePath::Tick& tick, const FeltTick& felt)
  {
    const TradePosition& truth = tick.Truth;
    const Vector3 ideal =
        truth.ForceWorld.value_or(this->Stiffness * (truth.ProxyWorld - tick.ProbeWorld));
    this->FeltJumps.Add(felt.IsTouching, felt.Force);
    this->IdealJumps.Add(truth.IsTouching, ideal);
    if (!truth.IsKnown || !(felt.IsTouching || truth.IsTouching))
    {
      return;
    }
    const Vector3 error = felt.Force - ideal;
    if (truth.ForceWorld)
    {
      this->CountSeizure(felt.ProxyWorld - truth.ProxyWorld);
    }
    else
    {
      this->CountSeizure(error / this->Stiffness);
      this->AddPosition(error / this->Stiffness, truth);
    }
    this->Forces.push_back(error.norm());
    this->Noticeable.push_back(error.norm() / TradeThresholds::JustNoticeable(ideal.norm()));
    if (truth.IsTouching && ideal.norm() >= TradeThresholds::LeastForce)
    {
      this->AddDirection(felt, ideal);
    }
  }

  void Fill(TradeRow& row) const
  {
    row.PositionMean = MeanOf(this->Positions);
    row.PositionRare = QuantileOf(this->Positions, Rare);
    row.PositionMost = QuantileOf(this->Positions, Most);
    row.SurfaceMean = MeanOf(this->Surfaces);
    row.SurfaceMost = QuantileOf(this->Surfaces, Most);
    row.ForceMean = MeanOf(this->Forces);
    row.ForceRare = QuantileOf(this->Forces, Rare);
    row.NoticeableMean = MeanOf(this->Noticeable);
    row.NoticeableRare = QuantileOf(this->Noticeable, Rare);
    row.DirectionMean = MeanOf(this->Directions);
    row.DirectionRare = QuantileOf(this->Directions, Rare);
    row.DirectionMost = QuantileOf(this->Directions, Most);
    row.JumpMean = MeanOf(this->FeltJumps.All());
    row.JumpMost = QuantileOf(this->FeltJumps.All(), Most);
    row.IdealJumpMost = QuantileOf(this->IdealJumps.All(), Most);
    row.Seizures = this->Seizures;
  }

private:
  void AddPosition(const Vector3& error, const TradePosition& truth)
  {
    this->Positions.push_back(error.norm());
    if (truth.IsTouching)
    {
      this->Surfaces.push_back(std::abs(error.dot(truth.NormalWorld)));
    }
  }

  void CountSeizure(const Vector3& error)
  {
    const bool isSeized = !(error.norm() <= TradeThresholds::Seizure);
    this->Seizures += isSeized && !this->WasSeized ? 1.0 : 0.0;
    this->WasSeized = isSeized;
  }

  void AddDirection(const FeltTick& felt, const Vector3& ideal)
  {
    // A missing force has no direction error; it counts as a force error.
    if (felt.IsTouching && !(felt.Force.norm() < TradeThresholds::LeastForce))
    {
      this->Directions.push_back(DegreesPerRadian *
                                 std::atan2(felt.Force.cross(ideal).norm(), felt.Force.dot(ideal)));
    }
  }

  double Stiffness;
  std::vector<double> Positions; // mm
  std::vector<double> Surfaces;  // mm
  std::vector<double> Forces;    // N
  std::vector<double> Noticeable;
  std::vector<double> Directions; // degrees
  Jumps FeltJumps;
  Jumps IdealJumps;
  double Seizures = 0.0;
  bool WasSeized = false;
};
} // namespace

double MeanOf(const std::vector<double>& numbers)
{
  double sum = 0.0;
  for (const double number : numbers)
  {
    sum += number;
  }
  return sum / static_cast<double>(numbers.size());
}

double QuantileOf(std::vector<double> numbers, double part)
{
  if (numbers.empty() ||
      std::any_of(numbers.begin(), numbers.end(), [](double number) { return std::isnan(number); }))
  {
    return NAN;
  }
  const double last = static_cast<double>(numbers.size() - 1);
  const auto place = numbers.begin() + static_cast<std::ptrdiff_t>(std::ceil(part * last));
  std::nth_element(numbers.begin(), place, numbers.end());
  return *place;
}

void CompareWithTruth(const TradePath& path, const std::vector<FeltTick>& felt, double stiffness,
                      TradeRow& row)
{
  Comparison comparison(stiffness);
  std::size_t stroke = 0;
  for (std::size_t tick = 0; tick < path.Ticks.size(); ++tick)
  {
    if (stroke < path.Strokes.size() && path.Strokes[stroke] == tick)
    {
      comparison.BeginStroke();
      ++stroke;
    }
    comparison.Add(path.Ticks[tick], felt[tick]);
  }
  comparison.Fill(row);
}
} // namespace palpate
