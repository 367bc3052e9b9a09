#include "QualityPanel.h"

#include "ScreenString.h"
#include "Units.h"

#include <QGridLayout>

#include <algorithm>

namespace palpate
{
namespace
{
constexpr std::uint64_t TicksALook = 500;

// Does not repaint if the text is unchanged.
void SetText(QLabel* label, const QString& text)
{
  if (label->text() != text)
  {
    label->setText(text);
  }
}
} // namespace

QualityPanel::QualityPanel(StudyController& study, QWidget* parent)
    : QWidget(parent), Study(study), Preset(new QComboBox(this)),
      Measuring(new QPushButton("Measure", this)),
      Recommended(new QPushButton("Use recommended", this)), Numbers(new QLabel(this))
{
  this->Preset->setObjectName("quality");
  this->Preset->setToolTip("Use the same quality for all structures");
  this->Preset->addItem("Set by hand");
  for (int preset = 0; preset < QualityPresetCount; ++preset)
  {
    this->Preset->addItem(NameOfPreset(preset));
  }
  this->Measuring->setObjectName("quality-measure");
  this->Measuring->setToolTip("Measure speed and accuracy of every preset for every structure");
  this->Recommended->setObjectName("quality-recommended");
  this->Recommended->setToolTip("Use the recommended preset for each structure");
  this->Numbers->setObjectName("quality-numbers");
  this->Numbers->setWordWrap(true);
  this->Numbers->setTextFormat(Qt::PlainText);
  // What is below does not move when the text changes.
  constexpr int MostLines = 3;
  this->Numbers->setMinimumHeight(MostLines * this->fontMetrics().lineSpacing());
  this->Numbers->setAlignment(Qt::AlignTop);
  auto* grid = new QGridLayout(this);
  grid->addWidget(new QLabel("Quality of all", this), 0, 0);
  grid->addWidget(this->Preset, 0, 1);
  grid->addWidget(this->Measuring, 1, 0);
  grid->addWidget(this->Recommended, 1, 1);
  grid->addWidget(this->Numbers, 2, 0, 1, 2);
  connect(this->Preset, qOverload<int>(&QComboBox::activated), this,
          [this](int choice) { this->Choose(choice - 1); });
  connect(this->Measuring, &QPushButton::clicked, this, &QualityPanel::Measure);
  connect(this->Recommended, &QPushButton::clicked, this,
          [this] { this->Study.UseRecommendedQuality(); });
  connect(&study, &StudyController::StateChanged, this, &QualityPanel::Show);
  connect(&study, &StudyController::ProductsChanged, this, &QualityPanel::Show);
  connect(&study, &StudyController::StepsChanged, this, &QualityPanel::Show);
  connect(&study, &StudyController::Touched, this, &QualityPanel::MeasureTicks);
  connect(&study, &StudyController::TouchChanged, this,
          [this]
          {
            this->Last = {};
            this->Microseconds = 0.0;
            this->ShowNumbers();
          });
  this->Show();
}

void QualityPanel::Choose(int preset)
{
  if (preset < 0)
  {
    this->Show(); // this entry cannot be chosen
    return;
  }
  StudyState next = this->Study.State();
  for (SceneStructure& structure : next.Structures)
  {
    structure = WithPreset(structure, preset);
  }
  this->Study.Change(QString("Set the quality to ") + NameOfPreset(preset), next);
}

void QualityPanel::Measure()
{
  this->Study.MeasureQuality();
  this->Show();
}

void QualityPanel::Show()
{
  this->Preset->setCurrentIndex(PresetOf(this->Study.State()) + 1);
  this->Lines = this->Study.Current().QualityLines();
  const auto isMeasured = [](const QualityLine& line) { return !line.Presets.empty(); };
  this->Recommended->setEnabled(std::any_of(this->Lines.begin(), this->Lines.end(), isMeasured));
  this->Measuring->setEnabled(!this->Study.Current().IsMeasuringQuality() &&
                              !std::all_of(this->Lines.begin(), this->Lines.end(), isMeasured));
  QStringList details;
  for (const QualityLine& line : this->Lines)
  {
    const std::string presets = line.Presets.empty() ? "" : "\n" + line.Presets;
    details += ScreenString(TextOf(line)) + QString::fromStdString(presets);
  }
  this->Numbers->setToolTip(PlainToolTip(details.join("\n\n")));
  this->ShowNumbers();
}

void QualityPanel::ShowNumbers()
{
  SetText(this->Numbers,
          QString::fromStdString(QualityNumbersText(this->Lines, this->Microseconds)));
}

// Over about the last half second, so that a change of preset shows.
void QualityPanel::MeasureTicks()
{
  const PeriodStatistics& now = this->Study.Reading().Durations;
  if (now.Count() < this->Last.Count())
  {
    this->Last = {};
  }
  const std::uint64_t ticks = now.Count() - this->Last.Count();
  if (this->Study.IsTouching() && ticks >= TicksALook)
  {
    const double sum = now.Mean() * static_cast<double>(now.Count()) -
                       this->Last.Mean() * static_cast<double>(this->Last.Count());
    this->Microseconds = MicrosecondsPerNanosecond * sum / static_cast<double>(ticks);
    this->Last = now;
    this->ShowNumbers();
  }
}
} // namespace palpate
