// The first use of a device by real events: moved, felt, and stopped, which a recording proves.
#include "FirstUseDialog.h"
#include "VirtualInverse3.h"
#include "VirtualSpnav.h"
#include "WindowTest.h"

#include <QComboBox>
#include <QKeyEvent>
#include <QLabel>

#include <chrono>
#include <cstdlib>
#include <thread>

namespace palpate::first_use_test
{
namespace
{
using test::Norm;

class FirstUseTest : public test::WindowTest
{
protected:
  FirstUseDialog& Open()
  {
    this->Action("First use of a device")->trigger();
    auto* dialog = this->Window->findChild<FirstUseDialog*>();
    QApplication::processEvents();
    return *dialog;
  }
  static QPushButton& Next(const QDialog& dialog)
  {
    return *dialog.findChild<QPushButton*>("first-use-next");
  }
  static QString Result(const QDialog& dialog)
  {
    return dialog.findChild<QLabel*>("first-use-result")->text();
  }
  static TrialPad& Pad(const QDialog& dialog) { return *dialog.findChild<TrialPad*>(); }
  static QPointF Middle(const QDialog& dialog) { return Pad(dialog).rect().center(); }
  static void Hold(const QDialog& dialog, bool isDown)
  {
    SendMouse(&Pad(dialog), isDown ? QEvent::MouseButtonPress : QEvent::MouseButtonRelease,
              Middle(dialog), Qt::LeftButton, isDown ? Qt::LeftButton : Qt::NoButton);
  }
  static void Escape(QWidget& widget)
  {
    QKeyEvent key(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
    QApplication::sendEvent(&widget, &key);
  }
  static void Begin(FirstUseDialog& dialog)
  {
    Next(dialog).click();
    WaitUntil([&] { return dialog.Trial().IsRunning(); });
  }
  // To all four corners, and to and fro.
  static void MoveAll(FirstUseDialog& dialog)
  {
    TrialPad& pad = Pad(dialog);
    for (const QPointF& place :
         {QPointF(5, 5), QPointF(pad.width() - 80, 5), QPointF(5, pad.height() - 5)})
    {
      Move(&pad, place);
      Wheel(&pad, place, 5);
      const auto before = dialog.Trial().Moved();
      WaitUntil([&] { return dialog.Trial().Moved() != before || dialog.Trial().HasMoved(); });
    }
    WaitUntil([&] { return Next(dialog).isEnabled(); });
    Wheel(&pad, Middle(dialog), -15);
    Move(&pad, Middle(dialog));
  }
  static void FeelAll(FirstUseDialog& dialog)
  {
    Next(dialog).click();
    Hold(dialog, true);
    WaitUntil([&] { return Next(dialog).isEnabled(); });
    Hold(dialog, false);
    Next(dialog).click();
  }
  static void PushUntilFelt(FirstUseDialog& dialog, double newtons)
  {
    Hold(dialog, true);
    WaitUntil(
        [&]
        {
          const TouchState& newest = dialog.Trial().Newest();
          if (newest.Safety.Fault != SafetyFault::None &&
              newest.Safety.Fault != SafetyFault::SwitchedOff)
          {
            throw std::runtime_error(Describe(newest.Safety.Fault));
          }
          return Norm(newest.ForceDevice) > newtons;
        });
  }
  static void ShowPicture(QWidget& widget, const std::string& name)
  {
    if (const char* folder = std::getenv("PALPATE_PICTURES"))
    {
      EXPECT_TRUE(
          widget.grab().save(QString(folder) + "/" + QString::fromStdString(name) + ".png"));
    }
  }
};

TEST_F(FirstUseTest, MouseIsMovedFeltAndStoppedWithinTwoTicks)
{
  FirstUseDialog& dialog = this->Open();
  ShowPicture(dialog, "first-use-1");
  Begin(dialog);
  EXPECT_FALSE(Next(dialog).isEnabled());
  MoveAll(dialog);
  ShowPicture(dialog, "first-use-2");
  FeelAll(dialog);
  ShowPicture(dialog, "first-use-3");
  EXPECT_FALSE(Next(dialog).isEnabled());
  PushUntilFelt(dialog, 0.5);
  Escape(dialog);
  WaitUntil([&] { return dialog.Trial().Proof().has_value(); });
  WaitUntil([&] { return Next(dialog).isEnabled(); });
  const StopProof& proof = *dialog.Trial().Proof();
  EXPECT_TRUE(proof.IsPassed());
  EXPECT_GT(proof.ForceBefore, 0.3);
  EXPECT_LE(proof.Ticks, StopProof::MostTicks);
  EXPECT_TRUE(dialog.isVisible()) << "Escape closes nothing";
  EXPECT_TRUE(Result(dialog).contains("The stop works")) << Result(dialog).toStdString();
  ShowPicture(dialog, "first-use-4");
  ChooseLook(WindowLook::Dark);
  QApplication::processEvents();
  ShowPicture(dialog, "first-use-4-dark");
  ChooseLook(WindowLook::System);
  Next(dialog).click();
  EXPECT_FALSE(dialog.isVisible());
}

TEST_F(FirstUseTest, StopWithoutForceProvesNothingAndIsRepeated)
{
  FirstUseDialog& dialog = this->Open();
  Begin(dialog);
  MoveAll(dialog);
  FeelAll(dialog);
  WaitUntil([&] { return Norm(dialog.Trial().Newest().ForceDevice) == 0.0; });
  dialog.findChild<QPushButton*>("first-use-stop")->click();
  WaitUntil([&] { return dialog.Trial().Proof().has_value(); });
  WaitUntil([&] { return Result(dialog).contains("proves nothing"); });
  EXPECT_FALSE(Next(dialog).isEnabled());
  dialog.findChild<QPushButton*>("first-use-allow")->click();
  WaitUntil([&] { return !dialog.Trial().Proof().has_value(); });
  PushUntilFelt(dialog, 0.5);
  Escape(Pad(dialog));
  WaitUntil([&] { return Next(dialog).isEnabled(); });
}

TEST_F(FirstUseTest, LostDeviceBeginsAgain)
{
  const std::string path = (this->Phantom.Folder / "spnav.sock").string();
  test::VirtualSpnav daemon(path);
  FirstUseDialog& dialog = this->Open();
  dialog.findChild<QComboBox*>("first-use-device")
      ->setCurrentText(QString::fromStdString("spacemouse:" + path));
  Begin(dialog);
  daemon.Accept();
  daemon.Send({0, 300, 0, 0, 0, 0, 0, 16});
  WaitUntil([&] { return dialog.Trial().Moved()[0] > 0.2; });
  daemon.End();
  WaitUntil([&] { return !dialog.Trial().IsRunning(); });
  EXPECT_TRUE(Result(dialog).startsWith("No force.")) << Result(dialog).toStdString();
  EXPECT_EQ(Next(dialog).text(), "Start");
  EXPECT_TRUE(Next(dialog).isEnabled());
}

TEST_F(FirstUseTest, EveryPageFitsUsualScreensUnclipped)
{
  FirstUseDialog& dialog = this->Open();
  const auto expectFits = [&](const std::string& page)
  {
    // 640 x 400 is left of 1280 x 800 at scale 2.
    EXPECT_LE(dialog.minimumSizeHint().width(), 640) << page;
    EXPECT_LE(dialog.minimumSizeHint().height(), 400) << page;
    for (const QSize size : {QSize(640, 400), QSize(1024, 700), QSize(1280, 800)})
    {
      dialog.resize(size);
      QApplication::processEvents();
      for (const QLabel* label : dialog.findChildren<QLabel*>())
      {
        const int needed =
            label->wordWrap() ? label->heightForWidth(label->width()) : label->sizeHint().height();
        EXPECT_TRUE(!label->isVisible() || label->height() >= needed)
            << page << " " << label->text().toStdString();
      }
      ShowPicture(dialog, page + "-" + std::to_string(size.width()));
    }
    dialog.resize(520, 400);
    QApplication::processEvents();
  };
  expectFits("choose");
  Begin(dialog);
  MoveAll(dialog);
  expectFits("move");
  FeelAll(dialog);
  PushUntilFelt(dialog, 0.5);
  Escape(dialog);
  WaitUntil([&] { return Next(dialog).isEnabled(); });
  expectFits("stop");
}

class MotorFirstUseTest : public FirstUseTest
{
protected:
  MotorFirstUseTest() { this->Time = std::make_unique<SteadyClock>(); }
  // m, at 0.2 m/s at most.
  static void Glide(test::VirtualInverse3& service, const Vector3& from, const Vector3& to)
  {
    constexpr int Steps = 100;
    for (int n = 0; n <= Steps; ++n)
    {
      service.MoveTo(from + (1.0 * n / Steps) * (to - from));
      QApplication::processEvents();
      std::this_thread::sleep_for(std::chrono::milliseconds(4));
    }
  }
  // A busy machine ends forces by its delays; a person allows them again.
  static void WaitDespiteDelays(FirstUseDialog& dialog, const std::function<bool()>& isTrue)
  {
    auto* allow = dialog.findChild<QPushButton*>("first-use-allow");
    WaitUntil(
        [&]
        {
          const bool isDone = isTrue();
          if (!isDone && allow->isEnabled() &&
              dialog.Trial().Newest().Safety.Fault != SafetyFault::SwitchedOff)
          {
            allow->click();
          }
          return isDone;
        });
  }
};

// What counts is what arrives at the device's service.
TEST_F(MotorFirstUseTest, NothingButZeroReachesTheServiceAfterTheStop)
{
  test::VirtualInverse3 service;
  FirstUseDialog& dialog = this->Open();
  dialog.findChild<QComboBox*>("first-use-device")
      ->setCurrentText(QString::fromStdString("inverse3:" + service.Argument()));
  Begin(dialog);
  Glide(service, {0.0, 0.0, 0.0}, {0.04, 0.0, 0.04});
  Glide(service, {0.04, 0.0, 0.04}, {0.0, 0.04, 0.0});
  WaitUntil([&] { return dialog.Trial().HasMoved(); });
  // It stays there, forward, in the wall.
  WaitDespiteDelays(dialog, [&] { return Next(dialog).isEnabled(); });
  Next(dialog).click();
  WaitDespiteDelays(dialog, [&] { return Next(dialog).isEnabled(); });
  Next(dialog).click();
  WaitDespiteDelays(dialog, [&] { return Norm(dialog.Trial().Newest().ForceDevice) > 0.5; });
  Escape(dialog);
  WaitUntil([&] { return dialog.Trial().Proof().has_value(); });
  EXPECT_TRUE(dialog.Trial().Proof()->IsPassed()) << Result(dialog).toStdString();
  const std::size_t before = service.Forces().size();
  WaitUntil([&] { return service.Forces().size() > before + 20; });
  const std::vector<Vector3> forces = service.Forces();
  for (std::size_t n = before; n < forces.size(); ++n)
  {
    EXPECT_EQ(forces[n], Vector3(Vector3::Zero()));
  }
}
} // namespace
} // namespace palpate::first_use_test
