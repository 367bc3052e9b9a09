#include "ForceButton.h"

namespace palpate
{
namespace
{
constexpr const char* StopText = "Stop force (Esc)";
constexpr const char* AllowText = "Allow force again";
constexpr int PauseMilliseconds = 800;

// The style's border would bring its own gradient.
QString StyleOf(const char* color, const char* pressed)
{
  return QString("QPushButton { background: %1; color: white; font-weight: bold; border: none;"
                 " border-radius: 4px; padding: 4px 12px; }"
                 "QPushButton:pressed { background: %2; }"
                 "QPushButton:disabled { background: gray; color: white; }")
      .arg(color, pressed);
}
} // namespace

ForceButton::ForceButton(StudyController& study, QWidget* parent)
    : QPushButton(AllowText, parent), Study(study)
{
  this->setObjectName("stop-force");
  this->setStyleSheet(StyleOf("#1f6fb2", "#17527f"));
  const QSize allow = this->sizeHint();
  this->setText(StopText);
  this->setStyleSheet(StyleOf("#B34700", "#8A3600"));
  this->setFixedSize(allow.expandedTo(this->sizeHint()));
  this->Pause.setSingleShot(true);
  this->Pause.setInterval(PauseMilliseconds);
  connect(&this->Pause, &QTimer::timeout, this, &ForceButton::Show);
  connect(this, &QPushButton::clicked, this, &ForceButton::Press);
  connect(&study, &StudyController::TouchChanged, this, &ForceButton::Show);
  connect(&study, &StudyController::Touched, this, &ForceButton::Show);
  this->Show();
}

void ForceButton::Press()
{
  if (this->text() == StopText)
  {
    this->Study.Current().Touch().SwitchForcesOff();
    this->Pause.start();
  }
  else
  {
    this->Study.Current().Touch().SwitchForcesOn();
  }
  this->Show();
}

void ForceButton::Show()
{
  const bool isTouching = this->Study.IsTouching();
  const bool isOff = isTouching && this->Study.Reading().Newest.Safety.Fault != SafetyFault::None;
  this->setEnabled(isTouching && !(isOff && this->Pause.isActive()));
  const QString text = isOff ? AllowText : StopText;
  if (text != this->text())
  {
    this->setText(text);
    this->setStyleSheet(isOff ? StyleOf("#1f6fb2", "#17527f") : StyleOf("#B34700", "#8A3600"));
  }
}
} // namespace palpate
