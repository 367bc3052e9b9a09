#pragma once

#include "TouchNotice.h"

#include <QLabel>

namespace palpate
{
/// A notice over the upper edge of a view: in a small one, only its first sentence. It lets the
/// mouse through and does not move the view.
class ViewBanner : public QLabel
{
  Q_OBJECT

public:
  explicit ViewBanner(QWidget* view);

  void Show(const TouchNotice& notice);

protected:
  bool eventFilter(QObject* object, QEvent* event) override;

private:
  void Place();

  TouchNotice::Kind Kind = TouchNotice::Kind::None;
  QString Whole;
};
} // namespace palpate
