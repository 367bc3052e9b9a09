#include "TaskPage.h"

#include "PlainLabel.h"

#include <QHBoxLayout>
#include <QScrollArea>
#include <QVBoxLayout>

namespace palpate
{
namespace
{
constexpr int MostLetters = 75; // of a line that is read

QLabel* MakeReading(const char* name, double size, bool isBold, QWidget* parent)
{
  QLabel* label = MakePlainLabel(name, parent);
  QFont font = label->font();
  font.setPointSizeF(size * font.pointSizeF());
  font.setBold(isBold);
  label->setFont(font);
  label->setWordWrap(true);
  return label;
}
} // namespace

TaskPage::TaskPage(QWidget* parent)
    : QWidget(parent), Title(MakeReading("task-page-title", 1.6, true, this)),
      Progress(MakeReading("task-page-progress", 1.3, true, this)),
      Text(MakeReading("task-page-text", 1.3, false, this)),
      State(MakeReading("task-page-state", 1.1, false, this)), Buttons(new QWidget(this))
{
  this->setObjectName("task-page");
  auto* row = new QHBoxLayout(this->Buttons);
  row->setContentsMargins(0, 0, 0, 0);
  this->Start = this->AddButton("task-start", &TaskPage::StartAsked);
  this->Pause = this->AddButton("task-page-pause", &TaskPage::PauseAsked);
  this->Folder = this->AddButton("task-open-folder", &TaskPage::FolderAsked);
  this->Stop = this->AddButton("task-page-stop", &TaskPage::StopAsked);
  this->Pause->setText("Pause");
  this->Start->setDefault(true);
  row->addStretch(1);
  // Long instructions scroll; the buttons stay.
  auto* scrolled = new QScrollArea(this);
  scrolled->setFrameShape(QFrame::NoFrame);
  scrolled->setWidgetResizable(true);
  this->Text->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  scrolled->setWidget(this->Text);
  this->State->setMinimumHeight(2 * this->State->fontMetrics().lineSpacing());
  auto* middle = new QWidget(this);
  middle->setMaximumWidth(MostLetters * this->Text->fontMetrics().averageCharWidth());
  auto* column = new QVBoxLayout(middle);
  column->setSpacing(12);
  column->addWidget(this->Title);
  column->addWidget(this->Progress);
  column->addWidget(scrolled, 1);
  column->addWidget(this->State);
  column->addWidget(this->Buttons);
  auto* center = new QHBoxLayout(this);
  center->addStretch(1);
  center->addWidget(middle, 100);
  center->addStretch(1);
  this->hide();
}

QPushButton* TaskPage::AddButton(const char* name, void (TaskPage::*asked)())
{
  auto* button = new QPushButton(this->Buttons);
  button->setObjectName(name);
  this->Buttons->layout()->addWidget(button);
  connect(button, &QPushButton::clicked, this, asked);
  return button;
}

void TaskPage::Show(const Content& content)
{
  this->Title->setText(content.Title);
  this->Progress->setText(content.Progress);
  this->Text->setText(content.Text);
  this->Start->setText(content.Start);
  this->Folder->setText(content.Folder);
  this->Stop->setText(content.Stop);
  for (QPushButton* button : {this->Start, this->Folder, this->Stop})
  {
    button->setVisible(!button->text().isEmpty());
  }
  this->Pause->setVisible(content.CanPause);
}

void TaskPage::ShowState(const QString& text, bool canStart)
{
  if (text != this->State->text())
  {
    this->State->setText(text);
  }
  if (canStart && !this->Start->isEnabled())
  {
    this->Start->setEnabled(true);
    this->Start->setFocus();
  }
  this->Start->setEnabled(canStart);
}
} // namespace palpate
