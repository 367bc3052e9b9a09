#pragma once

#include "Section.h"

#include <QScrollArea>
#include <QVBoxLayout>

#include <vector>

namespace palpate
{
/// The parts of the work below each other, in their order. It scrolls as one, and is always wide
/// enough for what it holds.
class WorkColumn : public QScrollArea
{
  Q_OBJECT

public:
  explicit WorkColumn(QWidget* parent);

  Section* Add(const QString& title, QWidget* content, bool isOpen);
  const std::vector<Section*>& Sections() const { return this->All; }
  /// Unfolds a section, and scrolls to it.
  void GoTo(Section* section);

protected:
  bool eventFilter(QObject* object, QEvent* event) override;

private:
  QVBoxLayout* Column;
  std::vector<Section*> All;
};
} // namespace palpate
