#pragma once

#include "Vector3.h"

namespace palpate
{
/// What a tool feels of one structure in one tick. Without touch the proxy is the probe itself.
struct Contact
{
  bool IsTouching = false;
  /// Where the tool's origin would be if it could not enter, mm.
  Vector3 ProxyWorld = Vector3::Zero();
  Vector3 NormalWorld = Vector3::UnitZ(); ///< unit, out of the structure, at the proxy
  double Depth = 0.0;                     ///< mm from probe to proxy
  int Material = 0;                       ///< of a field, the one that is touched; else 0
  /// False for a pose that is not finite: then nothing is touched, and the numbers mean nothing.
  bool IsValid = false;
};
} // namespace palpate
