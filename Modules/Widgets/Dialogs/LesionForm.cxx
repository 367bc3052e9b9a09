#include "LesionForm.h"

#include "SceneTissue.h"
#include "ScreenString.h"

#include <array>

namespace palpate
{
namespace
{
// Young's moduli of tissue and of its lesion, kPa.
struct TissuePreset
{
  const char* Name;
  double Tissue;
  double Lesion;
  const char* Source;
};
constexpr std::array<TissuePreset, 4> TissuePresets{
    {{"Phantom, lesion 3 : 1", 20.0, 60.0, "An assumption of this program, not a measurement."},
     {"Prostate and its cancer, ex vivo", 17.0, 24.1,
      "Ahn et al. 2010, indentation: 17.0 \u00b1 9.0 and 24.1 \u00b1 14.5 kPa."},
     {"Breast and high-grade carcinoma", 3.24, 42.5,
      "Samani et al. 2007, ex vivo: 3.24 \u00b1 0.61 and 42.5 \u00b1 12.5 kPa."},
     {"Breast and fibroadenoma", 3.24, 6.41,
      "Samani et al. 2007, ex vivo: 3.24 \u00b1 0.61 and 6.41 \u00b1 2.86 kPa."}}};
} // namespace

LesionForm::LesionForm(const StudyState& state, int id, QWidget* parent)
    : QGroupBox("Lesion", parent), Which(new QComboBox(this)), Modulus(new QDoubleSpinBox(this))
{
  constexpr double Largest = 1e6; // kPa
  this->Which->setObjectName("lesion");
  this->Which->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  this->Which->setMinimumContentsLength(16); // characters
  this->Which->addItem("none", 0);
  this->Modulus->setObjectName("lesion_kpa");
  this->Modulus->setRange(0.001, Largest);
  this->Modulus->setDecimals(3);
  this->Modulus->setSuffix(" kPa");
  this->Modulus->setValue(TissuePresets[0].Lesion);
  for (const SceneStructure& one : state.Structures)
  {
    if (one.Id == id || one.Source() != SceneSource::Label)
    {
      continue;
    }
    this->Which->addItem(ScreenString(TitleOf(one)), one.Id);
    if (this->Before == 0 && one.Number(TissueKey::Inclusion) > 0.0)
    {
      this->Before = one.Id;
      this->Which->setCurrentIndex(this->Which->count() - 1);
      this->Modulus->setValue(one.Number(TissueKey::Inclusion));
    }
  }
  this->ModulusBefore = this->Modulus->value();
  auto* rows = new QFormLayout(this);
  rows->addRow("Structure", this->Which);
  rows->addRow("Young's modulus", this->Modulus);
  this->Modulus->setEnabled(this->Before != 0);
  connect(this->Which, qOverload<int>(&QComboBox::currentIndexChanged), this->Modulus,
          [this](int index) { this->Modulus->setEnabled(index > 0); });
}

void LesionForm::AddPresets(QFormLayout* tissue, QDoubleSpinBox* modulus)
{
  auto* presets = new QComboBox(this);
  presets->setObjectName("tissue-preset");
  presets->addItem("Own values");
  for (const TissuePreset& preset : TissuePresets)
  {
    presets->addItem(preset.Name);
    presets->setItemData(presets->count() - 1, preset.Source, Qt::ToolTipRole);
  }
  auto* source = new QLabel("Moduli scatter widely: no number is the patient's.", this);
  source->setWordWrap(true);
  tissue->insertRow(0, "Moduli", presets);
  tissue->insertRow(1, source);
  connect(presets, qOverload<int>(&QComboBox::activated), this,
          [this, modulus, source](int chosen)
          {
            if (chosen > 0)
            {
              const TissuePreset& preset = TissuePresets.at(static_cast<std::size_t>(chosen - 1));
              modulus->setValue(preset.Tissue);
              this->Modulus->setValue(preset.Lesion);
              source->setText(preset.Source);
            }
          });
}

void LesionForm::Write(StudyState& state) const
{
  const int chosen = this->Which->currentData().toInt();
  if (chosen == this->Before && this->Modulus->value() == this->ModulusBefore)
  {
    return;
  }
  for (SceneStructure& one : state.Structures)
  {
    if (one.Id == chosen)
    {
      one.SetNumber(TissueKey::Inclusion, this->Modulus->value());
    }
    else if (one.Id == this->Before)
    {
      one.SetNumber(TissueKey::Inclusion, 0.0);
    }
  }
}
} // namespace palpate
