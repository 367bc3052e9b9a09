#include "VolumePanel.h"

#include "PlainLabel.h"
#include "ScreenString.h"

#include "vtkCommand.h"
#include "vtkImageData.h"

#include <QFormLayout>
#include <QSignalBlocker>

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
// Of CT, in Hounsfield units, as customary in radiology (radiopaedia.org, "Windowing (CT)").
struct WindowPreset
{
  const char* Name;
  double Width;
  double Level;
};
constexpr std::array<WindowPreset, 4> Presets{{{"CT: bone", 1800.0, 400.0},
                                               {"CT: soft tissue", 400.0, 50.0},
                                               {"CT: lung", 1500.0, -600.0},
                                               {"CT: brain", 80.0, 40.0}}};
constexpr int AutomaticPreset = 0;
constexpr int RangePreset = 1;
constexpr int FirstPreset = 2;

QString SizeText(vtkImageData* image)
{
  const int* size = image->GetDimensions();
  const double* spacing = image->GetSpacing();
  return QString("%1 \u00d7 %2 \u00d7 %3, %4 \u00d7 %5 \u00d7 %6 mm")
      .arg(size[0])
      .arg(size[1])
      .arg(size[2])
      .arg(spacing[0], 0, 'g', 3)
      .arg(spacing[1], 0, 'g', 3)
      .arg(spacing[2], 0, 'g', 3);
}

QLabel* MakeText(const char* name, QWidget* parent)
{
  QLabel* label = MakePlainLabel(name, parent);
  label->setWordWrap(true);
  return label;
}
} // namespace

VolumePanel::VolumePanel(StudyController& study, const ViewContents& contents, QWidget* parent)
    : QWidget(parent), Study(study), Images(contents.Images()),
      VolumeText(MakeText("volume-name", this)), LabelsText(MakeText("labels-name", this)),
      Width(this->AddNumber("window")), Level(this->AddNumber("level")), Preset(new QComboBox(this))
{
  this->Width->setMinimum(0.0);
  this->Preset->setObjectName("window-preset");
  this->Preset->setToolTip("Automatic: from the 1st to the 99.5th percentile of the volume");
  this->Preset->addItems({"Automatic", "Full range"});
  for (const WindowPreset& preset : Presets)
  {
    this->Preset->addItem(preset.Name);
  }
  auto* form = new QFormLayout(this);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  form->addRow(this->VolumeText);
  form->addRow(this->LabelsText);
  form->addRow("Window", this->Width);
  form->addRow("Level", this->Level);
  form->addRow("Preset", this->Preset);
  connect(this->Preset, qOverload<int>(&QComboBox::activated), this, &VolumePanel::TakePreset);
  connect(&study, &StudyController::StateChanged, this, &VolumePanel::ShowFiles);
  connect(&study, &StudyController::ProductsChanged, this, &VolumePanel::ShowFiles);
  this->Images->AddObserver(vtkCommand::ModifiedEvent, this, &VolumePanel::ShowWindow);
  this->ShowFiles();
}

QDoubleSpinBox* VolumePanel::AddNumber(const char* name)
{
  constexpr double Most = 1e9;
  auto* box = new QDoubleSpinBox(this);
  box->setObjectName(name);
  box->setRange(-Most, Most);
  box->setKeyboardTracking(false);
  connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &VolumePanel::TakeNumbers);
  return box;
}

void VolumePanel::ShowFiles()
{
  const StudyState& state = this->Study.State();
  vtkImageData* image = this->Images->GetImage();
  const auto name = [](const std::filesystem::path& file)
  { return ScreenString(file.filename().string()); };
  const QString size = image != nullptr ? "  " + SizeText(image) : QString();
  this->VolumeText->setText(state.VolumeFile.empty() ? QString("No volume")
                                                     : name(state.VolumeFile) + size);
  this->LabelsText->setText(
      state.SegmentationFile.empty()
          ? QString("No segmentation")
          : QString("%1  %2 %3")
                .arg(name(state.SegmentationFile))
                .arg(state.Structures.size())
                .arg(state.Structures.size() == 1 ? "structure" : "structures"));
  this->ShowWindow();
}

void VolumePanel::ShowWindow()
{
  const bool isShown = this->Images->GetImage() != nullptr;
  for (QWidget* control : std::array<QWidget*, 3>{this->Width, this->Level, this->Preset})
  {
    control->setEnabled(isShown);
  }
  const QSignalBlocker width(this->Width);
  const QSignalBlocker level(this->Level);
  // A step is a hundredth of what there is, and no digit is shown that a step does not need.
  const double step = std::pow(10.0, std::floor(std::log10(this->Images->GetChosenWindow())) - 1.0);
  for (QDoubleSpinBox* box : {this->Width, this->Level})
  {
    box->setDecimals(std::max(0, static_cast<int>(1.0 - std::floor(std::log10(step)))));
    box->setSingleStep(step);
  }
  this->Width->setValue(this->Images->GetWindow());
  this->Level->setValue(this->Images->GetLevel());
}

void VolumePanel::TakeNumbers()
{
  this->Images->SetWindowLevel(this->Width->value(), this->Level->value());
}

void VolumePanel::TakePreset(int preset)
{
  if (preset == AutomaticPreset)
  {
    this->Images->ResetWindowLevel();
  }
  else if (preset == RangePreset)
  {
    const double* range = this->Images->GetImage()->GetScalarRange();
    this->Images->SetWindowLevel(range[1] - range[0], 0.5 * (range[0] + range[1]));
  }
  else
  {
    const WindowPreset& chosen = Presets.at(static_cast<std::size_t>(preset - FirstPreset));
    this->Images->SetWindowLevel(chosen.Width, chosen.Level);
  }
}
} // namespace palpate
