#include "ShownTick.h"

#include <array>

namespace palpate
{
void ShowTick(const TouchState& state, const TickLook& look, vtkProbeRepresentation& probe)
{
  const PlainVector3& proxy = look.IsAtHand ? state.ProbeWorld : state.ProxyWorld;
  const PlainVector3 force = look.IsTold ? state.ForceWorld : PlainVector3();
  probe.SetProbePose(state.ProbeWorld, state.ProbeOrientation);
  probe.SetProxyPose(proxy, state.ProxyOrientation);
  probe.SetForce(force.X, force.Y, force.Z);
  probe.SetInContact(state.Structure >= 0 && look.IsTold);
  probe.SetDepth(state.Depth);
  if (state.HasFoot && !look.IsAtHand)
  {
    probe.SetFoot(state.FootWorld.X, state.FootWorld.Y, state.FootWorld.Z);
  }
  else
  {
    probe.ClearFoot();
  }
  // Okabe and Ito's vermilion; yellow where the force is an estimate. Grey: no force.
  constexpr std::array<double, 3> Known{{0.84, 0.37, 0.0}};
  constexpr std::array<double, 3> Estimated{{0.94, 0.89, 0.26}};
  constexpr std::array<double, 3> Free{{0.34, 0.71, 0.91}};
  constexpr std::array<double, 3> None{{0.45, 0.45, 0.45}};
  const bool hasForce = state.Safety.Fault == SafetyFault::None;
  const auto& touching = !hasForce ? None : state.IsBeyondLinear ? Estimated : Known;
  const auto& free = hasForce ? Free : None;
  probe.SetContactColor(touching[0], touching[1], touching[2]);
  probe.SetColor(free[0], free[1], free[2]);
}
} // namespace palpate
