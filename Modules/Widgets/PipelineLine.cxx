#include "PipelineLine.h"

#include "PipelinePanel.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include <array>
#include <cmath>
#include <optional>

namespace palpate
{
namespace
{
// In the order in which they need each other.
constexpr std::array<SceneStep, 10> StepsInLine{
    SceneStep::Volume, SceneStep::Segmentation, SceneStep::Surface, SceneStep::Samples,
    SceneStep::Model,  SceneStep::Elasticity,   SceneStep::Field,   SceneStep::Protection,
    SceneStep::Guide,  SceneStep::Touch};

QString StartOf(SceneStep step)
{
  QString name = NameOf(step);
  name[0] = name[0].toUpper();
  return name;
}
} // namespace

PipelineLine::PipelineLine(StudyController& study, QWidget* parent)
    : QWidget(parent), Study(study), Line(new QToolButton(this)), Button(new QToolButton(this)),
      Details(new QFrame(this, Qt::Popup))
{
  this->Line->setObjectName("pipeline");
  this->Line->setAutoRaise(true);
  this->Line->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  this->Line->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  this->Line->setArrowType(Qt::DownArrow);
  this->Button->setObjectName("pipeline-act");
  // Nothing moves when it comes or goes.
  QSizePolicy kept = this->Button->sizePolicy();
  kept.setRetainSizeWhenHidden(true);
  this->Button->setSizePolicy(kept);
  this->Button->setText("Run again");
  this->Button->setFixedWidth(this->Button->sizeHint().width());
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(4, 2, 4, 0);
  row->addWidget(this->Line, 1);
  row->addWidget(this->Button);
  (new QVBoxLayout(this->Details))->addWidget(new PipelinePanel(study, this->Details));
  connect(this->Line, &QToolButton::clicked, this, &PipelineLine::OpenDetails);
  connect(this->Button, &QToolButton::clicked, this, &PipelineLine::Act);
  connect(&study, &StudyController::StepsChanged, this, &PipelineLine::Show);
  connect(&study, &StudyController::StateChanged, this, &PipelineLine::Show);
  this->Show();
}

void PipelineLine::OpenDetails()
{
  this->Details->adjustSize();
  this->Details->move(this->Line->mapToGlobal(QPoint(0, this->Line->height())));
  this->Details->show();
}

void PipelineLine::Act()
{
  this->Resumes ? this->Study.ResumeStep(this->Offered) : this->Study.CancelStep(this->Offered);
}

void PipelineLine::ShowText(const QString& text, const QString& tip)
{
  if (this->Line->text() != text)
  {
    this->Line->setText(text);
    this->Line->setToolTip(tip);
  }
}

void PipelineLine::Offer(const QString& text, SceneStep step, bool isResume)
{
  this->Offered = step;
  this->Resumes = isResume;
  this->Button->setText(text);
  this->Button->show();
}

// "Model 37 of 116 \u00b7 4 s", or "Volume 40 %" of a single one.
void PipelineLine::ShowRunning(SceneStep step, const StudyStepState& state)
{
  if (!this->Since.isValid())
  {
    this->Since.start();
  }
  const auto seconds = this->Since.elapsed() / 1000;
  QString text = StartOf(step);
  text += state.Wanted > 1 ? QString(" %1 of %2").arg(state.Done).arg(state.Wanted)
                           : QString(" %1 %").arg(std::lround(100.0 * state.Fraction));
  text += seconds > 0 ? QString(" \u00b7 %1 s").arg(seconds) : QString();
  this->ShowText(text, ScreenString(state.Stage));
  this->Offer("Cancel", step, false);
}

void PipelineLine::Show()
{
  using Kind = StudyStepState::Kind;
  std::size_t failed = 0;
  QString failure;
  bool hasAny = false;
  std::optional<SceneStep> waiting;
  for (const SceneStep step : StepsInLine)
  {
    const StudyStepState state = this->Study.StateOf(step);
    hasAny = hasAny || state.Is != Kind::NotWanted;
    if (state.Is == Kind::Running)
    {
      return this->ShowRunning(step, state);
    }
    if (state.IsCancelled && !waiting)
    {
      waiting = step;
    }
    if (state.Is == Kind::Failed)
    {
      ++failed;
      failure = failure.isEmpty() ? ScreenString(state.Message) : failure;
    }
  }
  this->Since.invalidate();
  this->Button->hide();
  if (waiting)
  {
    this->ShowText(StartOf(*waiting) + " was cancelled", {});
    this->Offer("Run again", *waiting, true);
  }
  else if (failed > 0)
  {
    this->ShowText(failed == 1 ? "1 step failed" : QString("%1 steps failed").arg(failed),
                   PlainToolTip(failure));
  }
  else
  {
    this->ShowText(hasAny ? "Ready" : "Nothing is open", {});
  }
}
} // namespace palpate
