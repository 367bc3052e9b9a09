#pragma once

#include "ManualClock.h"
#include "Study.h"
#include "StudyPhantoms.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::test
{
/// Directions spread over the sphere (Fibonacci lattice).
inline Vector3 DirectionAt(int n, int count)
{
  const double z = 1.0 - (2.0 * n + 1.0) / count;
  const double angle = 2.399963229728653 * n;
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

/// A study of a volume in which an organ is drawn.
class StudyDrawnCase : public testing::Test
{
protected:
  void Draw(const StudyDrawing& drawing)
  {
    StudyState next = this->Open.State();
    next.Drawing = drawing;
    this->Open.Change("Draw", next);
    this->Finish();
  }
  void Finish()
  {
    while (this->Open.Jobs().WaitForResult())
    {
      this->Open.Deliver();
    }
  }
  const DrawnOrgan& Organ() const { return this->Open.Drawn().Organ(); }

  test::StudyPhantom Phantom;
  ManualClock Time;
  Study Open{this->Time};
};
} // namespace palpate::test
