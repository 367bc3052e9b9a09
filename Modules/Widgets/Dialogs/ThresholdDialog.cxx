#include "ThresholdDialog.h"

#include "InputError.h"
#include "OwnCopy.h"
#include "SceneLabels.h"
#include "ScreenString.h"

#include "vtkImageData.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr int ValueSteps = 1000;
constexpr double LargestValue = 1e9;

// So that a slider's step can be written.
int DecimalsFor(const ValueHistogram& histogram)
{
  const double step = (histogram.Last - histogram.First) / ValueSteps;
  return std::clamp(static_cast<int>(std::ceil(-std::log10(step))), 0, 9);
}
} // namespace

ThresholdDialog::ThresholdDialog(StudyController& study, vtkImageDisplay* images, QWidget* parent,
                                 int volumeId)
    : QDialog(parent), Study(study), Images(images), VolumeId(volumeId),
      Shown(study.Current().Pipeline().Newest<Volume>(SceneStep::Volume, volumeId)),
      Histogram(HistogramOf(Shown->Image)), Form(new QFormLayout(this)),
      Chart(new HistogramView(Histogram, this)), HasUpper(new QCheckBox("Upper value", this)),
      Masks(new QComboBox(this)), Name(new QLineEdit(this))
{
  const StudyVolume* further = FindVolume(study.State(), volumeId);
  this->setWindowTitle(
      "Structure from image values" +
      (further != nullptr ? " of " + ScreenString(further->File.filename().string()) : QString()));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  this->Add = buttons->button(QDialogButtonBox::Ok);
  this->Add->setText("Add structure");
  this->Form->addRow(this->Chart);
  this->AddValues();
  this->AddPresets();
  this->AddMasks();
  this->Name->setObjectName("threshold-name");
  this->Name->setPlaceholderText("after its values");
  this->Form->addRow("Name", this->Name);
  this->Form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &ThresholdDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(&study, &StudyController::StateChanged, this, &ThresholdDialog::FollowStudy);
  connect(&study, &StudyController::ProductsChanged, this, &ThresholdDialog::FollowStudy);
  this->LowerBox->setValue(OtsuThreshold(this->Histogram));
  this->ShowOnSlices();
}

void ThresholdDialog::AddValues()
{
  QWidget* lower = this->AddValue("threshold-lower", this->LowerBox);
  QWidget* upper = this->AddValue("threshold-upper", this->UpperBox);
  this->Form->addRow("Lower value", lower);
  this->Form->addRow(this->HasUpper, upper);
  this->HasUpper->setObjectName("threshold-has-upper");
  this->HasUpper->setToolTip("Leaves out voxels with higher values");
  this->UpperBox->setValue(this->Histogram.Last);
  upper->setEnabled(false);
  connect(this->HasUpper, &QCheckBox::toggled, upper, &QWidget::setEnabled);
  connect(this->HasUpper, &QCheckBox::toggled, this, &ThresholdDialog::ShowOnSlices);
  connect(this->Chart, &HistogramView::ValueAsked, this->LowerBox, &QDoubleSpinBox::setValue);
}

// A slider over the histogram's range, and a box for any value.
QWidget* ThresholdDialog::AddValue(const char* name, QDoubleSpinBox*& box)
{
  auto* both = new QWidget(this);
  auto* row = new QHBoxLayout(both);
  row->setContentsMargins(0, 0, 0, 0);
  auto* slider = new QSlider(Qt::Horizontal, both);
  slider->setObjectName(QString(name) + "-slider");
  slider->setRange(0, ValueSteps);
  box = new QDoubleSpinBox(both);
  box->setObjectName(name);
  box->setDecimals(DecimalsFor(this->Histogram));
  box->setRange(-LargestValue, LargestValue);
  row->addWidget(slider, 1);
  row->addWidget(box);
  const double first = this->Histogram.First;
  const double step = (this->Histogram.Last - first) / ValueSteps;
  box->setSingleStep(std::max(step, std::pow(10.0, -box->decimals())));
  connect(slider, &QSlider::valueChanged, this,
          [box, first, step](int place) { box->setValue(first + step * place); });
  connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [this, slider, first, step](double value)
          {
            const QSignalBlocker quiet(slider); // a typed value is not rounded to its steps
            const double place = (value - first) / step;
            slider->setValue(static_cast<int>(std::clamp(place, 0.0, 1.0 * ValueSteps)));
            this->ShowOnSlices();
          });
  return both;
}

void ThresholdDialog::AddPresets()
{
  auto* row = new QHBoxLayout;
  const auto add = [&](const QString& text, const char* name, double value)
  {
    auto* button = new QPushButton(text, this);
    button->setObjectName(name);
    button->setAutoDefault(false);
    row->addWidget(button);
    connect(button, &QPushButton::clicked, this,
            [this, value] { this->LowerBox->setValue(value); });
  };
  add("Automatic", "threshold-automatic", OtsuThreshold(this->Histogram));
  if (LooksLikeCt(this->Histogram))
  {
    add("Bone, 300 HU", "threshold-bone", 300.0);
    add("Skin, -300 HU", "threshold-skin", -300.0);
  }
  row->addStretch(1);
  this->Form->addRow("Presets", row);
}

void ThresholdDialog::AddMasks()
{
  this->Masks->setObjectName("threshold-mask");
  this->Form->addRow("Only inside", this->Masks);
  this->ListMasks();
  connect(this->Masks, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          &ThresholdDialog::ShowOnSlices);
}

// The segmentation of a label, if it has been read.
std::shared_ptr<const Segmentation>
ThresholdDialog::SegmentationOf(const SceneStructure& structure) const
{
  const StudyState& state = this->Study.State();
  const StudyPipeline& pipeline = this->Study.Current().Pipeline();
  if (structure.File == state.SegmentationFile)
  {
    return pipeline.Newest<Segmentation>(SceneStep::Segmentation);
  }
  for (const SceneStructure& other : state.Structures)
  {
    auto read = pipeline.Newest<Segmentation>(SceneStep::Segmentation, other.Id);
    if (other.File == structure.File && read != nullptr)
    {
      return read;
    }
  }
  return nullptr;
}

// Labels that have been read, so that the slices can show them.
void ThresholdDialog::ListMasks()
{
  const StudyState& state = this->Study.State();
  const StudyVolume* further = FindVolume(state, this->VolumeId);
  const SceneMove move = further != nullptr ? MoveOf(state, *further) : SceneMove{};
  std::vector<std::pair<int, QString>> offered{{0, "the whole volume"}};
  for (const SceneStructure& structure : state.Structures)
  {
    const bool isLabel = structure.Source() == SceneSource::Label && structure.Labels.size() == 1;
    if (isLabel && structure.Move == move && this->SegmentationOf(structure) != nullptr)
    {
      offered.emplace_back(structure.Id, ScreenString(TitleOf(structure)));
    }
  }
  if (offered == this->Offered)
  {
    return;
  }
  this->Offered = offered;
  const QSignalBlocker quiet(this->Masks);
  const int chosen = this->Masks->currentData().toInt();
  this->Masks->clear();
  for (const auto& [id, title] : offered)
  {
    this->Masks->addItem(title, id);
  }
  this->Masks->setCurrentIndex(std::max(0, this->Masks->findData(chosen)));
}

void ThresholdDialog::FollowStudy()
{
  if (this->Study.Current().Pipeline().Newest<Volume>(SceneStep::Volume, this->VolumeId) !=
      this->Shown)
  {
    this->reject();
    return;
  }
  const int chosen = this->Masks->currentData().toInt();
  this->ListMasks();
  if (this->Masks->currentData().toInt() != chosen)
  {
    this->ShowOnSlices();
  }
}

double ThresholdDialog::Upper() const
{
  return this->HasUpper->isChecked() ? this->UpperBox->value()
                                     : std::numeric_limits<double>::infinity();
}

void ThresholdDialog::ShowOnSlices()
{
  vtkSmartPointer<vtkImageData> mask;
  int value = 0;
  if (const auto* structure =
          FindStructure(this->Study.State(), this->Masks->currentData().toInt()))
  {
    try
    {
      const auto read = this->SegmentationOf(*structure);
      const Segment& segment = SegmentOf(*structure, *read);
      mask = OwnCopy(read->Layers[static_cast<std::size_t>(segment.Layer)].Get());
      value = segment.Value;
    }
    catch (const InputError& error)
    {
      this->Study.Report(error.what()); // the file has no such label any more
    }
  }
  const bool isRange = this->Upper() > this->LowerBox->value();
  this->Add->setEnabled(isRange);
  this->Add->setToolTip(isRange ? "" : "The upper value must be above the lower one");
  this->Chart->ShowRange(this->LowerBox->value(), this->Upper());
  if (this->VolumeId == 0)
  {
    this->Images->MarkValues(this->LowerBox->value(), this->Upper(), mask, value);
  }
}

void ThresholdDialog::accept()
{
  StudyThreshold threshold;
  threshold.Lower = this->LowerBox->value();
  if (this->HasUpper->isChecked())
  {
    threshold.Upper = this->UpperBox->value();
  }
  threshold.WithinId = this->Masks->currentData().toInt();
  threshold.Name = this->Name->text().trimmed().toStdString();
  threshold.VolumeId = this->VolumeId;
  this->QDialog::accept();
  this->Study.AddThreshold(threshold);
}

void ThresholdDialog::done(int result)
{
  disconnect(&this->Study, nullptr, this, nullptr);
  this->Images->ClearMarkedValues();
  this->QDialog::done(result);
}
} // namespace palpate
