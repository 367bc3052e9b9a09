#pragma once

#include <QStringList>

namespace palpate
{
/// Files to try the program with.
struct SampleData
{
  QString Package; ///< of Debian, that brings them
  QStringList Files;

  bool IsThere() const;
  /// A head and its 116 structures (Colin 27, AAL).
  static const SampleData& Head();
};
} // namespace palpate
