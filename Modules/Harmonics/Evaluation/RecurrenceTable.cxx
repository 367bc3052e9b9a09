#include "RecurrenceTable.h"

#include "SphericalHarmonicBasis.h"
#include "SphericalHarmonicRecurrence.h"

namespace palpate
{
namespace
{
using Functions = std::vector<std::vector<double>>;

// Makes the rows of one block, orders first to first + 3.
class BlockRows
{
public:
  BlockRows(const SphericalHarmonicRecurrence& recurrence, const Functions& functions, int first)
      : Recurrence(recurrence), Coefficients(functions), First(first)
  {
  }

  void AddFirst(CacheLineVector<double>& table) const
  {
    AddLanes(
        0, [this](int, int m) { return this->Recurrence.Diagonal(m); }, table);
    this->AddCoefficients(0, table);
  }
  // Of the degrees m + k, k > 0.
  void Add(int k, CacheLineVector<double>& table) const
  {
    using Term = SphericalHarmonicRecurrence::Term;
    for (const auto constant : {&Term::Ratio, &Term::Carry, &Term::Slope})
    {
      AddLanes(
          k, [&](int l, int m) { return this->Recurrence.Column(m)[l - m - 1].*constant; }, table);
    }
    this->AddCoefficients(k, table);
  }

private:
  void AddCoefficients(int k, CacheLineVector<double>& table) const
  {
    for (const std::vector<double>& c : this->Coefficients)
    {
      AddLanes(
          k, [&c](int l, int m) { return c[SphericalHarmonicBasis::Index(l, m)]; }, table);
      AddLanes(
          k, [&c](int l, int m) { return m == 0 ? 0.0 : c[SphericalHarmonicBasis::Index(l, -m)]; },
          table);
    }
  }
  // number(l, m) for each order, at degree l = m + k.
  template <typename Number>
  void AddLanes(int k, const Number& number, CacheLineVector<double>& table) const
  {
    for (int m = this->First; m < this->First + 4; ++m)
    {
      table.push_back(m + k <= this->Recurrence.Degree() ? number(m + k, m) : 0.0);
    }
  }

  const SphericalHarmonicRecurrence& Recurrence;
  const Functions& Coefficients;
  int First;
};
} // namespace

CacheLineVector<double> MakeRecurrenceTable(int degree, const Functions& functions)
{
  const SphericalHarmonicRecurrence recurrence(degree);
  CacheLineVector<double> table;
  for (int first = 0; first <= degree; first += 4)
  {
    const BlockRows block(recurrence, functions, first);
    block.AddFirst(table);
    for (int k = 1; k <= degree - first; ++k)
    {
      block.Add(k, table);
    }
  }
  return table;
}
} // namespace palpate
