#include "SphericalHarmonicRotation.h"

#include "SphericalHarmonicBasis.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
using Real = long double;
using RealMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

// Rotation matrices may be rounded by files or float arithmetic.
constexpr double MatrixTolerance = 1e-6;

// d^l_mk(pi/2), m and k from 0 to l, from those of degree l - 1 (Trapani and Navaza 2006): the
// highest row from the degree below, the others downwards, which is the stable order.
RealMatrix NextWigner(int l, const RealMatrix& lower)
{
  RealMatrix d = RealMatrix::Zero(l + 1, l + 1);
  const Real degree = l;
  d(l, 0) = std::sqrt((2 * degree - 1) / (2 * degree)) * lower(l - 1, 0);
  for (int k = 1; k <= l; ++k)
  {
    d(l, k) = std::sqrt(degree * (2 * degree - 1) / (2 * (degree + k) * (degree + k - 1))) *
              lower(l - 1, k - 1);
  }
  for (int m = l - 1; m >= 0; --m)
  {
    const Real span = (degree - m) * (degree + m + 1);
    const Real slope = 2 / std::sqrt(span);
    const Real fall = std::sqrt((degree - m - 1) * (degree + m + 2) / span);
    for (int k = 0; k <= l; ++k)
    {
      d(m, k) = k * slope * d(m + 1, k) - (m + 2 <= l ? fall * d(m + 2, k) : 0.0L);
    }
  }
  return d;
}

// Wigner's d in the real basis, with the signs that result from exchanging y and z.
Eigen::MatrixXd ExchangeOf(const RealMatrix& wigner)
{
  const auto last = static_cast<int>(wigner.rows()) - 1;
  Eigen::MatrixXd exchange(last + 1, last + 1);
  const Real root2 = std::sqrt(2.0L);
  for (int m = 0; m <= last; ++m)
  {
    for (int k = 0; k <= last; ++k)
    {
      // Equal parities: (m - k) / 2; else the even one of l - m and l - k counts one more.
      const bool same = (m - k) % 2 == 0;
      const int steps = same ? (m - k) / 2 : ((last - m) % 2 == 0 ? m - k - 1 : k - m - 1) / 2;
      const Real sign = steps % 2 == 0 ? 1.0L : -1.0L;
      const Real factor = (m == 0 ? 1.0L : root2) * (k == 0 ? 1.0L : root2);
      exchange(m, k) = static_cast<double>(sign * factor * wigner(m, k));
    }
  }
  return exchange;
}

bool IsRotation(const Eigen::Matrix3d& matrix)
{
  const Eigen::Matrix3d off = matrix.transpose() * matrix - Eigen::Matrix3d::Identity();
  // Entry by entry, so that NaN fails; maxCoeff may skip it.
  return (off.array().abs() <= MatrixTolerance).all() && matrix.determinant() > 0.0;
}
} // namespace

struct SphericalHarmonicRotation::Orders
{
  std::vector<double> Cosines;
  std::vector<double> Sines;

  explicit Orders(int degree)
      : Cosines(static_cast<std::size_t>(degree) + 1, 0.0),
        Sines(static_cast<std::size_t>(degree) + 1, 0.0)
  {
  }
  void Load(int l, const double* coefficients)
  {
    const double* const center = coefficients + SphericalHarmonicBasis::Index(l, 0);
    for (int m = 0; m <= l; ++m)
    {
      this->Cosines[static_cast<std::size_t>(m)] = center[m];
      this->Sines[static_cast<std::size_t>(m)] = m == 0 ? 0.0 : center[-m];
    }
  }
  void Store(int l, double* coefficients) const
  {
    double* const center = coefficients + SphericalHarmonicBasis::Index(l, 0);
    for (int m = l; m >= 0; --m)
    {
      center[-m] = this->Sines[static_cast<std::size_t>(m)];
      center[m] = this->Cosines[static_cast<std::size_t>(m)];
    }
  }
};

SphericalHarmonicRotation::SphericalHarmonicRotation()
    : SphericalHarmonicRotation(0, Eigen::Matrix3d::Identity())
{
}

SphericalHarmonicRotation::SphericalHarmonicRotation(int degree, const Eigen::Matrix3d& rotation)
    : MaximumDegree(degree)
{
  const Eigen::Quaternion<Real> q =
      Eigen::Quaternion<Real>(Eigen::Matrix<Real, 3, 3>(rotation.cast<Real>())).normalized();
  this->Rotation = q.toRotationMatrix().cast<double>();
  // Half the sum and half the difference of alpha and gamma. Where one of them is undefined (beta
  // 0 or pi), any value is correct.
  const Real halfSum = std::atan2(q.z(), q.w());
  const Real halfDifference = std::atan2(-q.x(), q.y());
  const Real beta = 2 * std::atan2(std::hypot(q.x(), q.y()), std::hypot(q.z(), q.w()));
  this->First = MakeTurn(degree, halfSum - halfDifference);
  this->Middle = MakeTurn(degree, -beta);
  this->Last = MakeTurn(degree, halfSum + halfDifference);
  RealMatrix wigner = RealMatrix::Ones(1, 1);
  this->Exchanges.push_back(ExchangeOf(wigner));
  for (int l = 1; l <= degree; ++l)
  {
    wigner = NextWigner(l, wigner);
    this->Exchanges.push_back(ExchangeOf(wigner));
  }
}

Status SphericalHarmonicRotation::Make(int degree, const Eigen::Matrix3d& rotation,
                                       SphericalHarmonicRotation& result)
{
  if (degree < 0)
  {
    return Status::Failure("a rotation of coefficients needs a degree of at least 0");
  }
  if (!IsRotation(rotation))
  {
    return Status::Failure("the matrix is not a rotation: its columns must be perpendicular, of "
                           "length 1 and right-handed");
  }
  result = SphericalHarmonicRotation(degree, rotation);
  return Status::Success();
}

SphericalHarmonicRotation::Turn SphericalHarmonicRotation::MakeTurn(int degree, long double angle)
{
  Turn turn;
  for (int m = 0; m <= degree; ++m)
  {
    turn.Cosines.push_back(static_cast<double>(std::cos(m * angle)));
    turn.Sines.push_back(static_cast<double>(std::sin(m * angle)));
  }
  return turn;
}

// Rotates the function by the angle about z: cos m (phi - angle), sin m (phi - angle).
void SphericalHarmonicRotation::Rotate(const Turn& turn, int degree, Orders& orders)
{
  for (std::size_t m = 0; m <= static_cast<std::size_t>(degree); ++m)
  {
    const double cosine = orders.Cosines[m];
    const double sine = orders.Sines[m];
    orders.Cosines[m] = cosine * turn.Cosines[m] - sine * turn.Sines[m];
    orders.Sines[m] = cosine * turn.Sines[m] + sine * turn.Cosines[m];
  }
}

// The exchange of y and z keeps parities, so entry (m, k) couples a single pair: to the cosine of
// order m where l - k is even, else to its sine; from the cosine of order k where l - m is even,
// else from its sine.
void SphericalHarmonicRotation::Exchange(int degree, const Orders& from, Orders& to) const
{
  const Eigen::MatrixXd& j = this->Exchanges[static_cast<std::size_t>(degree)];
  for (int m = 0; m <= degree; ++m)
  {
    const double* const column = j.col(m).data(); // J is symmetric
    const double* const source = (degree - m) % 2 == 0 ? from.Cosines.data() : from.Sines.data();
    double same = 0.0;
    double other = 0.0;
    for (int k = degree; k >= 0; k -= 2)
    {
      same += column[k] * source[k];
    }
    for (int k = degree - 1; k >= 0; k -= 2)
    {
      other += column[k] * source[k];
    }
    to.Cosines[static_cast<std::size_t>(m)] = same;
    to.Sines[static_cast<std::size_t>(m)] = other;
  }
  to.Sines[0] = 0.0;
}

void SphericalHarmonicRotation::ApplyToDegree(int degree, Orders& orders, Orders& scratch) const
{
  Rotate(this->First, degree, orders);
  this->Exchange(degree, orders, scratch);
  Rotate(this->Middle, degree, scratch);
  this->Exchange(degree, scratch, orders);
  Rotate(this->Last, degree, orders);
}

void SphericalHarmonicRotation::Apply(const double* coefficients, double* rotated) const
{
  Orders orders(this->MaximumDegree);
  Orders scratch(this->MaximumDegree);
  for (int l = 0; l <= this->MaximumDegree; ++l)
  {
    orders.Load(l, coefficients);
    this->ApplyToDegree(l, orders, scratch);
    orders.Store(l, rotated);
  }
}

Eigen::MatrixXd SphericalHarmonicRotation::Block(int degree) const
{
  const int size = 2 * degree + 1;
  Eigen::MatrixXd block(size, size);
  Orders orders(degree);
  Orders scratch(degree);
  for (int column = 0; column < size; ++column)
  {
    std::fill(orders.Cosines.begin(), orders.Cosines.end(), 0.0);
    std::fill(orders.Sines.begin(), orders.Sines.end(), 0.0);
    const int order = column - degree;
    (order < 0 ? orders.Sines : orders.Cosines)[static_cast<std::size_t>(std::abs(order))] = 1.0;
    this->ApplyToDegree(degree, orders, scratch);
    for (int row = 0; row < size; ++row)
    {
      const int m = row - degree;
      block(row, column) =
          (m < 0 ? orders.Sines : orders.Cosines)[static_cast<std::size_t>(std::abs(m))];
    }
  }
  return block;
}

SphericalHarmonicModel SphericalHarmonicRotation::Apply(const SphericalHarmonicModel& model) const
{
  return this->ApplyAbout(model.CenterWorld(), model);
}

SphericalHarmonicModel
SphericalHarmonicRotation::ApplyAbout(const Vector3& pivotWorld,
                                      const SphericalHarmonicModel& model) const
{
  std::vector<double> coefficients = model.Coefficients();
  coefficients.resize(SphericalHarmonicBasis::CoefficientCount(this->MaximumDegree), 0.0);
  this->Apply(coefficients.data(), coefficients.data());
  return {this->MaximumDegree, std::move(coefficients),
          pivotWorld + this->Rotation * (model.CenterWorld() - pivotWorld)};
}
} // namespace palpate
