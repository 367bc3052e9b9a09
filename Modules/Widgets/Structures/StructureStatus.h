#pragma once

#include "StructureVerdicts.h"

#include <QString>
#include <QVariant>

#include <optional>

namespace palpate
{
/// What the table of structures says of one: whether its mask is believable, whether the border of
/// the image cuts it, and what drilling did.
struct StructureStatus
{
  const StructureVerdict* Verdict = nullptr; ///< null if it is not checked
  std::optional<double> Cut;                 ///< mm^2 of its surface; none if it is whole
  QString Drilled;

  /// In a few words, with a sign for the verdict.
  QString Text() const;
  /// Sorts what is implausible first and what says nothing last.
  QString SortText() const;
  QString ToolTip() const;
  /// Of the text, as a brush; none: as other text.
  QVariant Color() const;
};
} // namespace palpate
