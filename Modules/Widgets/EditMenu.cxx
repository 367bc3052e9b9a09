#include "EditMenu.h"

#include "ScreenString.h"

namespace palpate
{
namespace
{
void Name(QAction* action, const QString& verb, const std::string& step)
{
  action->setEnabled(!step.empty());
  action->setText(step.empty() ? verb : verb + ": " + MenuString(ScreenString(step)));
}
} // namespace

EditMenu::EditMenu(StudyController& study, QWidget* window) : QMenu("&Edit", window), Study(study)
{
  this->Undo =
      this->addAction("&Undo", &study, &StudyController::Undo, QKeySequence(QKeySequence::Undo));
  this->Redo =
      this->addAction("&Redo", &study, &StudyController::Redo, QKeySequence(QKeySequence::Redo));
  connect(&study, &StudyController::StateChanged, this, &EditMenu::Show);
  this->Show();
}

void EditMenu::Show()
{
  Name(this->Undo, "&Undo", this->Study.Current().History().UndoText());
  Name(this->Redo, "&Redo", this->Study.Current().History().RedoText());
}
} // namespace palpate
