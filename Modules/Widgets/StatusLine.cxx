#include "StatusLine.h"

#include "PlainLabel.h"
#include "ScreenString.h"
#include "TouchNotice.h"

#include <cmath>

namespace palpate
{
namespace
{
// "R 10.3": with the side's letter instead of a sign.
QString SidedLength(double coordinate, char positive, char negative, LengthUnit unit)
{
  const double shown = std::round(10.0 * coordinate) / 10.0;
  return QString("%1 %2")
      .arg(QChar(shown < 0.0 ? negative : positive))
      .arg(std::abs(LengthIn(unit, shown)), 0, 'f', DecimalsIn(unit, 1));
}
} // namespace

StatusLine::StatusLine(StudyController& study, QWidget* parent)
    : QStatusBar(parent), Study(study), Point(MakePlainLabel("point", this)),
      Jobs(MakePlainLabel("jobs", this)), Cancel(new QToolButton(this)),
      Touch(MakePlainLabel("touch-state", this))
{
  this->Point->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  this->addWidget(this->Point, 1);
  this->addPermanentWidget(this->Jobs);
  this->Cancel->setObjectName("cancel-writing");
  this->Cancel->setText("Cancel");
  this->Cancel->setToolTip("Does not write the file; a former one of its name stays as it is");
  this->Cancel->hide();
  this->addPermanentWidget(this->Cancel);
  connect(this->Cancel, &QToolButton::clicked, this,
          [this]
          {
            this->Study.Current().Writing().Cancel();
            this->ShowJobs();
          });
  this->addPermanentWidget(this->Touch);
  connect(&study, &StudyController::StepsChanged, this, &StatusLine::ShowJobs);
  connect(&study, &StudyController::TouchChanged, this, &StatusLine::ShowTouch);
  connect(&study, &StudyController::ReplayChanged, this, &StatusLine::ShowTouch);
  connect(&study, &StudyController::Touched, this, &StatusLine::ShowTouch);
  this->ShowJobs();
  this->ShowTouch();
}

void StatusLine::ShowPoint(const Vector3& pointWorld, const std::string& text)
{
  const QString place = SidedLength(pointWorld.x(), 'L', 'R', this->Unit) + "  " +
                        SidedLength(pointWorld.y(), 'P', 'A', this->Unit) + "  " +
                        SidedLength(pointWorld.z(), 'S', 'I', this->Unit) + " " +
                        SymbolOf(this->Unit);
  this->Point->setText(text.empty() ? place : place + "   " + ScreenString(text));
}

void StatusLine::ShowJobs()
{
  QStringList running;
  for (const SceneStep step : {SceneStep::Volume, SceneStep::Segmentation, SceneStep::Surface,
                               SceneStep::Samples, SceneStep::Model, SceneStep::Elasticity,
                               SceneStep::Field, SceneStep::Protection, SceneStep::Guide})
  {
    const StudyStepState state = this->Study.Current().Pipeline().StateOf(step);
    if (state.Is == StudyStepState::Kind::Running)
    {
      running += QString("%1 %2 %").arg(NameOf(step)).arg(std::lround(100.0 * state.Fraction));
    }
  }
  const std::vector<StudyWriting::File> files = this->Study.Current().Writing().Waiting();
  for (const StudyWriting::File& file : files)
  {
    running += QString("writing %1 %2 %")
                   .arg(ScreenString(file.Path.filename().string()))
                   .arg(std::lround(100.0 * file.Progress.Fraction));
  }
  this->Cancel->setVisible(!files.empty());
  const QString text = running.join(", ");
  if (text != this->Jobs->text())
  {
    this->Jobs->setText(text);
  }
}

void StatusLine::ShowTouch()
{
  const StudyTouchReading& reading = this->Study.Reading();
  QString text = this->Study.IsReplaying() ? "Replay" : "Touch is off";
  if (this->Study.IsTouching())
  {
    const TouchNotice notice = TouchNotice::Of(reading);
    const SceneStructure* touched = FindStructure(this->Study.State(), reading.TouchedId);
    text = notice.Is == TouchNotice::Kind::Alarm     ? notice.Text
           : notice.Is == TouchNotice::Kind::NoForce ? QString("No force")
           : touched != nullptr                      ? QString("Touches %1: %2 N")
                                      .arg(ScreenString(TitleOf(*touched)))
                                      .arg(Vector3(reading.Newest.ForceWorld).norm(), 0, 'f', 2)
                                : QString("Touch is on");
  }
  if (text != this->Touch->text())
  {
    this->Touch->setText(text);
  }
}
} // namespace palpate
