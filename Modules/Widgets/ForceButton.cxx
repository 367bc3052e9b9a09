#include "ForceButton.h"

namespace palpate
{
namespace
{
constexpr int PauseMilliseconds = 800;

struct Face
{
  const char* Text;
  const char* Color;
  const char* Pressed;
};
constexpr Face Stop{"Stop force (Esc)", "#B34700", "#8A3600"};
constexpr Face Allow{"Allow force again", "#1f6fb2", "#17527f"};

// The style's border would bring its own gradient.
void Wear(const Face& face, QPushButton& button)
{
  button.setText(face.Text);
  button.setStyleSheet(
      QString("QPushButton { background: %1; color: white; font-weight: bold; border: none;"
              " border-radius: 4px; padding: 4px 12px; }"
              "QPushButton:pressed { background: %2; }"
              "QPushButton:disabled { background: gray; color: white; }")
          .arg(face.Color, face.Pressed));
}
} // namespace

ForceButton::ForceButton(StudyController& study, QWidget* parent)
    : QPushButton(parent), Study(study)
{
  this->setObjectName("stop-force");
  Wear(Allow, *this);
  const QSize allow = this->sizeHint();
  Wear(Stop, *this);
  this->setFixedSize(allow.expandedTo(this->sizeHint()));
  this->Pause.setSingleShot(true);
  this->Pause.setInterval(PauseMilliseconds);
  connect(&this->Pause, &QTimer::timeout, this, &ForceButton::Show);
  connect(this, &QPushButton::clicked, this, &ForceButton::Press);
  connect(&study, &StudyController::TouchChanged, this, &ForceButton::Show);
  connect(&study, &StudyController::Touched, this, &ForceButton::Show);
  this->Show();
}

bool ForceButton::IsOff(const SafetyReport& safety)
{
  return safety.Fault != SafetyFault::None && !safety.WillResume;
}

// Allows force only where the button said so: the fault may be newer than what it shows.
void ForceButton::Press()
{
  if (this->WasOff)
  {
    this->Study.Current().Touch().SwitchForcesOn();
  }
  else
  {
    this->Study.Current().Touch().SwitchForcesOff();
    this->Pause.start();
  }
  this->Show();
}

void ForceButton::Show()
{
  const bool isOff = this->Study.IsTouching() && IsOff(this->Study.Reading().Newest.Safety);
  if (isOff != this->WasOff)
  {
    this->WasOff = isOff;
    Wear(isOff ? Allow : Stop, *this);
    if (isOff)
    {
      this->Pause.start();
    }
  }
  this->setEnabled(this->Study.IsTouching() && !(isOff && this->Pause.isActive()));
}
} // namespace palpate
