#pragma once

#include <cmath>

namespace palpate
{
/// Where a polynomial on [0, 1], given by its Bernstein coefficients, changes between negative and
/// not negative, in increasing order.
///
/// The number of sign changes of the coefficients bounds the number of roots and has its parity
/// (Descartes), so intervals are halved (de Casteljau) until each has at most one change; its root
/// is then found by Newton's method with a bracket. Means keep signs however they are rounded, and
/// both halves share the value between them: the number of crossings is odd exactly if the first
/// and the last coefficient differ in sign, whatever the rounding in between. A pair of crossings
/// closer to each other than 2^-Halvings is within rounding: it may be found or not.
template <int Degree>
class BernsteinCrossings
{
public:
  static constexpr int Halvings = 30;

  explicit BernsteinCrossings(const double* coefficients) noexcept
  {
    const int changes = Changes(coefficients);
    if (changes == 1)
    {
      this->Solve(coefficients, 0.0, 1.0);
    }
    else if (changes > 1)
    {
      this->Isolate(coefficients, 0.0, 1.0, Halvings);
    }
  }

  int Count() const noexcept { return this->Found; }
  double Parameter(int crossing) const noexcept { return this->Parameters[crossing]; }

  /// The value at u; `slope` becomes the derivative.
  static double Evaluate(const double* coefficients, double u, double& slope) noexcept
  {
    double row[Degree + 1];
    for (int n = 0; n <= Degree; ++n)
    {
      row[n] = coefficients[n];
    }
    const double v = 1.0 - u;
    for (int length = Degree; length > 1; --length)
    {
      for (int n = 0; n < length; ++n)
      {
        row[n] = row[n] * v + row[n + 1] * u;
      }
    }
    slope = Degree * (row[1] - row[0]);
    return row[0] * v + row[1] * u;
  }
  /// A bound of the second derivative.
  static double LargestBend(const double* coefficients) noexcept
  {
    double largest = 0.0;
    for (int n = 0; n + 2 <= Degree; ++n)
    {
      const double bend = coefficients[n] - 2.0 * coefficients[n + 1] + coefficients[n + 2];
      largest = std::abs(bend) > largest ? std::abs(bend) : largest;
    }
    return Degree * (Degree - 1) * largest;
  }

private:
  static int Changes(const double* coefficients) noexcept
  {
    int changes = 0;
    for (int n = 0; n < Degree; ++n)
    {
      changes += (coefficients[n] >= 0.0) != (coefficients[n + 1] >= 0.0) ? 1 : 0;
    }
    return changes;
  }

  void Add(double parameter) noexcept
  {
    if (this->Found < Degree)
    {
      this->Parameters[this->Found++] = parameter;
    }
  }

  void Isolate(const double* coefficients, double from, double to, int halvings) noexcept
  {
    const int changes = Changes(coefficients);
    if (changes == 0)
    {
      return;
    }
    if (changes == 1)
    {
      this->Solve(coefficients, from, to);
      return;
    }
    const double middle = 0.5 * (from + to);
    if (halvings == 0)
    {
      if ((coefficients[0] >= 0.0) != (coefficients[Degree] >= 0.0))
      {
        this->Add(middle);
      }
      return;
    }
    double left[Degree + 1];
    double right[Degree + 1];
    for (int n = 0; n <= Degree; ++n)
    {
      right[n] = coefficients[n];
    }
    for (int length = Degree; length >= 0; --length)
    {
      left[Degree - length] = right[0];
      for (int n = 0; n < length; ++n)
      {
        right[n] = 0.5 * (right[n] + right[n + 1]);
      }
    }
    this->Isolate(left, from, middle, halvings - 1);
    this->Isolate(right, middle, to, halvings - 1);
  }

  // Solves for one crossing between both ends.
  void Solve(const double* coefficients, double from, double to) noexcept
  {
    const double first = coefficients[0];
    const double last = coefficients[Degree];
    if (first == 0.0 && coefficients[1] < 0.0)
    {
      this->Add(from);
      return;
    }
    if (last == 0.0 && coefficients[Degree - 1] < 0.0)
    {
      this->Add(to);
      return;
    }
    const double chord = first / (first - last);
    const double u = Newton(coefficients, chord > 0.0 && chord < 1.0 ? chord : 0.5);
    this->Add(from + u * (to - from));
  }

  // Newton's method with bisection, if a step leaves the bracket or the slope has the wrong sign:
  // another root may be close to an end that is nearly zero. A Newton step leaves an error of its
  // square times bend / (2 slope); `error` becomes twice that, or the bracket.
  static double Newton(const double* coefficients, double u) noexcept
  {
    constexpr int MostSteps = 60;
    constexpr double Resolution = 1e-16;
    const bool startsInside = coefficients[0] >= 0.0;
    const double bend = LargestBend(coefficients);
    double low = 0.0;
    double high = 1.0;
    double error = 1.0;
    for (int n = 0; n < MostSteps && error > Resolution; ++n)
    {
      double slope = 0.0;
      const double value = Evaluate(coefficients, u, slope);
      const bool isLow = (value >= 0.0) == startsInside;
      low = isLow ? u : low;
      high = isLow ? high : u;
      const double next = u - value / slope;
      if ((slope < 0.0) == startsInside && next >= low && next <= high)
      {
        error = bend * (next - u) * (next - u) / std::abs(slope);
        u = next;
      }
      else
      {
        error = high - low;
        u = 0.5 * (low + high);
      }
    }
    return u;
  }

  int Found = 0;
  double Parameters[Degree];
};
} // namespace palpate
