#include "Coach.h"

#include "PlainLabel.h"

#include <QHBoxLayout>
#include <QSettings>
#include <QToolButton>

#include <algorithm>

namespace palpate
{
namespace
{
constexpr double LeastForce = 0.1;  // N, of a press
constexpr double LeastCut = 1.0;    // mm^3
constexpr double LeastStroke = 8.0; // mm
constexpr int LeastWidth = 600;     // pixels, for all steps at once

struct Lesson
{
  StartCard::Kind Kind;
  std::array<const char*, Coach::StepCount> Steps;
};
constexpr const char* StartStep = "Start touching";
constexpr std::array<Lesson, 4> Lessons{
    {{StartCard::Kind::Prostate,
      {StartStep, "Point at the gland in 3-D and press the left button",
       "Keep it pressed and stroke over the gland"}},
     {StartCard::Kind::Lesion,
      {StartStep, "Press on the middle of its back, in 3-D",
       "Press beside it: the nodule feels harder"}},
     {StartCard::Kind::Mastoid,
      {StartStep, "Point at the bone, press, and hold D to drill",
       "Take the stroke back: Undo stroke, in Drilling"}},
     {StartCard::Kind::Head,
      {StartStep, "Point at a structure in 3-D and press the left button",
       "Press another structure"}}}};

const Lesson* LessonOf(StartCard::Kind kind)
{
  const auto* found = std::find_if(Lessons.begin(), Lessons.end(),
                                   [kind](const Lesson& one) { return one.Kind == kind; });
  return found == Lessons.end() ? nullptr : found;
}

const StartCard& CardOf(StartCard::Kind kind)
{
  const auto& all = StartCard::All();
  return *std::find_if(all.begin(), all.end(),
                       [kind](const StartCard& one) { return one.Is == kind; });
}

QString ClosedKey(StartCard::Kind kind)
{
  return QString("coach-closed/") + CardOf(kind).Key;
}
} // namespace

Coach::Coach(StudyController& study, QWidget* parent)
    : QFrame(parent), Study(study), Title(MakePlainLabel("coach-title", this))
{
  this->setObjectName("coach");
  this->setFrameShape(QFrame::StyledPanel);
  this->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Minimum);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 4, 4, 4);
  row->setSpacing(12);
  QFont bold = this->Title->font();
  bold.setBold(true);
  this->Title->setFont(bold);
  this->Title->setMinimumWidth(1);
  row->addWidget(this->Title);
  for (int step = 0; step < StepCount; ++step)
  {
    const QByteArray name = "coach-" + QByteArray::number(step + 1);
    QLabel* label = MakePlainLabel(name.constData(), this);
    label->setWordWrap(true);
    label->setMinimumWidth(1); // the window may be as small as without
    this->Steps.at(static_cast<std::size_t>(step)) = label;
    row->addWidget(label, 1);
  }
  auto* close = new QToolButton(this);
  close->setObjectName("coach-close");
  close->setText("\u00d7");
  close->setAutoRaise(true);
  close->setAccessibleName("Close the first steps");
  close->setToolTip("Closes the first steps; they are not shown for this card again");
  row->addWidget(close);
  connect(close, &QToolButton::clicked, this, &Coach::Close);
  connect(&study, &StudyController::StateChanged, this, &Coach::LeaveOtherStudy);
  connect(&study, &StudyController::TouchChanged, this, &Coach::Look);
  connect(&study, &StudyController::Touched, this, &Coach::Look);
  this->hide();
}

void Coach::Begin(StartCard::Kind kind)
{
  this->Of.reset();
  if (LessonOf(kind) != nullptr && !QSettings().value(ClosedKey(kind), false).toBool())
  {
    this->Of = kind;
    this->Volume = this->Study.State().VolumeFile;
    this->DoneCount = 0;
  }
  this->Show();
}

void Coach::Close()
{
  QSettings().setValue(ClosedKey(*this->Of), true);
  this->Of.reset();
  this->Show();
}

void Coach::LeaveOtherStudy()
{
  if (this->Of && this->Study.State().VolumeFile != this->Volume)
  {
    this->Of.reset();
    this->Show();
  }
}

bool Coach::IsFelt() const
{
  const StudyTouchReading& reading = this->Study.Reading();
  return reading.TouchedId != 0 && Vector3(reading.Newest.ForceWorld).norm() > LeastForce;
}

bool Coach::IsDone(int step)
{
  const StudyTouchReading& reading = this->Study.Reading();
  const auto& drilled = reading.Drill.Drilled;
  if (step == 0)
  {
    return this->Study.IsTouching();
  }
  if (*this->Of == StartCard::Kind::Mastoid)
  {
    return step == 1 ? !drilled.empty() && drilled.front().RemovedVolume > LeastCut
                     : reading.Drill.CanRedo;
  }
  if (step == 1)
  {
    this->FirstPlace = Vector3(reading.Newest.ProbeWorld);
    this->FirstId = reading.TouchedId;
    return this->IsFelt();
  }
  const bool isElsewhere =
      *this->Of == StartCard::Kind::Head
          ? reading.TouchedId != this->FirstId
          : (Vector3(reading.Newest.ProbeWorld) - this->FirstPlace).norm() > LeastStroke;
  return this->IsFelt() && isElsewhere;
}

void Coach::Look()
{
  const int before = this->DoneCount;
  while (this->Of && this->DoneCount < StepCount && this->IsDone(this->DoneCount))
  {
    ++this->DoneCount;
  }
  if (this->DoneCount != before)
  {
    this->Show();
  }
}

void Coach::Show()
{
  this->setVisible(this->Of.has_value());
  if (!this->Of)
  {
    return;
  }
  const bool isNarrow = this->width() < LeastWidth;
  this->Title->setVisible(!isNarrow);
  this->Title->setText(CardOf(*this->Of).Title);
  const int current = std::min(this->DoneCount, StepCount - 1);
  for (int step = 0; step < StepCount; ++step)
  {
    this->ShowStep(step);
    this->Steps.at(static_cast<std::size_t>(step))->setVisible(!isNarrow || step == current);
  }
}

void Coach::ShowStep(int step)
{
  const auto n = static_cast<std::size_t>(step);
  const bool isDone = step < this->DoneCount;
  const bool isOver = this->DoneCount == StepCount && step == StepCount - 1;
  const QString mark = isDone ? QString("\u2713") : QString::number(step + 1) + ".";
  QLabel* label = this->Steps.at(n);
  label->setText(
      mark + " " +
      (isOver ? "Well done. Esc stops all force, at any time" : LessonOf(*this->Of)->Steps.at(n)));
  QFont font = label->font();
  font.setBold(step == this->DoneCount);
  label->setFont(font);
  label->setEnabled(!isDone || isOver);
}

void Coach::resizeEvent(QResizeEvent* event)
{
  QFrame::resizeEvent(event);
  this->Show();
}
} // namespace palpate
