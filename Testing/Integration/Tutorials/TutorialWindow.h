#pragma once

#include "BaselineImage.h"
#include "CommandRun.h"
#include "WidgetImage.h"
#include "WindowTest.h"

#include <QDockWidget>
#include <QDropEvent>
#include <QMimeData>
#include <QStyleFactory>
#include <QUrl>

#include <cmath>
#include <string>
#include <vector>

namespace palpate::test
{
/// A page of Documentation/Tutorial, step by step, as a new user does. The screenshots are those of
/// the page; the style is Qt's own, so that they look the same on every machine.
class TutorialWindow : public WindowTest
{
protected:
  void SetUp() override
  {
    WindowTest::SetUp();
    if (!IsSkipped())
    {
      QApplication::setStyle(QStyleFactory::create("Fusion"));
      this->Window->resize(1180, 760);
    }
  }

  std::filesystem::path File(const std::string& name) const { return this->Phantom.Folder / name; }
  /// The command line, in the folder of File.
  void Run(const std::vector<std::string>& words)
  {
    const CommandRun run = RunPalpate(words, this->Phantom.Folder.Path());
    ASSERT_EQ(run.Code, 0) << run.Errors;
  }
  void DropFiles(const std::vector<std::string>& names)
  {
    QMimeData data;
    QList<QUrl> urls;
    for (const std::string& name : names)
    {
      urls += QUrl::fromLocalFile(QString::fromStdString(this->File(name).string()));
    }
    data.setUrls(urls);
    QDragEnterEvent enter({300, 300}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(this->Window.get(), &enter);
    QDropEvent drop({300.0, 300.0}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(this->Window.get(), &drop);
  }
  /// Brings a panel to the front.
  void Raise(const char* panel)
  {
    auto* dock = this->Window->findChild<QDockWidget*>(panel);
    dock->show();
    dock->raise();
  }
  void ExpectBaseline(const std::string& name)
  {
    DrawAll(*this->Window->Views());
    if (HasBaselineRows)
    {
      ExpectLikeBaseline(ImageOf(*this->Window),
                         std::filesystem::path(PALPATE_DOCUMENTATION_IMAGES) / name);
    }
  }
  const FitResult& Fit()
  {
    return *this->Study->Current().Pipeline().Newest<FitResult>(SceneStep::Model, 1);
  }
  double Force() const
  {
    const PlainVector3& force = this->Study->Reading().Newest.ForceWorld;
    return std::hypot(force.X, force.Y, force.Z);
  }
  /// The same position and force each time: the hand comes from outside, along the normal, and
  /// stays at a place until the force does.
  void HoldStill(const Vector3& placeWorld, const Vector3& normal)
  {
    constexpr double Above = 8.0; // mm
    constexpr double Near = 2.0;  // mm; friction stops a hand short of its goal
    const Vector3 above = placeWorld + Above * normal;
    this->FeelUntil(
        [&]
        {
          this->Study->Current().Touch().MoveHand(above);
          const TouchState& newest = this->Study->Reading().Newest;
          return !newest.IsBuried && (Vector3(newest.ProbeWorld) - above).norm() < Near;
        });
    std::uint64_t since = 0;
    double former = 0.0;
    this->FeelUntil(
        [&]
        {
          this->Study->Current().Touch().MoveHand(placeWorld);
          const bool isSteady = this->Force() > 0.1 && std::abs(this->Force() - former) < 1e-4;
          const std::uint64_t now = this->Study->Reading().Newest.Tick.Number;
          since = isSteady ? since : now;
          former = this->Force();
          return now > since + 800;
        });
  }
};
} // namespace palpate::test
