#pragma once

#include <QImage>
#include <QSize>
#include <QString>

#include <vector>

namespace palpate
{
/// A way to begin that an empty window offers.
struct StartCard
{
  enum class Kind
  {
    Prostate,
    Lesion,
    Mastoid,
    Head,
    Compare,
    Cohort
  };

  Kind Is;
  const char* Key; ///< in settings and as the name of its widget
  const char* Title;
  const char* Text; ///< what happens, and how long it takes

  static const std::vector<StartCard>& All();
};

/// A drawing for a card, of this size in pixels, the same in light and dark.
QImage DrawCard(StartCard::Kind kind, const QSize& size);
} // namespace palpate
