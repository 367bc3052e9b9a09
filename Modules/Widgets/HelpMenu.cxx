#include "HelpMenu.h"

#include "SoftwareVersions.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QScreen>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace palpate
{
namespace
{
constexpr const char* MouseText =
    "<p><b>Slices</b>: left drag moves the crosshair (with Ctrl: window and level; the other way "
    "round if preferred or chosen in View), Shift moves the crosshair without a button, wheel "
    "scrolls, Ctrl+wheel or right drag zooms, middle or Shift+left drag pans, arrows and page keys "
    "scroll, "
    "R fits. Double "
    "click: one view alone, or all again.</p>"
    "<p><b>3-D</b>: left drag rotates, middle drag pans, right drag or wheel zooms. While "
    "touching, the tool rests on the surface under the pointer: a left press pushes it in, harder "
    "the longer it is held, the wheel pushes without a button, and dragging strokes along the "
    "surface; in a slice a left press leads the tool to the pointer. Beside what can be touched, "
    "and with Ctrl or Shift, the mouse moves the camera. With Move workspace on, a left drag moves "
    "the device's workspace, and the wheel moves it in depth.</p>"
    "<p><b>Return</b>, in a view: ends a curve that is measured. <b>D</b>, held: drills. "
    "<b>Esc</b> stops all force, anywhere in the program.</p>";

void ShowText(QWidget* window, const QString& title, const QString& html)
{
  constexpr double MostOfScreen = 0.8;
  auto* dialog = new QDialog(window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(title);
  auto* text = new QTextBrowser(dialog);
  text->setOpenExternalLinks(true);
  text->setHtml(html);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::close);
  auto* column = new QVBoxLayout(dialog);
  column->addWidget(text, 1);
  column->addWidget(buttons);
  // As high as the text at that width, which a document has only when it is given.
  const int width = text->fontMetrics().averageCharWidth() * 76;
  text->document()->setTextWidth(width - 40);
  const QSize wanted(width, static_cast<int>(text->document()->size().height()) + 80);
  dialog->resize(wanted.boundedTo(window->screen()->availableSize() * MostOfScreen));
  dialog->show();
}

QString AboutText()
{
  QString libraries = QString("Qt %1").arg(qVersion());
  QString version;
  for (const auto& [name, number] : SoftwareVersions())
  {
    const QString text = QString::fromStdString(name + " " + number).toHtmlEscaped();
    (name == "Palpate" ? version : libraries) += (name == "Palpate" ? text : ", " + text);
  }
  return QString("<h3>%1</h3>"
                 "<p>Spherical-harmonic organ models for display and touch.</p>"
                 "<p>For research. Not a medical device, and not for diagnosis or treatment.</p>"
                 "<p>Licence: BSD, 3 clauses. Libraries: %2.</p>")
      .arg(version, libraries);
}
} // namespace

HelpMenu::HelpMenu(QWidget* window) : QMenu("&Help", window), Window(window)
{
  this->addAction(
      "&Shortcuts and mouse", this,
      [this] { ShowText(this->Window, "Shortcuts and mouse", this->ShortcutText()); },
      QKeySequence::HelpContents);
  this->addAction("&About", this, [this] { ShowText(this->Window, "About Palpate", AboutText()); });
}

QString HelpMenu::ShortcutText() const
{
  QString rows;
  for (const QAction* action : this->Window->findChildren<QAction*>())
  {
    const QString key = action->shortcut().toString(QKeySequence::NativeText);
    if (!key.isEmpty())
    {
      // Without the step that would be undone.
      const QString name = action->text().remove('&').section(": ", 0, 0);
      rows += QString("<tr><td>%1&nbsp;&nbsp;</td><td>%2</td></tr>")
                  .arg(key.toHtmlEscaped(), name.toHtmlEscaped());
    }
  }
  return MouseText + QString("<table>%1</table>").arg(rows);
}
} // namespace palpate
