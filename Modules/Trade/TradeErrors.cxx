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

// What an error exceeds its uncertainty by; NaN stays NaN.
double Beyond(double error, double uncertainty)
{
  return error <= uncertainty ? 0.0 : error - uncertainty;
}

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
      this->CountSeizure((felt.ProxyWorld - truth.ProxyWorld).norm());
    }
    else
    {
      this->CountSeizure(Beyond(error.norm() / this->Stiffness, truth.Uncertainty));
      this->AddPosition(error / this->Stiffness, truth);
    }
    const double noticeable = TradeThresholds::JustNoticeable(ideal.norm());
    const double open = this->Stiffness * truth.Uncertainty; // N
    this->Forces.push_back(error.norm());
    this->Noticeable.push_back(error.norm() / noticeable);
    this->NoticeableBeyond.push_back(Beyond(error.norm(), open) / noticeable);
    if (truth.IsTouching && ideal.norm() >= TradeThresholds::LeastForce)
    {
      this->AddDirection(felt, ideal, open);
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
    row.BeyondPositionRare = QuantileOf(this->PositionsBeyond, Rare);
    row.BeyondNoticeableRare = QuantileOf(this->NoticeableBeyond, Rare);
    row.BeyondDirectionRare = QuantileOf(this->DirectionsBeyond, Rare);
    row.UncertaintyMean = MeanOf(this->Uncertainties);
    row.UncertaintyRare = QuantileOf(this->Uncertainties, Rare);
    row.JumpMean = MeanOf(this->FeltJumps.All());
    row.JumpMost = QuantileOf(this->FeltJumps.All(), Most);
    row.IdealJumpMost = QuantileOf(this->IdealJumps.All(), Most);
    row.Seizures = this->Seizures;
  }

private:
  void AddPosition(const Vector3& error, const TradePosition& truth)
  {
    this->Positions.push_back(error.norm());
    this->PositionsBeyond.push_back(Beyond(error.norm(), truth.Uncertainty));
    this->Uncertainties.push_back(truth.Uncertainty);
    if (truth.IsTouching)
    {
      this->Surfaces.push_back(std::abs(error.dot(truth.NormalWorld)));
    }
  }

  void CountSeizure(double error)
  {
    const bool isSeized = !(error <= TradeThresholds::Seizure);
    this->Seizures += isSeized && !this->WasSeized ? 1.0 : 0.0;
    this->WasSeized = isSeized;
  }

  void AddDirection(const FeltTick& felt, const Vector3& ideal, double open)
  {
    // A missing force has no direction error; it counts as a force error.
    if (felt.IsTouching && !(felt.Force.norm() < TradeThresholds::LeastForce))
    {
      const double turned = std::atan2(felt.Force.cross(ideal).norm(), felt.Force.dot(ideal));
      const double uncertainty = open < ideal.norm() ? std::asin(open / ideal.norm()) : M_PI;
      this->Directions.push_back(DegreesPerRadian * turned);
      this->DirectionsBeyond.push_back(DegreesPerRadian * Beyond(turned, uncertainty));
    }
  }

  double Stiffness;
  std::vector<double> Positions; // mm
  std::vector<double> Surfaces;  // mm
  std::vector<double> Forces;    // N
  std::vector<double> Noticeable;
  std::vector<double> Directions; // degrees
  std::vector<double> PositionsBeyond;
  std::vector<double> NoticeableBeyond;
  std::vector<double> DirectionsBeyond;
  std::vector<double> Uncertainties; // mm
  Jumps FeltJumps;
  Jumps IdealJumps;
  double Seizures = 0.0;
  bool WasSeized = false;
};

// Whether the hand, which follows the reference, presses the tool far deeper than the path does.
bool Parts(const TradePath& path, const std::vector<FeltTick>& felt, double stiffness,
           std::size_t stroke)
{
  constexpr double MostPart = 2.0; // of the path's depth
  for (std::size_t tick = path.Strokes[stroke]; tick < path.EndOf(stroke); ++tick)
  {
    const TradePath::Tick& one = path.Ticks[tick];
    const Vector3 pressed = felt[tick].Force / stiffness;
    const Vector3 error = one.ProbeWorld + pressed - one.Truth.ProxyWorld;
    if (!one.Truth.ForceWorld && one.Truth.IsKnown && pressed.norm() > MostPart * path.MostDepth &&
        error.norm() > TradeThresholds::Seizure)
    {
      return true;
    }
  }
  return false;
}
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
  row.Parted = 0.0;
  for (std::size_t stroke = 0; stroke < path.Strokes.size(); ++stroke)
  {
    if (Parts(path, felt, stiffness, stroke))
    {
      row.Parted += 1.0;
      continue;
    }
    comparison.BeginStroke();
    for (std::size_t tick = path.Strokes[stroke]; tick < path.EndOf(stroke); ++tick)
    {
      comparison.Add(path.Ticks[tick], felt[tick]);
    }
  }
  comparison.Fill(row);
}
} // namespace palpate
