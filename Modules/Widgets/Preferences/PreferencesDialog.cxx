#include "PreferencesDialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace palpate
{
PreferencesDialog::PreferencesDialog(KeyBindings& keys, QWidget* window)
    : QDialog(window), Pages(new QTabWidget(this)), Keys(new KeysPage(keys, this))
{
  this->setWindowTitle("Preferences");
  auto* column = new QVBoxLayout(this);
  this->Pages->addTab(this->MakeGeneral(), "&General");
  this->Pages->addTab(this->Keys, "&Keys");
  column->addWidget(this->Pages);
  auto* buttons =
      new QDialogButtonBox(QDialogButtonBox::RestoreDefaults | QDialogButtonBox::Close, this);
  column->addWidget(buttons);
  buttons->button(QDialogButtonBox::RestoreDefaults)->setAutoDefault(false);
  buttons->button(QDialogButtonBox::Close)->setDefault(true);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this,
          &PreferencesDialog::RestoreDefaults);
  this->ShowGeneral(Preferences::Kept());
}

QComboBox* PreferencesDialog::AddChoice(QFormLayout* form, const QString& label, const char* name,
                                        const QStringList& texts)
{
  auto* box = new QComboBox(this);
  box->setObjectName(name);
  box->addItems(texts);
  form->addRow(label, box);
  connect(box, QOverload<int>::of(&QComboBox::activated), this, &PreferencesDialog::TakeGeneral);
  return box;
}

QWidget* PreferencesDialog::MakeGeneral()
{
  auto* page = new QWidget(this);
  auto* form = new QFormLayout(page);
  this->Look =
      this->AddChoice(form, "&Theme", "preferred-look", {"As the system", "Light", "Dark"});
  this->LeftDrag = this->AddChoice(
      form, "&Left drag on slices", "preferred-left-drag",
      {"Moves the crosshair, as in ITK-SNAP", "Changes window and level, as in 3D Slicer"});
  this->Convention = this->AddChoice(form, "&Slices", "preferred-convention",
                                     {"Radiological: the patient's left is at the right",
                                      "Neurological: the patient's left is at the left"});
  this->Unit = this->AddChoice(form, "Lengths and &positions", "preferred-unit",
                               {"in mm", "in cm (drilling and settings stay in mm)"});
  auto* studies = new QLabel("New studies begin with", page);
  form->addRow(studies);
  this->Degree = new QSpinBox(page);
  this->Degree->setObjectName("preferred-degree");
  this->Degree->setRange(0, Preferences::LargestDegree);
  form->addRow("&Degree of models", this->Degree);
  connect(this->Degree, QOverload<int>::of(&QSpinBox::valueChanged), this,
          &PreferencesDialog::TakeGeneral);
  QStringList scales;
  for (const std::optional<double>& scale : ErrorScales)
  {
    scales += TextOf(scale);
  }
  this->ErrorScale = this->AddChoice(form, "Scale of &error maps", "preferred-error-scale", scales);
  return page;
}

void PreferencesDialog::ShowGeneral(const Preferences& preferences)
{
  const QSignalBlocker quiet(this->Degree);
  this->Look->setCurrentIndex(static_cast<int>(preferences.Look));
  this->LeftDrag->setCurrentIndex(preferences.LeftDragAdjustsWindow ? 1 : 0);
  this->Convention->setCurrentIndex(preferences.IsNeurological ? 1 : 0);
  this->Unit->setCurrentIndex(static_cast<int>(preferences.Unit));
  this->Degree->setValue(preferences.Degree);
  const auto scale = std::find(ErrorScales.begin(), ErrorScales.end(), preferences.ErrorScale);
  this->ErrorScale->setCurrentIndex(static_cast<int>(scale - ErrorScales.begin()));
}

void PreferencesDialog::TakeGeneral()
{
  Preferences chosen;
  chosen.Look = static_cast<WindowLook>(this->Look->currentIndex());
  chosen.LeftDragAdjustsWindow = this->LeftDrag->currentIndex() == 1;
  chosen.IsNeurological = this->Convention->currentIndex() == 1;
  chosen.Unit = static_cast<LengthUnit>(this->Unit->currentIndex());
  chosen.Degree = this->Degree->value();
  chosen.ErrorScale = ErrorScales.at(static_cast<std::size_t>(this->ErrorScale->currentIndex()));
  chosen.Keep();
  Q_EMIT Changed(chosen);
}

// Of the page that is shown.
void PreferencesDialog::RestoreDefaults()
{
  if (this->Pages->currentWidget() == this->Keys)
  {
    this->Keys->RestoreDefaults();
    return;
  }
  this->ShowGeneral({});
  this->TakeGeneral();
}
} // namespace palpate
