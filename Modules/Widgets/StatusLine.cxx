#include "StatusLine.h"

#include "PlainLabel.h"
#include "ScreenString.h"
#include "SidedLength.h"
#include "TouchNotice.h"

namespace palpate
{
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
  const QString place = SidedLength(pointWorld, 0, this->Unit, 1) + "  " +
                        SidedLength(pointWorld, 1, this->Unit, 1) + "  " +
                        SidedLength(pointWorld, 2, this->Unit, 1) + " " + SymbolOf(this->Unit);
  this->Point->setText(text.empty() ? place : place + "   " + ScreenString(text));
}

void StatusLine::ShowJobs()
{
  QStringList running;
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
    const QString touched = this->Study.TouchedTitle();
    text = notice.Is == TouchNotice::Kind::Alarm     ? notice.Text
           : notice.Is == TouchNotice::Kind::NoForce ? QString("No force")
           : !touched.isEmpty()                      ? QString("Touches %1: %2 N")
                                      .arg(touched)
                                      .arg(Vector3(reading.Newest.ForceWorld).norm(), 0, 'f', 2)
                                : QString("Touch is on");
  }
  if (text != this->Touch->text())
  {
    this->Touch->setText(text);
  }
}
} // namespace palpate
