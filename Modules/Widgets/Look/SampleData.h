#pragma once

#include <QStringList>

#include <vector>

namespace palpate
{
/// Files to try the program with.
struct SampleData
{
  QString Title;
  QString Package; ///< of Debian, that brings them
  QStringList Files;

  bool IsThere() const;
  static const std::vector<SampleData>& All();
  /// The one of the documentation: a head and its 116 structures.
  static const SampleData& Head() { return All().front(); }
};
} // namespace palpate
