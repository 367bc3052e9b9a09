#include "GuideDialog.h"

#include "ScreenString.h"

#include <QDialogButtonBox>
#include <QLabel>

#include <algorithm>

namespace palpate
{
namespace
{
// After the first one, in the order of the shapes of structures.
int KindOf(GuideShape shape)
{
  return 1 + static_cast<int>(shape) - static_cast<int>(GuideShape::Inside);
}

GuideShape ShapeOf(int kind)
{
  return static_cast<GuideShape>(kind - 1 + static_cast<int>(GuideShape::Inside));
}

std::vector<GuideSettings>::iterator FindGuide(std::vector<GuideSettings>& guides, int id)
{
  return std::find_if(guides.begin(), guides.end(),
                      [id](const GuideSettings& one)
                      { return one.HasStructure() && one.Structure == id; });
}
} // namespace

GuideDialog::GuideDialog(StudyController& study, int id, QWidget* parent)
    : QDialog(parent), Study(study), Form(new QFormLayout(this)), Structures(new QComboBox(this)),
      Kind(new QComboBox(this))
{
  this->setWindowTitle("Guide the tool");
  this->AddChoices(id);
  this->Distance = this->AddNumber("Distance from the surface, mm", "guide-distance", -500, 500, 2);
  this->Distance->setToolTip("Where the tool is kept: outside of the surface, or below 0, inside");
  this->Stiffness =
      this->AddNumber("Stiffness, N/mm", "guide-stiffness", 0.001, GuideSettings::MostStiffness, 3);
  this->Range = this->AddNumber("Range, mm", "guide-range", 0.5, 1000, 2);
  this->Range->setToolTip("Farther away, the guide does not act");
  this->LargestForce =
      this->AddNumber("Largest force, N", "guide-force", 0.01, GuideSettings::MostForce, 2);
  auto* note =
      new QLabel("Acts on the tool's centre while you touch. The structure need be neither "
                 "visible nor touchable.",
                 this);
  note->setWordWrap(true);
  this->Form->addRow(note);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  this->Form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &GuideDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(this->Structures, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          &GuideDialog::ShowStructure);
  connect(this->Kind, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          &GuideDialog::EnableNumbers);
  this->ShowStructure();
}

void GuideDialog::AddChoices(int id)
{
  this->Structures->setObjectName("guide-structure");
  for (const SceneStructure& one : this->Study.State().Structures)
  {
    this->Structures->addItem(ScreenString(TitleOf(one)), one.Id);
  }
  this->Structures->setCurrentIndex(this->Structures->findData(id));
  this->Form->addRow("Structure", this->Structures);
  this->Kind->setObjectName("guide-kind");
  this->Kind->addItems({"No guide", "Stay inside", "Stay outside", "Stay on the surface"});
  this->Form->addRow("Guide", this->Kind);
}

QDoubleSpinBox* GuideDialog::AddNumber(const QString& label, const char* name, double least,
                                       double most, int decimals)
{
  auto* box = new QDoubleSpinBox(this);
  box->setObjectName(name);
  box->setDecimals(decimals);
  box->setRange(least, most);
  box->setSingleStep(0.1);
  this->Form->addRow(label, box);
  return box;
}

// The guide that the chosen structure has, or one to start with.
void GuideDialog::ShowStructure()
{
  std::vector<GuideSettings> guides = this->Study.State().Guides;
  const auto found = FindGuide(guides, this->ChosenId());
  const bool isThere = found != guides.end();
  const GuideSettings guide = isThere ? *found : GuideSettings();
  this->Kind->setCurrentIndex(isThere ? KindOf(guide.Shape) : 0);
  this->Distance->setValue(guide.Distance);
  this->Stiffness->setValue(guide.Stiffness);
  this->Range->setValue(guide.Range);
  this->LargestForce->setValue(guide.LargestForce);
  this->EnableNumbers();
}

void GuideDialog::EnableNumbers()
{
  for (QDoubleSpinBox* box : {this->Distance, this->Stiffness, this->Range, this->LargestForce})
  {
    box->setEnabled(this->Kind->currentIndex() > 0);
  }
}

GuideSettings GuideDialog::Chosen() const
{
  GuideSettings guide;
  guide.Shape = ShapeOf(this->Kind->currentIndex());
  guide.Structure = this->ChosenId();
  guide.Distance = this->Distance->value();
  guide.Stiffness = this->Stiffness->value();
  guide.Range = this->Range->value();
  guide.LargestForce = this->LargestForce->value();
  return guide;
}

void GuideDialog::accept()
{
  StudyState next = this->Study.State();
  const QString title = this->Structures->currentText();
  const auto found = FindGuide(next.Guides, this->ChosenId());
  const bool guides = this->Kind->currentIndex() > 0;
  if (found != next.Guides.end())
  {
    next.Guides.erase(found);
  }
  if (guides)
  {
    next.Guides.push_back(this->Chosen());
  }
  this->Study.Change((guides ? "Guide the tool by " : "Do not guide the tool by ") + title, next);
  this->QDialog::accept();
}
} // namespace palpate
