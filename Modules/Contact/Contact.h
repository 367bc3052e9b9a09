#pragma once

#include "Vector3.h"

namespace palpate
{
struct ElasticForce;

/// Contact of a tool with one structure in one tick. Without contact the proxy is the probe.
struct Contact
{
  bool IsTouching = false;
  /// Where the tool's origin would be if it could not enter, mm.
  Vector3 ProxyWorld = Vector3::Zero();
  Vector3 NormalWorld = Vector3::UnitZ(); ///< unit, out of the structure, at the proxy
  double Depth = 0.0;                     ///< mm from probe to proxy
  int Material = 0;                       ///< of a field, the touched material; else 0
  /// Of tools of several balls: the point that touches, mm, the mean of several by their pushes.
  bool HasFoot = false;
  Vector3 FootWorld = Vector3::Zero();
  /// mm^2: times the stiffness, the torque about the tool's origin.
  Vector3 Turn = Vector3::Zero();
  /// Of a structure that yields, its force, instead of that of a spring to the proxy; null if it is
  /// rigid. The tracker's own, so valid until its next call.
  const ElasticForce* Elastic = nullptr;
  /// The work of a tick ended before the proxy reached its place: it goes on in the next tick.
  bool IsBehind = false;
  /// False for a pose that is not finite: then there is no contact, and the other members are
  /// undefined.
  bool IsValid = false;
};
} // namespace palpate
