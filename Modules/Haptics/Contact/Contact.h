#pragma once

#include "ElasticForce.h"
#include "Vector3.h"

namespace palpate
{
/// Contact of a tool with one structure in one tick. Without contact the proxy is the probe.
struct Contact
{
  bool IsTouching = false;
  /// Where the tool's origin would be if it could not enter, mm.
  Vector3 ProxyWorld = Vector3::Zero();
  Vector3 NormalWorld = Vector3::UnitZ(); ///< unit, out of the structure, at the proxy
  double Depth = 0.0;                     ///< mm from probe to proxy
  int Material = 0;                       ///< of a field, the touched material; else 0
  /// Whether the structure yields: then the force is this one, not that of a spring to the proxy.
  bool IsElastic = false;
  ElasticForce Elastic;
  /// False for a pose that is not finite: then there is no contact, and the other members are
  /// undefined.
  bool IsValid = false;
};
} // namespace palpate
