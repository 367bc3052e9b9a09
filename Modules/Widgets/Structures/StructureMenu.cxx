#include "StructureMenu.h"

#include <algorithm>

namespace palpate
{
StructureMenu::StructureMenu(QWidget* parent) : QMenu(parent)
{
  this->setObjectName("structure-menu");
  this->Add(OnlyThis, "Show &only this", "structure-only");
  this->Add(Show, "&Show", "structure-show");
  this->Add(Touch, "Make &touchable", "structure-touch");
  this->addSeparator();
  this->Add(Color, "&Colour...", "structure-color");
  this->Add(Opacity, "O&pacity...", "structure-opacity");
  this->Add(Details, "&Details...", "structure-menu-details");
  this->Add(Guide, "&Guide the tool...", "structure-guide");
  this->Add(Rename, "Re&name\tF2", "structure-rename");
  this->addSeparator();
  this->Add(Centre, "Centre &views", "structure-centre");
  this->Add(Check, "Chec&k all structures", "structure-check");
  this->addSeparator();
  this->Add(Remove, "&Remove", "structure-menu-remove");
}

void StructureMenu::Add(Entry entry, const QString& text, const QString& name)
{
  QAction* action = this->addAction(text, this, [this, entry] { Q_EMIT Chosen(entry); });
  action->setObjectName(name);
  this->Entries.at(entry) = action;
}

void StructureMenu::Offer(const std::vector<SceneStructure>& selected)
{
  this->AnyHidden = std::any_of(selected.begin(), selected.end(),
                                [](const SceneStructure& one) { return !one.IsVisible; });
  this->AnyUntouchable = std::any_of(selected.begin(), selected.end(),
                                     [](const SceneStructure& one) { return !one.IsTouchable; });
  this->Entries[OnlyThis]->setText(selected.size() > 1 ? "Show &only these" : "Show &only this");
  this->Entries[Show]->setText(this->AnyHidden ? "&Show" : "&Hide");
  this->Entries[Touch]->setText(this->AnyUntouchable ? "Make &touchable" : "Make un&touchable");
  for (QAction* action : this->Entries)
  {
    action->setEnabled(!selected.empty());
  }
  this->Entries[Check]->setEnabled(true);
  for (const Entry entry : {Details, Guide, Rename, Centre})
  {
    this->Entries.at(entry)->setEnabled(selected.size() == 1);
  }
}
} // namespace palpate
