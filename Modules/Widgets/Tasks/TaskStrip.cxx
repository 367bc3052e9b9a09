#include "TaskStrip.h"

#include "PlainLabel.h"

#include <QHBoxLayout>
#include <QShortcut>

namespace palpate
{
TaskStrip::TaskStrip(QWidget* parent)
    : QFrame(parent), Progress(MakePlainLabel("task-progress", this)),
      Time(MakePlainLabel("task-time", this)), Column(new QVBoxLayout(this))
{
  this->setObjectName("task-strip");
  this->setFrameShape(QFrame::StyledPanel);
  this->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  this->Column->setContentsMargins(8, 4, 4, 4);
  auto* row = new QHBoxLayout;
  QFont bold = this->Progress->font();
  bold.setBold(true);
  this->Progress->setFont(bold);
  row->addWidget(this->Progress);
  row->addWidget(this->Time, 1);
  this->Time->setMinimumWidth(1);
  this->Column->addLayout(row);
  this->Next = this->AddButton("Next (N)", "task-next", &TaskStrip::NextAsked);
  auto* key = new QShortcut(Qt::Key_N, this->Next); // at once, unlike a button's own key
  connect(key, &QShortcut::activated, this->Next, &QPushButton::click);
  this->Next->setToolTip("Ends the trial with the answer that is given, or gives it up");
  QPushButton* pause = this->AddButton("Pause (Esc)", "task-pause", &TaskStrip::PauseAsked);
  pause->setToolTip("Switches all force off; the trial begins again afterwards");
  this->AddButton("Stop", "task-stop", &TaskStrip::StopAsked)
      ->setToolTip("Leaves the task, which can be resumed at this trial");
  row->addWidget(this->Next);
  row->addWidget(pause);
  row->addWidget(this->findChild<QPushButton*>("task-stop"));
  this->hide();
}

// Keys stay with the views.
QPushButton* TaskStrip::AddButton(const QString& text, const char* name, void (TaskStrip::*asked)())
{
  auto* button = new QPushButton(text, this);
  button->setObjectName(name);
  button->setFocusPolicy(Qt::NoFocus);
  connect(button, &QPushButton::clicked, this, asked);
  return button;
}

void TaskStrip::Show(const QString& progress, TrialActivity* activity)
{
  delete this->Activity;
  this->Activity = activity;
  this->Progress->setText(progress);
  if (activity != nullptr)
  {
    this->Column->addWidget(activity);
  }
  this->Enable(false);
}

void TaskStrip::ShowTime(const QString& text)
{
  if (text != this->Time->text())
  {
    this->Time->setText(text);
  }
}

void TaskStrip::Enable(bool isRunning)
{
  this->Next->setEnabled(isRunning);
  if (this->Activity != nullptr)
  {
    this->Activity->setEnabled(isRunning);
  }
}
} // namespace palpate
