#include "WindowLook.h"

#include "TextContrast.h"
#include "WindowTest.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>
#include <QTableView>

#include <algorithm>
#include <unordered_map>

namespace palpate::window_look_test
{
namespace
{
// Contrast of a drawn widget: its background is the most frequent colour, its text the one that
// differs most from it. Edges of letters are blended with the background, their centres are not.
double DrawnContrast(QWidget& widget)
{
  const QImage image = widget.grab().toImage().convertToFormat(QImage::Format_RGB32);
  std::unordered_map<QRgb, int> counts;
  for (int row = 0; row < image.height(); ++row)
  {
    for (int column = 0; column < image.width(); ++column)
    {
      ++counts[image.pixel(column, row)];
    }
  }
  const auto most =
      std::max_element(counts.begin(), counts.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  double contrast = 1.0;
  for (const auto& [color, count] : counts)
  {
    contrast = std::max(contrast, ContrastRatio(QColor(most->first), QColor(color)));
  }
  return contrast;
}

class WindowLookTest : public test::WindowTest
{
protected:
  // Enabled widgets that show text.
  std::vector<QWidget*> Words() const
  {
    std::vector<QWidget*> words;
    const auto add = [&words](QWidget* widget, const QString& text)
    {
      if (widget->isVisible() && widget->isEnabled() && !text.trimmed().isEmpty())
      {
        words.push_back(widget);
      }
    };
    for (auto* label : this->Window->findChildren<QLabel*>())
    {
      add(label, label->text());
    }
    for (auto* button : this->Window->findChildren<QAbstractButton*>())
    {
      add(button, button->text());
    }
    for (auto* box : this->Window->findChildren<QComboBox*>())
    {
      add(box, box->currentText());
    }
    for (const char* name : {"structures", "messages"})
    {
      add(this->Window->findChild<QWidget*>(name), name);
    }
    return words;
  }
  QColor Ground() const { return this->Window->palette().color(QPalette::Window); }
};

TEST_F(WindowLookTest, TextIsReadableInBothLooks)
{
  this->OpenPhantom(); // shows a message on its horseshoe
  this->Button("stop-force")->setEnabled(true);
  WaitUntil([this] { return !this->Messages().empty(); });
  for (const WindowLook look : {WindowLook::Light, WindowLook::Dark})
  {
    ChooseLook(look);
    bool isShown = false; // signs of steps update their colours when steps are polled
    const auto shown = QObject::connect(this->Study.get(), &StudyController::StepsChanged,
                                        [&isShown] { isShown = true; });
    WaitUntil([&isShown] { return isShown; });
    QObject::disconnect(shown);
    EXPECT_EQ(this->Ground().lightness() < 128, look == WindowLook::Dark);
    const std::vector<QWidget*> words = this->Words();
    EXPECT_GT(words.size(), 30U);
    for (QWidget* widget : words)
    {
      const auto* label = qobject_cast<QLabel*>(widget);
      EXPECT_GE(DrawnContrast(*widget), LeastTextContrast)
          << NameOf(look).toStdString() << ": " << widget->metaObject()->className() << " "
          << widget->objectName().toStdString() << " "
          << (label != nullptr ? label->text().toStdString() : "");
    }
  }
}
} // namespace
} // namespace palpate::window_look_test
