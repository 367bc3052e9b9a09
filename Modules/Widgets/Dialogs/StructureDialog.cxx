#include "StructureDialog.h"

#include "ContactLimits.h"
#include "SceneTissue.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabWidget>

#include <algorithm>

namespace palpate
{
namespace
{
// Pages are higher than small screens. To be called when the page is filled, since it decides on
// the width.
QScrollArea* Scrolled(QWidget* page)
{
  auto* area = new QScrollArea;
  area->setWidget(page);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setMinimumWidth(page->sizeHint().width() + area->verticalScrollBar()->sizeHint().width());
  return area;
}
} // namespace

StructureDialog::StructureDialog(StudyController& study, int id, QWidget* parent)
    : QDialog(parent), Study(study), Structure(*FindStructure(study.State(), id))
{
  this->setWindowTitle(QString::fromStdString(TitleOf(this->Structure)));
  auto* all = new QVBoxLayout(this);
  auto* tabs = new QTabWidget(this);
  tabs->setObjectName("details");
  auto* model = new QWidget(tabs);
  auto* contact = new QWidget(tabs);
  auto* images = new QWidget(tabs);
  all->addWidget(tabs);
  this->Form = new QFormLayout(model);
  this->Rows = this->Form;
  this->AddRepresentation();
  this->AddModelMembers();
  this->Form = new QFormLayout(contact);
  this->Rows = this->Form;
  this->AddContactMembers();
  if (this->Structure.Source() == SceneSource::Label)
  {
    this->AddNumbers(SurroundingNumbers());
    this->AddChoice("Where the scan cuts it", "keeps-cuts", {"not felt", "felt as its surface"},
                    this->Structure.KeepsCuts ? 1 : 0,
                    [](SceneStructure& structure, int choice)
                    { structure.KeepsCuts = choice == 1; });
  }
  auto* groups = new QVBoxLayout(images);
  for (const SceneEffectKind& kind : SceneEffectKinds())
  {
    this->AddEffect(kind, groups);
  }
  groups->addStretch(1);
  tabs->addTab(Scrolled(model), "Touch &model");
  tabs->addTab(Scrolled(contact), "&Contact");
  tabs->addTab(Scrolled(images), "Forces from &images");
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  all->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &StructureDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

// Those from images have a group each.
void StructureDialog::AddEffect(const SceneEffectKind& kind, QVBoxLayout* groups)
{
  if (kind.ImageKey.empty())
  {
    this->AddNumbers(kind.Numbers);
    return;
  }
  const QString name = QString::fromStdString(kind.Name);
  auto* group = new QGroupBox(name.left(1).toUpper() + name.mid(1), groups->parentWidget());
  groups->addWidget(group);
  this->Rows = new QFormLayout(group);
  this->AddNumbers(kind.Numbers);
  this->AddImage(kind.ImageLabel, kind.ImageKey);
  this->Rows = this->Form;
}

// The choice, and below it what the chosen representation needs.
void StructureDialog::AddRepresentation()
{
  QStringList labels;
  std::vector<std::string> names;
  for (const SceneRepresentation& one : SceneRepresentations())
  {
    if (one.Takes(this->Structure.Source()) || one.Name == this->Structure.Representation)
    {
      labels += QString::fromStdString(one.Label);
      names.push_back(one.Name);
    }
  }
  const auto chosen = std::find(names.begin(), names.end(), this->Structure.Representation);
  QComboBox* choice = this->AddChoice(
      "Touch model", "representation", labels, static_cast<int>(chosen - names.begin()),
      [names](SceneStructure& structure, int index)
      { structure.Representation = names.at(static_cast<std::size_t>(index)); });
  for (const SceneRepresentation& one : SceneRepresentations())
  {
    const auto place = std::find(names.begin(), names.end(), one.Name);
    if (place == names.end() || (one.Numbers.empty() && one.ImageKey.empty()))
    {
      continue;
    }
    QWidget* own = this->MakeRows(one);
    this->Form->addRow(own);
    const int number = static_cast<int>(place - names.begin());
    own->setVisible(choice->currentIndex() == number);
    connect(choice, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
            [this, own, number](int index)
            {
              own->setVisible(index == number);
              this->adjustSize();
            });
  }
}

// What a representation needs, in groups.
QWidget* StructureDialog::MakeRows(const SceneRepresentation& representation)
{
  auto* own = new QWidget(this);
  auto* groups = new QVBoxLayout(own);
  groups->setContentsMargins(0, 0, 0, 0);
  const auto add = [&](const QString& title)
  {
    auto* group = new QGroupBox(title, own);
    groups->addWidget(group);
    this->Rows = new QFormLayout(group);
  };
  const bool yields = representation.Name == TouchRepresentation::Elastic;
  add(yields ? "Tissue" : QString::fromStdString(representation.Label));
  std::string title;
  std::vector<SceneNumber> others;
  for (const SceneNumber& number : representation.Numbers)
  {
    number.Group.empty() ? this->AddOne(number) : others.push_back(number);
  }
  this->AddImage(representation.ImageLabel, representation.ImageKey);
  if (yields)
  {
    this->Lesion = new LesionForm(this->Study.State(), this->Structure.Id, own);
    this->Lesion->AddPresets(this->Rows, own->findChild<QDoubleSpinBox*>(TissueKey::Modulus));
    groups->addWidget(this->Lesion);
  }
  for (const SceneNumber& number : others)
  {
    if (number.Group != title)
    {
      title = number.Group;
      add(QString::fromStdString(title));
    }
    this->AddOne(number);
  }
  this->Rows = this->Form;
  return own;
}

void StructureDialog::AddModelMembers()
{
  this->AddChoice("Harmonics", "mode", {"nearest point", "radial"},
                  static_cast<int>(this->Structure.Mode),
                  [](SceneStructure& structure, int choice)
                  { structure.Mode = static_cast<RadialContactMode>(choice); });
  this->AddChoice("Interpolation", "interpolation", {"linear", "cubic"},
                  static_cast<int>(this->Structure.Interpolation),
                  [](SceneStructure& structure, int choice)
                  { structure.Interpolation = static_cast<FieldInterpolation>(choice); });
  this->AddNumber("Smoothing of the field, voxels", "smoothing", 8.0, 2,
                  [](SceneStructure& structure) -> double& { return structure.Smoothing; });
}

void StructureDialog::AddContactMembers()
{
  this->AddNumber("Stiffness, N/mm", "stiffness", ContactLimits::Stiffness, 3,
                  [](SceneStructure& structure) -> double& { return structure.Stiffness; });
  this->AddNumber("Damping, N s/mm", "damping", ContactLimits::Damping, 5,
                  [](SceneStructure& structure) -> double& { return structure.Damping; });
  this->AddNumber("Static friction", "static-friction", ContactLimits::Friction, 3,
                  [](SceneStructure& structure) -> double& { return structure.Friction.Static; });
  this->AddNumber("Dynamic friction", "dynamic-friction", ContactLimits::Friction, 3,
                  [](SceneStructure& structure) -> double& { return structure.Friction.Dynamic; });
}

void StructureDialog::AddNumber(const QString& label, const QString& name, double most,
                                int decimals, const std::function<double&(SceneStructure&)>& member)
{
  this->AddBox({name.toStdString(), label.toStdString(), most, decimals}, member(this->Structure),
               [member](SceneStructure& structure, double value) { member(structure) = value; });
}

QDoubleSpinBox* StructureDialog::AddBox(const SceneNumber& number, double value,
                                        const std::function<void(SceneStructure&, double)>& set)
{
  auto* box = new QDoubleSpinBox(this);
  box->setObjectName(QString::fromStdString(number.Key));
  box->setDecimals(number.Decimals);
  box->setRange(number.Least, number.Largest);
  box->setSingleStep(number.Decimals == 0 ? 1.0 : 0.1);
  box->setSuffix(number.Unit.empty() ? QString() : " " + QString::fromStdString(number.Unit));
  box->setSpecialValueText(QString::fromStdString(number.Zero));
  box->setValue(value);
  this->Rows->addRow(QString::fromStdString(number.Label), box);
  // A value that the box rounds is kept until it is edited.
  this->Writes.emplace_back(
      [box, set, shown = box->value()](SceneStructure& structure)
      {
        if (box->value() != shown)
        {
          set(structure, box->value());
        }
      });
  return box;
}

QComboBox* StructureDialog::AddChoice(const QString& label, const QString& name,
                                      const QStringList& choices, int value,
                                      const std::function<void(SceneStructure&, int)>& set)
{
  auto* box = new QComboBox(this);
  box->setObjectName(name);
  box->addItems(choices);
  box->setCurrentIndex(value);
  this->Rows->addRow(label, box);
  this->Writes.emplace_back([box, set](SceneStructure& structure)
                            { set(structure, box->currentIndex()); });
  return box;
}

void StructureDialog::AddNumbers(const std::vector<SceneNumber>& numbers)
{
  for (const SceneNumber& number : numbers)
  {
    this->AddOne(number);
  }
}

void StructureDialog::AddOne(const SceneNumber& number)
{
  const double value = this->Structure.Number(number.Key);
  const auto set = [key = number.Key](SceneStructure& structure, double chosen)
  { structure.SetNumber(key, chosen); };
  if (number.Words.empty())
  {
    this->AddBox(number, value, set);
    return;
  }
  QStringList words;
  for (const std::string& word : number.Words)
  {
    words += QString::fromStdString(word);
  }
  this->AddChoice(QString::fromStdString(number.Label), QString::fromStdString(number.Key), words,
                  static_cast<int>(value), set);
}

QStringList StructureDialog::OpenVolumes() const
{
  QStringList files;
  const StudyState& state = this->Study.State();
  if (!state.VolumeFile.empty())
  {
    files += QString::fromStdString(state.VolumeFile.string());
  }
  for (const StudyVolume& volume : state.Volumes)
  {
    files += QString::fromStdString(volume.File.string());
  }
  return files;
}

void StructureDialog::AddImage(const std::string& label, const std::string& key)
{
  if (key.empty())
  {
    return;
  }
  const QString title = QString::fromStdString(label);
  const QString shown = QString::fromStdString(this->Structure.Image(key).string());
  auto* both = new QWidget(this);
  auto* row = new QHBoxLayout(both);
  row->setContentsMargins(0, 0, 0, 0);
  // Any file, and those that are open to choose from.
  auto* file = new QComboBox(both);
  file->setEditable(true);
  file->addItems(this->OpenVolumes());
  file->setCurrentIndex(-1);
  file->setCurrentText(shown);
  file->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  file->setMinimumContentsLength(12); // characters
  file->setObjectName(QString::fromStdString(key));
  auto* browse = new QPushButton("Browse...", both);
  row->addWidget(file, 1);
  row->addWidget(browse);
  this->Rows->addRow(title, both);
  connect(browse, &QPushButton::clicked, this,
          [this, file, title]
          {
            const QString chosen = QFileDialog::getOpenFileName(this, title);
            file->setCurrentText(chosen.isEmpty() ? file->currentText() : chosen);
          });
  this->Writes.emplace_back(
      [file, key](SceneStructure& structure)
      { structure.SetImage(key, StudyPath(file->currentText().toStdString())); });
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
  if (this->Lesion != nullptr)
  {
    this->Lesion->Write(next);
  }
  this->Study.Change(
      "Change how " + QString::fromStdString(TitleOf(this->Structure)) + " is touched", next);
  this->QDialog::accept();
}
} // namespace palpate
