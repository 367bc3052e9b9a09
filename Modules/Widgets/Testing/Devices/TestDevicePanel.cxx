// A device is chosen, changed, lost and found in the window, without a restart.
#include "DevicePanel.h"
#include "DeviceSettings.h"
#include "ForceButton.h"
#include "VirtualInverse3.h"
#include "VirtualSpnav.h"
#include "WindowLook.h"
#include "WindowTest.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>

#include <cstdio>
#include <cstdlib>
#include <memory>

namespace palpate::device_panel_test
{
namespace
{
using test::Inverse3Fault;
using test::Norm;

class DevicePanelTest : public test::WindowTest
{
protected:
  void SetUp() override
  {
    test::WindowTest::SetUp();
    this->OpenPhantom();
    this->Window->Messages()->Clear(); // on structures that cannot be modelled
  }
  QComboBox* Device() const { return this->Window->findChild<QComboBox*>("device"); }
  QComboBox* Clutch() const { return this->Window->findChild<QComboBox*>("clutch-button"); }
  QDoubleSpinBox* Scale() const { return this->Window->findChild<QDoubleSpinBox*>("scale"); }
  QString Line() const { return this->Window->findChild<QLabel*>("device-line")->text(); }
  QString Advice() const { return this->Window->findChild<QLabel*>("advice")->text(); }
  std::string SpaceMouse() const { return (this->Phantom.Folder / "spnav.sock").string(); }
  void Plug()
  {
    std::remove(this->SpaceMouse().c_str());
    this->Daemon = std::make_unique<test::VirtualSpnav>(this->SpaceMouse());
  }
  bool IsTouchingBy(const std::string& device) const
  {
    return this->Study->IsTouching() &&
           this->Study->Current().Touch().Capabilities().Name == device;
  }
  void TouchBySpaceMouse()
  {
    this->Plug();
    this->Device()->setCurrentText("spacemouse:" + QString::fromStdString(this->SpaceMouse()));
    this->BeginTouch();
    this->Daemon->Accept();
  }

  static void ShowPicture(QWidget& widget, const QString& name)
  {
    if (const char* folder = std::getenv("PALPATE_PICTURES"))
    {
      EXPECT_TRUE(widget.grab().save(QString(folder) + "/" + name + ".png"));
    }
  }

  std::unique_ptr<test::VirtualSpnav> Daemon;
};

TEST_F(DevicePanelTest, AnotherDeviceTakesOverWhileTouching)
{
  this->BeginTouch();
  ASSERT_TRUE(this->IsTouchingBy("Simulated device"));
  this->Plug();
  this->Device()->setCurrentText("spacemouse:" + QString::fromStdString(this->SpaceMouse()));
  WaitUntil([this] { return this->IsTouchingBy("SpaceMouse") || !this->Messages().empty(); });
  EXPECT_EQ(this->Messages(), "");
  this->Study->Undo();
  WaitUntil([this] { return this->IsTouchingBy("Simulated device"); });
}

TEST_F(DevicePanelTest, DeviceThatIsBackIsPickedUpAgain)
{
  this->TouchBySpaceMouse();
  this->Daemon->End();
  WaitUntil([this] { return this->Study->Current().IsAwaitingDevice(); });
  QApplication::processEvents();
  EXPECT_FALSE(this->Study->IsTouching());
  EXPECT_EQ(Norm(this->Study->Reading().Newest.ForceDevice), 0.0);
  EXPECT_EQ(this->Study->Reading().Newest.Safety.Fault, SafetyFault::DeviceFailed);
  EXPECT_TRUE(this->Advice().contains("spacenavd")) << this->Advice().toStdString();
  EXPECT_TRUE(this->Advice().contains("once it is back"));
  EXPECT_FALSE(this->Advice().contains('\n')) << "one line";
  EXPECT_EQ(this->Button("start-touch")->text(), "Waiting for the device... (stop)");
  this->Plug();
  WaitUntil([this] { return this->IsTouchingBy("SpaceMouse"); });
  WaitUntil([this] { return this->Study->Reading().Newest.Safety.IsArmed; });
  EXPECT_EQ(this->Advice(), "");
}

TEST_F(DevicePanelTest, WaitingForADeviceCanBeStopped)
{
  this->TouchBySpaceMouse();
  this->Daemon->End();
  WaitUntil([this] { return this->Study->Current().IsAwaitingDevice(); });
  QApplication::processEvents();
  this->Button("start-touch")->click();
  EXPECT_FALSE(this->Study->Current().IsAwaitingDevice());
  EXPECT_FALSE(this->Study->Current().IsOpeningDevice());
  EXPECT_EQ(this->Button("start-touch")->text(), "Start touching");
  EXPECT_EQ(this->Advice(), "");
}

TEST_F(DevicePanelTest, LineSaysWhatIsMissingAndThatItIsThereNow)
{
  qputenv("SPNAV_SOCKET", this->SpaceMouse().c_str());
  this->Device()->setCurrentText("SpaceMouse");
  WaitUntil([this] { return this->Line().contains("install and start it"); });
  EXPECT_TRUE(this->Line().contains("ntried on hardware"));
  EXPECT_FALSE(this->Line().contains('\n'));
  this->Plug();
  WaitUntil([this] { return this->Line().contains("spacenavd answers"); });
  qunsetenv("SPNAV_SOCKET");
}

TEST_F(DevicePanelTest, SettingsComeBackWithTheDevice)
{
  this->Device()->setCurrentText("Novint Falcon");
  ASSERT_TRUE(this->Clutch()->isVisible());
  EXPECT_EQ(this->Clutch()->currentText(), "Button 3");
  this->Scale()->setValue(2.5);
  this->Clutch()->setCurrentIndex(this->Clutch()->findText("Button 4"));
  Q_EMIT this->Clutch()->activated(this->Clutch()->currentIndex());
  this->Device()->setCurrentText("Mouse (no device)");
  EXPECT_FALSE(this->Clutch()->isVisible());
  this->Scale()->setValue(1.5);
  this->Device()->setCurrentText("falcon:firmware=/a/b.bin");
  EXPECT_EQ(this->Study->State().Placement.Scale, 2.5) << "the same device by another file";
  EXPECT_EQ(this->Clutch()->currentText(), "Button 4");
  EXPECT_TRUE(this->Study->State().Placement.AxesFollowCamera);
  this->Device()->setCurrentText("Mouse (no device)");
  EXPECT_EQ(this->Study->State().Placement.Scale, 1.5);
}

TEST_F(DevicePanelTest, SettingsThatMakeNoSenseAreLeftOut)
{
  QSettings().setValue("devices/falcon/scale", "many");
  QSettings().setValue("devices/falcon/clutch-button", 40);
  const DeviceSettings kept = DeviceSettings::Kept("falcon");
  EXPECT_FALSE(kept.Scale);
  EXPECT_FALSE(kept.ClutchButton);
  QSettings().setValue("devices/falcon/clutch-button", StudyTouch::DrillButton);
  EXPECT_FALSE(DeviceSettings::Kept("falcon").ClutchButton) << "it is the drill's";
}

TEST_F(DevicePanelTest, NameThatIsTypedCountsOnceItIsComplete)
{
  Activate(*this->Window);
  QLineEdit* edit = this->Device()->lineEdit();
  edit->setFocus();
  edit->selectAll();
  for (const char letter : std::string("replay:a"))
  {
    QKeyEvent key(QEvent::KeyPress, 0, Qt::NoModifier, QString(QLatin1Char(letter)));
    QApplication::sendEvent(edit, &key);
  }
  EXPECT_EQ(this->Study->State().Device, "simulated");
  QKeyEvent enter(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier);
  QApplication::sendEvent(edit, &enter);
  EXPECT_EQ(this->Study->State().Device, "replay:a");
}

TEST_F(DevicePanelTest, FirstUseIsOfferedOncePerDevice)
{
  auto* attempt = this->Button("try-device");
  EXPECT_FALSE(attempt->isVisible()) << "of the mouse";
  this->Device()->setCurrentText("Novint Falcon");
  EXPECT_TRUE(attempt->isVisible());
  this->Button("not-now")->click();
  EXPECT_FALSE(attempt->isVisible());
  this->Device()->setCurrentText("Haply Inverse3");
  EXPECT_TRUE(attempt->isVisible());
  this->Device()->setCurrentText("Novint Falcon");
  EXPECT_FALSE(attempt->isVisible());
}

TEST_F(DevicePanelTest, RowsAreUnclippedAtUsualSizesInBothLooks)
{
  qputenv("SPNAV_SOCKET", this->SpaceMouse().c_str());
  this->Device()->setCurrentText("SpaceMouse");
  WaitUntil([this] { return this->Line().contains("install and start it"); });
  auto* panel = this->Window->findChild<DevicePanel*>();
  for (const WindowLook look : {WindowLook::Light, WindowLook::Dark})
  {
    ChooseLook(look);
    // The last is 1600 x 1000 at scale 2.
    for (const QSize size : {QSize(1280, 800), QSize(1024, 700), QSize(800, 500)})
    {
      this->Window->resize(size);
      DrawAll(*this->Window->Views());
      this->Window->findChild<WorkColumn*>()->ensureWidgetVisible(panel);
      for (QWidget* widget : panel->findChildren<QWidget*>(QRegularExpression(".+")))
      {
        const QSize least = widget->minimumSizeHint();
        const std::string name = widget->objectName().toStdString() + " in " +
                                 NameOf(look).toStdString() + " at " + std::to_string(size.width());
        EXPECT_TRUE(!widget->isVisible() || widget->width() >= least.width()) << name;
        EXPECT_TRUE(!widget->isVisible() || widget->height() >= least.height())
            << name << ": " << widget->height() << " of " << least.height();
      }
      ShowPicture(*this->Window, "device-" + NameOf(look) + QString::number(size.width()));
    }
  }
  ChooseLook(WindowLook::System);
  qunsetenv("SPNAV_SOCKET");
}

class MotorDeviceTest : public DevicePanelTest
{
protected:
  MotorDeviceTest() { this->Time = std::make_unique<SteadyClock>(); }
  SafetyFault Fault() const { return this->Study->Reading().Newest.Safety.Fault; }

  test::VirtualInverse3 Service;
};

TEST_F(MotorDeviceTest, DeviceWithMotorsComesBackWithoutForceUntilAPersonAllowsIt)
{
  this->Device()->setCurrentText("inverse3:" + QString::fromStdString(this->Service.Argument()));
  this->BeginTouch();
  WaitUntil([this] { return this->Study->Reading().Newest.State == DeviceState::Ready; });
  this->Service.SetFault(Inverse3Fault::CutOff);
  WaitUntil([this] { return this->Study->Current().IsAwaitingDevice(); });
  this->Service.SetFault(Inverse3Fault::None);
  WaitUntil([this] { return this->IsTouchingBy("Haply Inverse3"); });
  WaitUntil([this] { return this->Study->Reading().Newest.State == DeviceState::Ready; });
  EXPECT_EQ(this->Fault(), SafetyFault::SwitchedOff);
  EXPECT_TRUE(this->Advice().contains("is back")) << this->Advice().toStdString();
  WaitUntil([this] { return this->Button("stop-force")->isEnabled(); });
  this->Button("stop-force")->click();
  WaitUntil([this] { return this->Fault() != SafetyFault::SwitchedOff; });
  WaitUntil([this] { return !this->Advice().contains("is back"); });
}
} // namespace
} // namespace palpate::device_panel_test
