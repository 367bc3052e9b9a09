#pragma once

#include "LengthText.h"
#include "Vector3.h"

#include <QString>

#include <array>
#include <cmath>

namespace palpate
{
/// One coordinate of a point (world, mm) with the letter of the patient's side instead of a sign:
/// "R 10.3".
inline QString SidedLength(const Vector3& pointWorld, int axis, LengthUnit unit, int decimals)
{
  constexpr std::array<const char*, 3> Sides{"LR", "PA", "SI"};
  const int shown = DecimalsIn(unit, decimals);
  const QString number = QString::number(std::abs(LengthIn(unit, pointWorld[axis])), 'f', shown);
  // No side has a zero.
  const bool isOpposite = pointWorld[axis] < 0.0 && number.toDouble() != 0.0;
  return QString("%1 %2").arg(QChar(Sides.at(static_cast<std::size_t>(axis))[isOpposite ? 1 : 0]),
                              number);
}
} // namespace palpate
