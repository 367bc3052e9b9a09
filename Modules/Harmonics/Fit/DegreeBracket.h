#pragma once

#include <optional>

namespace palpate
{
/// Searches for the smallest degree whose RMS residual is at most a tolerance, with few fits. Above
/// degree 12 the RMS of an organ's surface falls by about the same factor from degree to degree, so
/// the next degree to try is where a line through the logarithms crosses the tolerance. The degree
/// found meets the tolerance and is the smallest or, above 12 where the line crosses in the lower
/// half of the step, the one above; if residuals fall monotonically.
class DegreeBracket
{
public:
  /// `tolerance` in mm, above 0. Degrees from `least` to `highest` may be tried.
  DegreeBracket(double tolerance, int least, int highest) noexcept;

  /// The degree to try next; empty at the end.
  std::optional<int> Next() const noexcept;
  /// What a fit of a degree left (mm). Returns whether that is the best so far: the lowest degree
  /// that meets the tolerance or, until one does, the highest tried.
  bool Add(int degree, double rms) noexcept;

private:
  struct Tried
  {
    int Degree;
    double Excess; ///< logarithm of the RMS over the tolerance
  };
  /// Of the line through both ends, or through the last two that missed, with the tolerance.
  double Crossing() const noexcept;
  int NextUpwards() const noexcept;
  /// The highest degree that misses, or that is not to be tried.
  int Below() const noexcept { return this->Missed ? this->Missed->Degree : this->Least - 1; }

  double Tolerance;
  int Least;
  int Highest;
  std::optional<Tried> Missed; ///< at Below
  std::optional<Tried> Met;    ///< the lowest
  double Decay;                ///< of the logarithm per degree
};
} // namespace palpate
