#include "MomentTables.h"

#include "GaussLegendre.h"
#include "SphericalHarmonicBasis.h"

#include <cmath>

namespace palpate
{
namespace
{
using Real = long double;
using moments::OrdersPerFamily;

int RoundedUp(int count, int lanes)
{
  return (count + lanes - 1) / lanes * lanes;
}

// The plain recurrence is Q_lm = a_lm (z Q_(l-1)m - b_lm Q_(l-2)m) with b_lm = 1 / a_(l-1)m.
double Back(const SphericalHarmonicRecurrence& harmonics, int degree, int order)
{
  return degree > order + 1 ? 1.0 / harmonics.Column(order)[degree - order - 2].Slope : 0.0;
}

// Q_lm(z) of one order for l = m .. last.
std::vector<double> HarmonicColumn(const SphericalHarmonicRecurrence& harmonics, int order,
                                   int last, double z)
{
  const SphericalHarmonicRecurrence::Term* term = harmonics.Column(order);
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(last - order + 1));
  values.push_back(harmonics.Diagonal(order));
  double previous = 0.0;
  for (int l = order + 1; l <= last; ++l, ++term)
  {
    const double next = term->Slope * (z * values.back() - Back(harmonics, l, order) * previous);
    previous = values.back();
    values.push_back(next);
  }
  return values;
}

// z times a combination of a family's polynomials: z p_k = (p_(k+1) + factor_(k+1) p_(k-1)) / 2.
std::vector<Real> TimesZ(const std::vector<Real>& terms, const double* factors)
{
  std::vector<Real> result(terms.size() + 1, 0.0L);
  for (std::size_t k = 0; k < terms.size(); ++k)
  {
    result[k + 1] += terms[k] / 2;
    if (k > 0)
    {
      result[k - 1] += factors[k + 1] * terms[k] / 2;
    }
  }
  return result;
}
} // namespace

MomentTables::MomentTables(int degree, int lanes)
    : MaximumDegree(degree), Stride(RoundedUp(degree + 1, lanes))
{
  const SphericalHarmonicRecurrence harmonics(2 * degree);
  this->MakeFactors(harmonics);
  this->MakeConversions(harmonics);
  this->MakeNodes();
  this->MakeFamilyValues(harmonics);
  this->MakeBlocks(harmonics, lanes);
}

void MomentTables::MakeFactors(const SphericalHarmonicRecurrence& harmonics)
{
  const int last = 2 * this->MaximumDegree;
  for (int first = 0; first <= last; first += OrdersPerFamily)
  {
    const std::size_t start = this->Factors.size();
    this->Factors.resize(start + static_cast<std::size_t>(last) + 1, 0.0);
    for (int k = 1; k <= last - first; ++k)
    {
      const double back = Back(harmonics, first + k, first);
      this->Factors[start + static_cast<std::size_t>(k)] = 4.0 * back * back;
    }
  }
}

// The recurrence of the harmonics, on coefficients of the family's polynomials.
void MomentTables::MakeConversions(const SphericalHarmonicRecurrence& harmonics)
{
  for (int m = 0; m <= this->MaximumDegree; ++m)
  {
    const double* factors =
        this->Factors.data() + m / OrdersPerFamily * this->FamilyRecurrence().Stride;
    const SphericalHarmonicRecurrence::Term* term = harmonics.Column(m);
    std::vector<Real> previous;
    std::vector<Real> current{harmonics.Diagonal(m)};
    for (int l = m; l <= this->MaximumDegree; ++l)
    {
      if (l > m)
      {
        std::vector<Real> next = TimesZ(current, factors);
        const double back = Back(harmonics, l, m);
        for (std::size_t k = 0; k < previous.size(); ++k)
        {
          next[k] -= back * previous[k];
        }
        for (Real& value : next)
        {
          value *= term->Slope;
        }
        previous = std::move(current);
        current = std::move(next);
        ++term;
      }
      this->Conversions.insert(this->Conversions.end(), current.begin(), current.end());
    }
  }
}

void MomentTables::FromHarmonics(const double* coefficients, double* pairs) const noexcept
{
  const double* conversion = this->Conversions.data();
  for (int m = 0; m <= this->MaximumDegree; ++m)
  {
    double* order = pairs + 2 * moments::MomentStart(this->MaximumDegree, m);
    for (int k = 0; k <= this->MaximumDegree - m; ++k)
    {
      order[2 * k] = 0.0;
      order[2 * k + 1] = 0.0;
    }
    for (int l = m; l <= this->MaximumDegree; ++l)
    {
      const double cosine = coefficients[SphericalHarmonicBasis::Index(l, m)];
      const double sine = m > 0 ? coefficients[SphericalHarmonicBasis::Index(l, -m)] : 0.0;
      for (int k = (l - m) % 2; k <= l - m; k += 2)
      {
        order[2 * k] += conversion[k] * cosine;
        order[2 * k + 1] += conversion[k] * sine;
      }
      conversion += l - m + 1;
    }
  }
}

void MomentTables::ToHarmonics(const double* pairs, double* sums) const noexcept
{
  const double* conversion = this->Conversions.data();
  for (int m = 0; m <= this->MaximumDegree; ++m)
  {
    const double* order = pairs + 2 * moments::MomentStart(this->MaximumDegree, m);
    for (int l = m; l <= this->MaximumDegree; ++l)
    {
      double cosine = 0.0;
      double sine = 0.0;
      for (int k = (l - m) % 2; k <= l - m; k += 2)
      {
        cosine += conversion[k] * order[2 * k];
        sine += conversion[k] * order[2 * k + 1];
      }
      if (m > 0)
      {
        sums[SphericalHarmonicBasis::Index(l, -m)] = sine;
      }
      sums[SphericalHarmonicBasis::Index(l, m)] = cosine;
      conversion += l - m + 1;
    }
  }
}

void MomentTables::MakeNodes()
{
  const GaussLegendre quadrature(2 * this->MaximumDegree + 1);
  const auto middle = static_cast<std::size_t>(this->MaximumDegree);
  this->NodeZ.assign(quadrature.Nodes.begin() + static_cast<std::ptrdiff_t>(middle),
                     quadrature.Nodes.end());
  this->NodeZ.front() = 0.0;
  for (std::size_t k = middle; k < quadrature.Weights.size(); ++k)
  {
    this->NodeWeights.push_back(quadrature.Weights[k] * (k == middle ? 1.0 : 2.0));
  }
}

// The product with every moment recovers the measure at the nodes, because the harmonics of the
// family's first order are orthonormal.
void MomentTables::MakeFamilyValues(const SphericalHarmonicRecurrence& harmonics)
{
  const int last = 2 * this->MaximumDegree;
  const auto stride = static_cast<std::size_t>(this->Stride);
  for (int first = 0; first <= last; first += OrdersPerFamily)
  {
    const std::size_t start = this->FamilyValues.size();
    this->FamilyStarts.push_back(start);
    this->FamilyValues.resize(start + stride * static_cast<std::size_t>(last - first + 1), 0.0);
    for (std::size_t node = 0; node < this->NodeZ.size(); ++node)
    {
      const double z = this->NodeZ[node];
      const double measure = this->NodeWeights[node] *
                             std::pow((1.0 - z) * (1.0 + z), 0.5 * first) *
                             (first == 0 ? 2.0 * M_PI : M_PI);
      const std::vector<double> column = HarmonicColumn(harmonics, first, last, z);
      const SphericalHarmonicRecurrence::Term* term = harmonics.Column(first);
      double scale = harmonics.Diagonal(first); // of Q_lm over p_k
      for (std::size_t k = 0; k < column.size(); ++k)
      {
        this->FamilyValues[start + k * stride + node] = measure * scale * column[k];
        if (k + 1 < column.size())
        {
          scale *= term[k].Slope / 2.0;
        }
      }
    }
  }
  this->Powers.resize(stride * OrdersPerFamily, 0.0);
  for (std::size_t m = 0; m < OrdersPerFamily; ++m)
  {
    for (std::size_t node = 0; node < this->NodeZ.size(); ++node)
    {
      const double z = this->NodeZ[node];
      this->Powers[m * stride + node] =
          std::pow((1.0 - z) * (1.0 + z), -0.5 * static_cast<double>(m));
    }
  }
}

void MomentTables::MakeBlocks(const SphericalHarmonicRecurrence& harmonics, int lanes)
{
  for (int m = 0; m <= this->MaximumDegree; ++m)
  {
    std::vector<std::vector<double>> columns;
    for (const double z : this->NodeZ)
    {
      columns.push_back(HarmonicColumn(harmonics, m, this->MaximumDegree, z));
      const double power = std::pow((1.0 - z) * (1.0 + z), 0.5 * m);
      for (double& value : columns.back())
      {
        value *= power;
      }
    }
    for (int parity = 0; parity <= 1; ++parity)
    {
      const int rows = (this->MaximumDegree - m - parity + 2) / 2;
      BlockPlace block{rows, RoundedUp(rows, lanes), this->BlockValues.size(), 0};
      block.ByNode = block.ByRow + static_cast<std::size_t>(rows * this->Stride);
      this->BlockValues.resize(
          block.ByNode + static_cast<std::size_t>(this->Nodes() * block.Columns), 0.0);
      for (int row = 0; row < rows; ++row)
      {
        for (int node = 0; node < this->Nodes(); ++node)
        {
          const double value =
              columns[static_cast<std::size_t>(node)][static_cast<std::size_t>(2 * row + parity)];
          this->BlockValues[block.ByRow + static_cast<std::size_t>(row * this->Stride + node)] =
              value;
          this->BlockValues[block.ByNode + static_cast<std::size_t>(node * block.Columns + row)] =
              value;
        }
      }
      this->Blocks.push_back(block);
    }
  }
}

const double* MomentTables::NodeValues(int order, int column) const noexcept
{
  return this->FamilyValues.data() +
         this->FamilyStarts[static_cast<std::size_t>(order / OrdersPerFamily)] +
         static_cast<std::size_t>(column) * static_cast<std::size_t>(this->Stride);
}

MomentTables::Block MomentTables::HarmonicsAtNodes(int order, int parity) const noexcept
{
  const BlockPlace& place = this->Blocks[static_cast<std::size_t>(2 * order + parity)];
  return {place.Rows, place.Columns, this->BlockValues.data() + place.ByRow,
          this->BlockValues.data() + place.ByNode};
}
} // namespace palpate
