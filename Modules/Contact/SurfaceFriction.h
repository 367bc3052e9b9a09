#pragma once

namespace palpate
{
/// Coulomb's coefficients of a surface, tangential by normal force; 0 means no friction. 0 <=
/// Dynamic <= Static.
struct SurfaceFriction
{
  double Static = 0.0;  ///< up to which the tool sticks
  double Dynamic = 0.0; ///< while it slips
};
} // namespace palpate
