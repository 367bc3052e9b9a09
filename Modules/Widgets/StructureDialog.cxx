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
  this->AddNumber("Viscosity inside, N s/mm", "viscosity", 10.0, 5,
                  [](SceneStructure& structure) -> double& { return structure.Viscosity; });
  this->AddNumber("Texture, N", "texture", 10.0, 3,
                  [](SceneStructure& structure) -> double& { return structure.Texture; });
  this->AddTextureImage();
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  this->Form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &StructureDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void StructureDialog::AddNumber(const QString& label, const QString& name, double most,
                                int decimals, const std::function<double&(SceneStructure&)>& member)
{
  auto* box = new QDoubleSpinBox(this);
  box->setObjectName(name);
  box->setDecimals(decimals);
  box->setRange(0.0, most);
  box->setSingleStep(0.1);
  box->setValue(member(this->Structure));
  this->Form->addRow(label, box);
  // A value that the box rounds is kept until it is edited.
  this->Writes.emplace_back(
      [box, member, shown = box->value()](SceneStructure& structure)
      { member(structure) = box->value() == shown ? member(structure) : box->value(); });
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

void StructureDialog::AddTextureImage()
{
  auto* file = new QLineEdit(QString::fromStdString(this->Structure.TextureImage.string()), this);
  file->setObjectName("texture-image");
  auto* browse = new QPushButton("Browse...", this);
  auto* row = new QHBoxLayout;
  row->addWidget(file, 1);
  row->addWidget(browse);
  this->Form->addRow("Texture image", row);
  connect(browse, &QPushButton::clicked, this,
          [this, file]
          {
            const QString chosen = QFileDialog::getOpenFileName(this, "Choose a texture image");
            file->setText(chosen.isEmpty() ? file->text() : chosen);
          });
  this->Writes.emplace_back([file](SceneStructure& structure)
                            { structure.TextureImage = StudyPath(file->text().toStdString()); });
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
