#pragma once

#include <QPushButton>
#include <QString>
#include <QWidget>

namespace palpate
{
/// The row of an activity in the strip: what is to be done, and buttons that leave the keys with
/// the views.
class ActivityRow
{
public:
  ActivityRow(QWidget& activity, const QString& text);

  /// With a key that presses the button at once; 0: none.
  QPushButton* AddButton(const QString& text, const char* name, int key = 0);

private:
  QWidget& Activity;
};
} // namespace palpate
