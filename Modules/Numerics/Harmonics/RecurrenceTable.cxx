#include "RecurrenceTable.h"

#include "SphericalHarmonicBasis.h"
#include "SphericalHarmonicRecurrence.h"

#include <array>

namespace palpate
{
namespace
{
// The entries of one order in one row.
struct Entry
{
  SphericalHarmonicRecurrence::Term Term{0.0, 0.0, 0.0};
  double Cosine = 0.0;
  double Sine = 0.0;
};

Entry EntryOf(const SphericalHarmonicRecurrence& recurrence,
              const std::vector<double>& coefficients, int l, int m)
{
  Entry entry;
  if (l > recurrence.Degree())
  {
    return entry;
  }
  if (l > m)
  {
    entry.Term = recurrence.Column(m)[l - m - 1];
  }
  entry.Cosine = coefficients[SphericalHarmonicBasis::Index(l, m)];
  entry.Sine = m == 0 ? 0.0 : coefficients[SphericalHarmonicBasis::Index(l, -m)];
  return entry;
}

template <typename Number>
void AddLanes(const std::array<Entry, 4>& entries, const Number& number,
              CacheLineVector<double>& table)
{
  for (const Entry& entry : entries)
  {
    table.push_back(number(entry));
  }
}
} // namespace

CacheLineVector<double> MakeRecurrenceTable(int degree, const std::vector<double>& coefficients)
{
  const SphericalHarmonicRecurrence recurrence(degree);
  CacheLineVector<double> table;
  for (int first = 0; first <= degree; first += 4)
  {
    for (int lane = 0; lane < 4; ++lane)
    {
      table.push_back(first + lane <= degree ? recurrence.Diagonal(first + lane) : 0.0);
    }
    for (int k = 0; k <= degree - first; ++k)
    {
      std::array<Entry, 4> entries;
      for (int lane = 0; lane < 4; ++lane)
      {
        const int m = first + lane;
        entries[static_cast<std::size_t>(lane)] = EntryOf(recurrence, coefficients, m + k, m);
      }
      if (k > 0)
      {
        AddLanes(
            entries, [](const Entry& e) { return e.Term.Ratio; }, table);
        AddLanes(
            entries, [](const Entry& e) { return e.Term.Carry; }, table);
        AddLanes(
            entries, [](const Entry& e) { return e.Term.Slope; }, table);
      }
      AddLanes(
          entries, [](const Entry& e) { return e.Cosine; }, table);
      AddLanes(
          entries, [](const Entry& e) { return e.Sine; }, table);
    }
  }
  return table;
}

} // namespace palpate
