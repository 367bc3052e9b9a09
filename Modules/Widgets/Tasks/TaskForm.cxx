#include "TaskForm.h"

#include "InputError.h"
#include "OutputFolder.h"
#include "PlainLabel.h"
#include "ScreenString.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>

namespace palpate
{
TaskForm::TaskForm(const TaskSettings& task, const std::filesystem::path& folder,
                   const std::string& device, const FileQuestions& questions, QWidget* window)
    : QDialog(window), Task(task), Number(new QSpinBox(this)), Results(new QLineEdit(this)),
      Devices(new DeviceChoice(this)), Line(MakePlainLabel("task-state", this))
{
  this->setObjectName("task-form");
  this->setWindowTitle("Run a task");
  this->Number->setObjectName("task-number");
  this->Number->setRange(1, MostParticipants);
  this->Devices->setObjectName("task-device");
  this->Devices->Choose(device);
  this->Line->setWordWrap(true);
  this->Line->setMinimumHeight(2 * this->Line->fontMetrics().lineSpacing());
  QLabel* title = MakePlainLabel("task-title", this);
  title->setText(ScreenString(task.Title.empty() ? task.Id : task.Title));
  QFont bold = title->font();
  bold.setBold(true);
  title->setFont(bold);
  auto* form = new QFormLayout;
  form->addRow("Number of the participant", this->Number);
  this->AddQuestions(form);
  form->addRow("Results", this->MakeFolder(questions, folder));
  form->addRow("Device", this->Devices);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  this->Ok = buttons->button(QDialogButtonBox::Ok);
  this->Ok->setObjectName("task-begin");
  auto* column = new QVBoxLayout(this);
  column->addWidget(title);
  column->addLayout(form);
  column->addWidget(this->Line);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &TaskForm::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &TaskForm::reject);
  connect(this->Number, QOverload<int>::of(&QSpinBox::valueChanged), this, &TaskForm::Look);
  connect(this->Results, &QLineEdit::textChanged, this, &TaskForm::Look);
  this->ChooseNumber();
  this->Look();
}

// Free text is not possible, so that no names are stored.
void TaskForm::AddQuestions(QFormLayout* form)
{
  for (const TaskQuestion& question : this->Task.Questions)
  {
    QWidget* box = nullptr;
    if (question.Choices.empty())
    {
      auto* number = new QLineEdit(this);
      number->setPlaceholderText(QString("%1 to %2").arg(question.Least).arg(question.Most));
      this->Replies.emplace_back([number] { return number->text().trimmed(); });
      box = number;
    }
    else
    {
      auto* choice = new QComboBox(this);
      choice->addItem({});
      for (const std::string& word : question.Choices)
      {
        choice->addItem(ScreenString(word));
      }
      this->Replies.emplace_back([choice] { return choice->currentText(); });
      box = choice;
    }
    box->setObjectName("task-ask-" + QString::fromStdString(question.Key));
    this->Boxes.push_back(box);
    QLabel* text = MakePlainLabel("", this);
    text->setText(ScreenString(question.Text.empty() ? question.Key : question.Text));
    form->addRow(text, box);
  }
}

QWidget* TaskForm::MakeFolder(const FileQuestions& questions, const std::filesystem::path& folder)
{
  auto* both = new QWidget(this);
  auto* row = new QHBoxLayout(both);
  row->setContentsMargins(0, 0, 0, 0);
  this->Results->setObjectName("task-folder");
  this->Results->setMinimumWidth(36 * this->fontMetrics().averageCharWidth());
  this->Results->setText(QString::fromStdString(folder.string()));
  auto* choose = new QPushButton("Choose...", both);
  row->addWidget(this->Results, 1);
  row->addWidget(choose);
  connect(choose, &QPushButton::clicked, this,
          [this, &questions]
          {
            const QString chosen = questions.Folder(this, "Folder for the results");
            this->Results->setText(chosen.isEmpty() ? this->Results->text() : chosen);
          });
  return both;
}

TaskParticipant TaskForm::Participant() const
{
  TaskParticipant participant;
  participant.Number = this->Number->value();
  for (std::size_t i = 0; i < this->Replies.size(); ++i)
  {
    const std::string reply = this->Replies[i]().toStdString();
    if (!reply.empty())
    {
      participant.Answers[this->Task.Questions[i].Key] = reply;
    }
  }
  return participant;
}

bool TaskForm::HasLog(int number) const
{
  std::error_code failure;
  return std::filesystem::exists(this->Folder() / TaskRun::LogName(number), failure);
}

// Whoever was interrupted comes first.
void TaskForm::ChooseNumber()
{
  int number = 1;
  const auto isDone = [this](int one)
  {
    try
    {
      return this->HasLog(one) &&
             TaskRun(this->Task, {one, {}, {}, 0}, this->Folder()).State() == TaskState::Finished;
    }
    catch (const InputError&)
    {
      return true; // damaged, or written by another program
    }
  };
  while (number < MostParticipants && isDone(number))
  {
    ++number;
  }
  this->Number->setValue(number);
}

void TaskForm::Look()
{
  const bool isResumed = this->HasLog(this->Number->value());
  bool isUsable = !this->Results->text().isEmpty();
  QString text = QString("Begins with the first of %1 trials.")
                     .arg(PlanOf(this->Task, this->Number->value()).size());
  if (isResumed)
  {
    try
    {
      const TaskRun run(this->Task, {this->Number->value(), {}, {}, 0}, this->Folder());
      isUsable = run.Trial() != nullptr;
      text = isUsable ? QString("Resumes at trial %1 of %2, with the answers of its beginning.")
                            .arg(run.Trial()->Number)
                            .arg(run.Plan().size())
                      : QString("This participant has finished: choose another number.");
    }
    catch (const InputError& error)
    {
      isUsable = false;
      text = ScreenString(error.what());
    }
  }
  this->Line->setText(text);
  this->Ok->setText(isResumed ? "Resume" : "Begin");
  this->Ok->setEnabled(isUsable);
  for (QWidget* box : this->Boxes)
  {
    box->setEnabled(!isResumed);
  }
}

void TaskForm::accept()
{
  try
  {
    const bool isResumed = this->HasLog(this->Number->value());
    MakeOutputFolder(this->Folder());
    this->Run = std::make_unique<TaskRun>(
        this->Task,
        isResumed ? TaskParticipant{this->Number->value(), {}, {}, 0} : this->Participant(),
        this->Folder());
    QDialog::accept();
  }
  catch (const InputError& error)
  {
    this->Line->setText(ScreenString(error.what()));
  }
}
} // namespace palpate
