#pragma once

#include <QLabel>

namespace palpate
{
/// Plain text in a panel with room for its longest sentence, whatever it says now: views must not
/// move under a pointer that draws.
class SentenceLabel : public QLabel
{
public:
  SentenceLabel(const char* name, int longest, QWidget* parent);

  /// Also as its tool tip.
  void Say(const QString& sentence);

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  int Longest; ///< letters
};
} // namespace palpate
