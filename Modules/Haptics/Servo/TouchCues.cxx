#include "TouchCues.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double ForceTime = 0.02;   // s: trembling above about 8 Hz is felt as texture
constexpr double TrembleTime = 0.03; // s
constexpr double KnockTime = 0.04;   // s

double OfFull(double value, double full) noexcept
{
  return value > 0.0 ? std::min(value / full, 1.0) : 0.0; // 0 for NaN
}
} // namespace

const TouchCue& TouchCues::Update(const TouchState& state) noexcept
{
  const double passed =
      this->HasLast ? std::max(0.0, 1e-9 * static_cast<double>(state.Tick.Started - this->LastTime))
                    : 0.0;
  const Vector3 probe(state.ProbeWorld);
  const double force = Vector3(state.ForceDevice).norm();
  const bool isTouching = state.Structure >= 0 && force > 0.0;
  const auto share = [passed](double time) { return 1.0 - std::exp(-passed / time); };

  this->SmoothForce += share(ForceTime) * (force - this->SmoothForce);
  this->Tremble += share(TrembleTime) * (std::abs(force - this->SmoothForce) - this->Tremble);
  this->Now.Knock *= 1.0 - share(KnockTime);
  if (isTouching && !this->WasTouching && passed > 0.0)
  {
    this->Now.Knock = OfFull((probe - this->LastProbe).norm() / passed, FullSpeed);
  }
  this->Now.Push = OfFull(force, FullForce);
  this->Now.Texture = isTouching ? OfFull(this->Tremble, FullTremble) : 0.0;
  this->Now.Hardness =
      isTouching && state.Depth > 0.0 ? OfFull(force / state.Depth, FullHardness) : 0.0;
  this->Now.Knock = isTouching ? this->Now.Knock : 0.0;

  this->WasTouching = isTouching;
  this->HasLast = true;
  this->LastTime = state.Tick.Started;
  this->LastProbe = probe;
  return this->Now;
}
} // namespace palpate
