#include "VolumePanel.h"

#include "PlainLabel.h"
#include "ScreenString.h"

#include "vtkCommand.h"
#include "vtkImageData.h"

#include <QFormLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

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
constexpr int OpacitySteps = 100;

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

QLabel* MakeWrappedText(const char* name, QWidget* parent)
{
  QLabel* label = MakePlainLabel(name, parent);
  label->setWordWrap(true);
  return label;
}
} // namespace

VolumePanel::VolumePanel(StudyController& study, const ViewContents& contents,
                         const FileQuestions& questions, QWidget* parent)
    : QWidget(parent), Study(study), Contents(contents), Images(contents.Images()),
      VolumeText(MakeWrappedText("volume-name", this)),
      LabelsText(MakeWrappedText("labels-name", this)), Volumes(new VolumeList(study, this)),
      Width(this->AddNumber("window")), Level(this->AddNumber("level")),
      Preset(new QComboBox(this)), Colors(new QComboBox(this)),
      Opacity(new QSlider(Qt::Horizontal, this)),
      HidesBelow(new QCheckBox("Transparent below the window", this)), OfOverlay(new QWidget(this)),
      Moving(new VolumeTransformRow(study, *Volumes, questions, OfOverlay)),
      InSpace(new VolumeRenderingRow(study, *Volumes, this))
{
  this->Width->setMinimum(0.0);
  this->Preset->setObjectName("window-preset");
  this->Preset->setToolTip("Automatic: from the 1st to the 99.5th percentile of the volume");
  this->Preset->addItems({"Automatic", "Full range"});
  for (const WindowPreset& preset : Presets)
  {
    this->Preset->addItem(preset.Name);
  }
  this->Colors->setObjectName("volume-colors");
  for (const VolumeColors colors : AllVolumeColors)
  {
    QString name = NameOf(colors);
    name[0] = name[0].toUpper();
    this->Colors->addItem(name);
  }
  this->Opacity->setObjectName("volume-opacity");
  this->Opacity->setToolTip("Opacity of a blend");
  this->Opacity->setRange(0, OpacitySteps);
  this->HidesBelow->setObjectName("volume-hides-below");
  this->HidesBelow->setToolTip(
      "Shows the first volume where this one is as dark as its background");
  auto* ofOverlay = new QFormLayout(this->OfOverlay);
  ofOverlay->setContentsMargins(0, 0, 0, 0);
  ofOverlay->addRow("Colours", this->Colors);
  ofOverlay->addRow("Opacity", this->Opacity);
  ofOverlay->addRow(this->HidesBelow);
  ofOverlay->addRow(this->Moving);
  auto* form = new QFormLayout;
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  form->addRow("Window", this->Width);
  form->addRow("Level", this->Level);
  form->addRow("Preset", this->Preset);
  // A form would keep the spacing of hidden rows.
  auto* rows = new QVBoxLayout(this);
  rows->addWidget(this->VolumeText);
  rows->addWidget(this->LabelsText);
  rows->addWidget(this->Volumes);
  rows->addLayout(form);
  rows->addWidget(this->OfOverlay);
  rows->addWidget(this->InSpace);
  connect(this->Preset, qOverload<int>(&QComboBox::activated), this, &VolumePanel::TakePreset);
  connect(this->Colors, qOverload<int>(&QComboBox::activated), this, &VolumePanel::TakeOverlay);
  connect(this->Opacity, &QSlider::valueChanged, this, &VolumePanel::TakeOverlay);
  connect(this->HidesBelow, &QCheckBox::clicked, this, &VolumePanel::TakeOverlay);
  connect(this->Opacity, &QSlider::sliderReleased, &study, &StudyController::EndGesture);
  connect(this->Moving, &VolumeTransformRow::ValuesAsked, this, &VolumePanel::ValuesAsked);
  connect(this->Volumes, &VolumeList::Changed, this, &VolumePanel::ShowFiles);
  connect(&study, &StudyController::StateChanged, this, &VolumePanel::ShowFiles);
  connect(&study, &StudyController::ViewChanged, this, &VolumePanel::ShowOverlay);
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
  vtkImageData* image = this->Image();
  const StudyVolume* overlay = this->Overlay();
  const std::filesystem::path& file = overlay != nullptr ? overlay->File : state.VolumeFile;
  const auto name = [](const std::filesystem::path& path)
  { return ScreenString(path.filename().string()); };
  const QString size = image != nullptr ? "  " + SizeText(image) : QString();
  this->VolumeText->setText(file.empty() ? QString("No volume") : name(file) + size);
  this->LabelsText->setText(
      state.SegmentationFile.empty()
          ? QString("No segmentation")
          : QString("%1  %2 %3")
                .arg(name(state.SegmentationFile))
                .arg(state.Structures.size())
                .arg(state.Structures.size() == 1 ? "structure" : "structures"));
  this->Moving->ShowVolume();
  this->InSpace->ShowVolume();
  this->ShowWindow();
}

// The volume over the first one that is selected, or null.
const StudyVolume* VolumePanel::Overlay() const
{
  return FindVolume(this->Study.State(), this->Volumes->Chosen());
}

vtkImageData* VolumePanel::Image() const
{
  const int id = this->Volumes->Chosen();
  return id == 0 ? this->Images->GetImage() : this->Contents.Volumes().ImageOf(id);
}

void VolumePanel::ShowWindow()
{
  const bool isShown = this->Image() != nullptr;
  for (QWidget* control : std::array<QWidget*, 3>{this->Width, this->Level, this->Preset})
  {
    control->setEnabled(isShown);
  }
  this->ShowOverlay();
  const std::optional<int> overlay = this->Contents.Volumes().OverlayOf(this->Volumes->Chosen());
  const double width =
      overlay ? this->Images->GetOverlayWindow(*overlay) : this->Images->GetWindow();
  const double unit = overlay ? width : this->Images->GetChosenWindow();
  const QSignalBlocker blockWidth(this->Width);
  const QSignalBlocker blockLevel(this->Level);
  // A step is a hundredth of what there is, and no digit is shown that a step does not need.
  const double step = std::pow(10.0, std::floor(std::log10(unit)) - 1.0);
  for (QDoubleSpinBox* box : {this->Width, this->Level})
  {
    box->setDecimals(std::max(0, static_cast<int>(1.0 - std::floor(std::log10(step)))));
    box->setSingleStep(step);
  }
  this->Width->setValue(width);
  this->Level->setValue(overlay ? this->Images->GetOverlayLevel(*overlay)
                                : this->Images->GetLevel());
}

void VolumePanel::ShowOverlay()
{
  const StudyVolume* overlay = this->Overlay();
  this->OfOverlay->setVisible(overlay != nullptr);
  if (overlay != nullptr)
  {
    const QSignalBlocker block(this->Opacity);
    this->Colors->setCurrentIndex(static_cast<int>(overlay->Colors));
    this->Opacity->setValue(static_cast<int>(std::lround(OpacitySteps * overlay->Opacity)));
    this->HidesBelow->setChecked(overlay->HidesBelow);
    this->Opacity->setEnabled(this->Study.State().View.Mixing == StudyMixing::Blend);
  }
}

void VolumePanel::ChangeOverlay(const StudyVolume& changed, const QString& what)
{
  const QString message = what + " of " + ScreenString(changed.File.filename().string());
  this->Volumes->Change(message, changed, message);
}

void VolumePanel::SetWindow(double width, double level)
{
  if (const StudyVolume* overlay = this->Overlay())
  {
    StudyVolume changed = *overlay;
    changed.Window = width;
    changed.Level = level;
    this->ChangeOverlay(changed, "Window and level");
  }
  else
  {
    this->Images->SetWindowLevel(width, level);
  }
}

void VolumePanel::TakeOverlay()
{
  StudyVolume changed = *this->Overlay();
  const auto colors = AllVolumeColors.at(static_cast<std::size_t>(this->Colors->currentIndex()));
  const QString what = colors != changed.Colors                              ? "Colours"
                       : this->HidesBelow->isChecked() != changed.HidesBelow ? "Transparency"
                                                                             : "Opacity";
  changed.Colors = colors;
  changed.HidesBelow = this->HidesBelow->isChecked();
  changed.Opacity = static_cast<double>(this->Opacity->value()) / OpacitySteps;
  this->ChangeOverlay(changed, what);
}

void VolumePanel::TakeNumbers()
{
  this->SetWindow(this->Width->value(), this->Level->value());
}

void VolumePanel::TakePreset(int preset)
{
  if (preset == AutomaticPreset && this->Overlay() != nullptr)
  {
    StudyVolume changed = *this->Overlay();
    changed.Window.reset();
    changed.Level.reset();
    this->ChangeOverlay(changed, "Window and level");
  }
  else if (preset == AutomaticPreset)
  {
    this->Images->ResetWindowLevel();
  }
  else if (preset == RangePreset)
  {
    const double* range = this->Image()->GetScalarRange();
    this->SetWindow(range[1] - range[0], 0.5 * (range[0] + range[1]));
  }
  else
  {
    const WindowPreset& chosen = Presets.at(static_cast<std::size_t>(preset - FirstPreset));
    this->SetWindow(chosen.Width, chosen.Level);
  }
}
} // namespace palpate
