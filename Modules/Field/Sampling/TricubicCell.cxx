#include "TricubicCell.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr double Sixth = 1.0 / 6.0;

// The four basis functions as polar forms: symmetric in x, y, z, linear in each, and equal to the
// function's value if all three are u.
void PolarWeights(double x, double y, double z, double* weights)
{
  const double x1 = 1.0 - x;
  const double y1 = 1.0 - y;
  const double z1 = 1.0 - z;
  const double low = x1 * y1 * z1;
  const double high = x * y * z;
  weights[0] = Sixth * low;
  weights[1] = Sixth * (4.0 - 2.0 * (x * y + y * z + z * x) + 3.0 * high);
  weights[2] = Sixth * (4.0 - 2.0 * (x1 * y1 + y1 * z1 + z1 * x1) + 3.0 * low);
  weights[3] = Sixth * high;
}

void Weights(double u, double* weights)
{
  PolarWeights(u, u, u, weights);
}

void Slopes(double u, double* slopes)
{
  const double v = 1.0 - u;
  slopes[0] = -0.5 * v * v;
  slopes[1] = u * (1.5 * u - 2.0);
  slopes[2] = v * (2.0 - 1.5 * v);
  slopes[3] = 0.5 * u * u;
}

// Along k, then j, then i: the order shared with inside tests of several points (InsideKernel.h).
double Contract(const double* nodes, const double* x, const double* y, const double* z)
{
  double slice[4] = {};
  for (int j = 0; j < 4; ++j)
  {
    const double* row = nodes + 4 * j;
    for (int i = 0; i < 4; ++i)
    {
      const double column =
          row[i] * z[0] + row[16 + i] * z[1] + row[32 + i] * z[2] + row[48 + i] * z[3];
      slice[i] = j == 0 ? column * y[0] : slice[i] + column * y[j];
    }
  }
  return slice[0] * x[0] + slice[1] * x[1] + slice[2] * x[2] + slice[3] * x[3];
}

// The basis functions along a segment: Bernstein coefficients times binomials, so that products of
// polynomials are convolutions.
struct SegmentWeights
{
  double Scaled[4][4]; ///< [function][coefficient]

  SegmentWeights(double from, double to)
  {
    double weights[4][4];
    PolarWeights(from, from, from, weights[0]);
    PolarWeights(from, from, to, weights[1]);
    PolarWeights(from, to, to, weights[2]);
    PolarWeights(to, to, to, weights[3]);
    for (int function = 0; function < 4; ++function)
    {
      this->Scaled[function][0] = weights[0][function];
      this->Scaled[function][1] = 3.0 * weights[1][function];
      this->Scaled[function][2] = 3.0 * weights[2][function];
      this->Scaled[function][3] = weights[3][function];
    }
  }
};

// sum_f nodes[f] weights[f], of degree 3.
void Combine(const double* nodes, const SegmentWeights& weights, double* sum)
{
  double total[4] = {};
  for (int function = 0; function < 4; ++function)
  {
    for (int c = 0; c < 4; ++c)
    {
      total[c] += nodes[function] * weights.Scaled[function][c];
    }
  }
  std::copy_n(total, 4, sum);
}

// sum_f polynomials[f] weights[f], of degree `degree` + 3.
template <int degree>
void Convolve(const double (*polynomials)[degree + 1], const SegmentWeights& weights,
              double* product)
{
  double total[degree + 4] = {};
  for (int function = 0; function < 4; ++function)
  {
    for (int w = 0; w < 4; ++w)
    {
      const double weight = weights.Scaled[function][w];
      for (int c = 0; c <= degree; ++c)
      {
        total[c + w] += polynomials[function][c] * weight;
      }
    }
  }
  std::copy_n(total, degree + 4, product);
}
} // namespace

double TricubicCell::Value(const double* u) const noexcept
{
  double weights[3][4];
  for (int axis = 0; axis < 3; ++axis)
  {
    Weights(u[axis], weights[axis]);
  }
  return Contract(this->Nodes, weights[0], weights[1], weights[2]);
}

void TricubicCell::Gradient(const double* u, double* gradient) const noexcept
{
  double weights[3][4];
  double slopes[3][4];
  for (int axis = 0; axis < 3; ++axis)
  {
    Weights(u[axis], weights[axis]);
    Slopes(u[axis], slopes[axis]);
  }
  gradient[0] = Contract(this->Nodes, slopes[0], weights[1], weights[2]);
  gradient[1] = Contract(this->Nodes, weights[0], slopes[1], weights[2]);
  gradient[2] = Contract(this->Nodes, weights[0], weights[1], slopes[2]);
}

void TricubicCell::Restrict(const double* from, const double* to, double* bernstein) const noexcept
{
  const SegmentWeights x(from[0], to[0]);
  const SegmentWeights y(from[1], to[1]);
  const SegmentWeights z(from[2], to[2]);
  double slices[4][7];
  for (int k = 0; k < 4; ++k)
  {
    double rows[4][4];
    for (int j = 0; j < 4; ++j)
    {
      Combine(this->Nodes + 16 * k + 4 * j, x, rows[j]);
    }
    Convolve<3>(rows, y, slices[k]);
  }
  Convolve<6>(slices, z, bernstein);
  constexpr double Binomials[] = {1, 9, 36, 84, 126, 126, 84, 36, 9, 1};
  for (int c = 0; c <= Degree; ++c)
  {
    bernstein[c] /= Binomials[c];
  }
}
} // namespace palpate
