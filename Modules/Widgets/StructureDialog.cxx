#include "StructureDialog.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QPushButton>

namespace palpate
{
StructureDialog::StructureDialog(StudyController& study, int id, QWidget* parent)
    : QDialog(parent), Study(study), Structure(*FindStructure(study.State(), id)),
      Form(new QFormLayout(this))
{
  this->setWindowTitle(QString::fromStdString(TitleOf(this->Structure)));
  this->AddChoice("Harmonics", "mode", {"nearest point", "radial"},
                  static_cast<int>(this->Structure.Mode),
                  [](SceneStructure& structure, int choice)
                  { structure.Mode = static_cast<HarmonicContactMode>(choice); });
  this->AddChoice("Interpolation", "interpolation", {"linear", "cubic"},
                  static_cast<int>(this->Structure.Interpolation),
                  [](SceneStructure& structure, int choice)
                  { structure.Interpolation = static_cast<FieldInterpolation>(choice); });
  this->AddNumber("Smoothing of the field, voxels", "smoothing", 8.0, 2,
                  [](SceneStructure& structure) -> double& { return structure.Smoothing; });
  this->AddNumber("Stiffness, N/mm", "stiffness", 1e4, 3,
                  [](SceneStructure& structure) -> double& { return structure.Stiffness; });
  this->AddNumber("Damping, N s/mm", "damping", 10.0, 5,
                  [](SceneStructure& structure) -> double& { return structure.Damping; });
  this->AddNumber("Static friction", "static-friction", 10.0, 3,
                  [](SceneStructure& structure) -> double& { return structure.Friction.Static; });
  this->AddNumber("Dynamic friction", "dynamic-friction", 10.0, 3,
                  [](SceneStructure& structure) -> double& { return structure.Friction.Dynamic; });
  for (const SceneRepresentation& representation : SceneRepresentations())
  {
    this->AddNumbers(representation.Numbers);
  }
  for (const SceneEffectKind& kind : SceneEffectKinds())
  {
    this->AddNumbers(kind.Numbers);
    if (!kind.ImageKey.empty())
    {
      this->AddImage(QString::fromStdString(kind.ImageLabel), kind.ImageKey);
    }
  }
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  this->Form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &StructureDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void StructureDialog::AddNumber(const QString& label, const QString& name, double most,
                                int decimals, const std::function<double&(SceneStructure&)>& member)
{
  this->AddBox(label, name, most, decimals, member(this->Structure),
               [member](SceneStructure& structure, double value) { member(structure) = value; });
}

void StructureDialog::AddBox(const QString& label, const QString& name, double most, int decimals,
                             double value, const std::function<void(SceneStructure&, double)>& set)
{
  auto* box = new QDoubleSpinBox(this);
  box->setObjectName(name);
  box->setDecimals(decimals);
  box->setRange(0.0, most);
  box->setSingleStep(0.1);
  box->setValue(value);
  this->Form->addRow(label, box);
  // A value that the box rounds is kept until it is edited.
  this->Writes.emplace_back(
      [box, set, shown = box->value()](SceneStructure& structure)
      {
        if (box->value() != shown)
        {
          set(structure, box->value());
        }
      });
}

void StructureDialog::AddChoice(const QString& label, const QString& name,
                                const QStringList& choices, int value,
                                const std::function<void(SceneStructure&, int)>& set)
{
  auto* box = new QComboBox(this);
  box->setObjectName(name);
  box->addItems(choices);
  box->setCurrentIndex(value);
  this->Form->addRow(label, box);
  this->Writes.emplace_back([box, set](SceneStructure& structure)
                            { set(structure, box->currentIndex()); });
}

void StructureDialog::AddNumbers(const std::vector<SceneNumber>& numbers)
{
  for (const SceneNumber& number : numbers)
  {
    this->AddBox(QString::fromStdString(number.Label), QString::fromStdString(number.Key),
                 number.Largest, number.Decimals, this->Structure.Number(number.Key),
                 [key = number.Key](SceneStructure& structure, double value)
                 { structure.SetNumber(key, value); });
  }
}

void StructureDialog::AddImage(const QString& label, const std::string& key)
{
  const std::string shown = this->Structure.Image(key).string();
  auto* file = new QLineEdit(QString::fromStdString(shown), this);
  file->setObjectName(QString::fromStdString(key));
  auto* browse = new QPushButton("Browse...", this);
  auto* row = new QHBoxLayout;
  row->addWidget(file, 1);
  row->addWidget(browse);
  this->Form->addRow(label, row);
  connect(browse, &QPushButton::clicked, this,
          [this, file, label]
          {
            const QString chosen = QFileDialog::getOpenFileName(this, label);
            file->setText(chosen.isEmpty() ? file->text() : chosen);
          });
  this->Writes.emplace_back([file, key](SceneStructure& structure)
                            { structure.SetImage(key, StudyPath(file->text().toStdString())); });
}

void StructureDialog::accept()
{
  StudyState next = this->Study.State();
  for (SceneStructure& structure : next.Structures)
  {
    if (structure.Id == this->Structure.Id)
    {
      for (const auto& write : this->Writes)
      {
        write(structure);
      }
    }
  }
  this->Study.Change(
      "Change how " + QString::fromStdString(TitleOf(this->Structure)) + " is touched", next);
  this->QDialog::accept();
}
} // namespace palpate
