#pragma once

#include "Application.h"
#include "DisplayCheck.h"
#include "FileQuestions.h"
#include "MainWindow.h"
#include "OwnDisplay.h"
#include "SteadyClock.h"
#include "TemporaryFolder.h"

#include <QMouseEvent>
#include <QSettings>
#include <QSurfaceFormat>
#include <QTimer>
#include <QWheelEvent>

#include <functional>
#include <gtest/gtest.h>
#include <stdexcept>
#include <string>

namespace palpate::test
{
/// One application for all tests of a program.
class TestApplication
{
public:
  /// Throws std::runtime_error without a display.
  static TestApplication& Get()
  {
    static const OwnDisplay display;
    RequireDisplay();
    static TestApplication only;
    return only;
  }
  /// Ends the application after the tests: at exit, Qt's own objects may be destroyed first.
  void End() { this->One.reset(); }

private:
  struct EndListener : testing::EmptyTestEventListener
  {
    void OnTestProgramEnd(const testing::UnitTest&) override { TestApplication::Get().End(); }
  };

  TestApplication()
  {
    qputenv("QT_FONT_DPI", "100"); // xvfb's, for which Qt 5.15.15 does not ask: pictures have text
    qputenv("QT_ENABLE_HIGHDPI_SCALING", "0"); // by 100/96 with Qt 6
    QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
    // Tests run in parallel: each process has its own settings.
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope,
                       QString::fromStdString(this->Settings.Path().string()));
    QApplication::setOrganizationName("Palpate tests");
    QApplication::setApplicationName("WidgetsTests");
    this->One = std::make_unique<Application>(this->Count, this->Arguments);
    testing::UnitTest::GetInstance()->listeners().Append(new EndListener);
  }

  TemporaryFolder Settings;
  int Count = 1;
  char Name[13] = "WidgetsTests";
  char* Arguments[2] = {Name, nullptr};
  std::unique_ptr<Application> One;
};

/// Tests that send real events to widgets. They need a display, like DisplayTest.
class WidgetTest : public testing::Test
{
protected:
  void SetUp() override { ASSERT_NO_THROW(TestApplication::Get()); }

  /// Processes events until it is true. The condition must depend on events. Throws
  /// std::runtime_error that names the place if it waits in vain, so that the next tests still run.
  static void WaitUntil(const std::function<bool()>& isTrue, const char* file = __builtin_FILE(),
                        int line = __builtin_LINE())
  {
    constexpr int Limit = 150000; // ms, several times what the longest takes on a busy machine
    QTimer limit;
    limit.setSingleShot(true);
    limit.start(Limit);
    while (!isTrue())
    {
      if (!limit.isActive())
      {
        throw std::runtime_error("waited in vain at " + std::string(file) + ":" +
                                 std::to_string(line));
      }
      QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
  }
  /// Asks until it is: another program may have taken the focus of the display in between.
  static void Activate(QWidget& window)
  {
    while (!window.isActiveWindow())
    {
      window.activateWindow();
      QApplication::processEvents(QEventLoop::AllEvents, 20);
    }
  }
  /// Until nothing is left to be drawn, and the 3-D view is drawn as at rest.
  static void DrawAll(ViewGrid& views)
  {
    for (ViewPane* pane : views.Panes())
    {
      const int drawn = pane->RenderCount();
      pane->RequestRender();
      WaitUntil([&] { return pane->RenderCount() > drawn || !pane->isVisible(); });
    }
    QApplication::processEvents();
    views.Space()->Settle();
  }

  static void SendMouse(QWidget* widget, QEvent::Type type, const QPointF& place,
                        Qt::MouseButton button, Qt::MouseButtons buttons,
                        Qt::KeyboardModifiers modifiers = Qt::NoModifier)
  {
    QMouseEvent event(type, place, widget->mapToGlobal(place.toPoint()), button, buttons,
                      modifiers);
    QApplication::sendEvent(widget, &event);
  }
  static void Move(QWidget* widget, const QPointF& place,
                   Qt::KeyboardModifiers modifiers = Qt::NoModifier)
  {
    SendMouse(widget, QEvent::MouseMove, place, Qt::NoButton, Qt::NoButton, modifiers);
  }
  static void Click(QWidget* widget, const QPointF& place)
  {
    SendMouse(widget, QEvent::MouseButtonPress, place, Qt::LeftButton, Qt::LeftButton);
    SendMouse(widget, QEvent::MouseButtonRelease, place, Qt::LeftButton, Qt::NoButton);
  }
  static void DoubleClick(QWidget* widget, const QPointF& place)
  {
    Click(widget, place);
    SendMouse(widget, QEvent::MouseButtonDblClick, place, Qt::LeftButton, Qt::LeftButton);
    SendMouse(widget, QEvent::MouseButtonRelease, place, Qt::LeftButton, Qt::NoButton);
  }
  static void Wheel(QWidget* widget, const QPointF& place, int notches,
                    Qt::KeyboardModifiers modifiers = Qt::NoModifier)
  {
    QWheelEvent event(place, widget->mapToGlobal(place.toPoint()), {}, QPoint(0, 120 * notches),
                      Qt::NoButton, modifiers, Qt::NoScrollPhase, false);
    QApplication::sendEvent(widget, &event);
  }
};
} // namespace palpate::test
