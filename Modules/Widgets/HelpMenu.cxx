#include "HelpMenu.h"

#include <QMessageBox>

namespace palpate
{
namespace
{
constexpr const char* MouseText =
    "<p><b>Slices</b>: left drag moves the crosshair (with Ctrl: window and level), wheel scrolls, "
    "Ctrl+wheel or right drag zooms, middle drag pans, arrows and page keys scroll, R fits. Double "
    "click: one view alone, or all again.</p>"
    "<p><b>3-D</b>: left drag rotates, middle drag pans, right drag or wheel zooms. While "
    "touching, the mouse moves the hand and the wheel sets its depth; with Ctrl or Shift the mouse "
    "moves the camera. With Move workspace on, a left drag moves the device's workspace, and the "
    "wheel moves it in depth.</p>"
    "<p><b>Esc</b> stops all force, anywhere in the window.</p>";
constexpr const char* AboutText =
    "<p><b>Palpate</b>: spherical-harmonic organ models for display and touch.</p>"
    "<p>For research. Not a medical device, and not for diagnosis or treatment.</p>";

void Show(QWidget* window, const QString& title, const QString& text)
{
  auto* box = new QMessageBox(QMessageBox::NoIcon, title, text, QMessageBox::Close, window);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setModal(false);
  box->show();
}
} // namespace

HelpMenu::HelpMenu(QWidget* window) : QMenu("&Help", window), Window(window)
{
  this->addAction(
      "&Shortcuts and mouse", this,
      [this] { Show(this->Window, "Shortcuts and mouse", this->ShortcutText()); },
      QKeySequence::HelpContents);
  this->addAction("&About", this, [this] { Show(this->Window, "About Palpate", AboutText); });
}

QString HelpMenu::ShortcutText() const
{
  QString rows;
  for (const QAction* action : this->Window->findChildren<QAction*>())
  {
    const QString key = action->shortcut().toString(QKeySequence::NativeText);
    if (!key.isEmpty())
    {
      rows += QString("<tr><td>%1&nbsp;&nbsp;</td><td>%2</td></tr>")
                  .arg(key.toHtmlEscaped(), action->text().remove('&').toHtmlEscaped());
    }
  }
  return QString("<table>%1</table>").arg(rows) + MouseText;
}
} // namespace palpate
