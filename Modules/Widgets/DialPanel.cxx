#include "DialPanel.h"

#include "ScreenString.h"

#include <QHBoxLayout>
#include <QSignalBlocker>

namespace palpate
{
namespace
{
constexpr std::uint64_t TicksALook = 500;
constexpr int LeastLength = 120; // pixels, of the slider

// In the order of the choices.
enum Choice
{
  ByHand,
  Automatic,
  Rungs
};

// Without drawing anything where nothing is different.
void SetText(QLabel* label, const QString& text)
{
  if (label->text() != text)
  {
    label->setText(text);
  }
}
} // namespace

DialPanel::DialPanel(StudyController& study, QWidget* parent)
    : QWidget(parent), Study(study), Mode(new QComboBox(this)),
      Rung(new QSlider(Qt::Horizontal, this)), Numbers(new QLabel(this))
{
  this->Numbers->setObjectName("dial-numbers");
  this->Numbers->setWordWrap(true);
  this->Numbers->setTextFormat(Qt::PlainText);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(this->Mode);
  row->addWidget(new QLabel("Faster", this));
  row->addWidget(this->Rung, 1);
  row->addWidget(new QLabel("Truer", this));
  row->addWidget(this->Numbers, 3);
  this->MakeMode();
  this->MakeSlider();
  connect(&study, &StudyController::StateChanged, this, &DialPanel::Show);
  connect(&study, &StudyController::ProductsChanged, this, &DialPanel::Show);
  connect(&study, &StudyController::StepsChanged, this, &DialPanel::Show);
  connect(&study, &StudyController::Touched, this, &DialPanel::MeasureTicks);
  connect(&study, &StudyController::TouchChanged, this,
          [this]
          {
            this->Last = {};
            this->Microseconds = 0.0;
            this->ShowNumbers();
          });
  this->Show();
}

void DialPanel::MakeMode()
{
  this->Mode->setObjectName("dial-mode");
  this->Mode->addItems(
      {"Each structure by hand", "Automatic for each structure", "The dial for all structures"});
  this->Mode->setToolTip("Automatic: the fastest that is as true as the mask's voxels or a hand "
                         "can tell. Each structure is measured for it, once.");
  connect(this->Mode, qOverload<int>(&QComboBox::activated), this,
          [this](int choice)
          {
            this->Turn(choice == ByHand ? StudyDial::ByHand
                       : choice == Automatic
                           ? StudyDial::Automatic
                           : AllStudyRungs.at(static_cast<std::size_t>(this->Rung->value())),
                       {});
          });
}

void DialPanel::MakeSlider()
{
  this->Rung->setObjectName("dial");
  this->Rung->setRange(0, static_cast<int>(AllStudyRungs.size()) - 1);
  this->Rung->setPageStep(1);
  this->Rung->setMinimumWidth(LeastLength);
  this->Rung->setTickPosition(QSlider::TicksBelow);
  this->Rung->setTickInterval(1);
  connect(this->Rung, &QSlider::valueChanged, this,
          [this](int rung)
          { this->Turn(AllStudyRungs.at(static_cast<std::size_t>(rung)), "dial"); });
  connect(this->Rung, &QSlider::sliderReleased, this, [this] { this->Study.EndGesture(); });
}

void DialPanel::Turn(StudyDial dial, const QString& gesture)
{
  StudyState next = this->Study.State();
  next.Dial = dial;
  this->Study.Change(QString("Turn the dial to ") + NameOf(dial), next, gesture);
}

void DialPanel::Show()
{
  const StudyDial dial = this->Study.State().Dial;
  const int rung = RungOf(dial);
  {
    const QSignalBlocker quiet(this->Rung);
    this->Rung->setValue(rung >= 0 ? rung : RungOf(StudyDial::Harmonics12));
  }
  this->Rung->setToolTip(rung >= 0 ? NameOf(dial) : "Move it to have all structures felt alike");
  this->Mode->setCurrentIndex(dial == StudyDial::ByHand      ? ByHand
                              : dial == StudyDial::Automatic ? Automatic
                                                             : Rungs);
  this->Lines = DialLinesOf(this->Study.State(), this->Study.Current().Pipeline());
  QStringList settings;
  for (const StudyDialLine& line : this->Lines)
  {
    const std::string rungs = line.Rungs.empty() ? "" : "\n" + line.Rungs;
    settings += ScreenString(TextOf(line)) + QString::fromStdString(rungs);
  }
  this->Numbers->setToolTip(PlainToolTip(settings.join("\n\n")));
  this->ShowNumbers();
}

void DialPanel::ShowNumbers()
{
  SetText(this->Numbers, QString::fromStdString(DialNumbersText(this->Lines, this->Microseconds)));
}

// Over the last half second or so, so that a turn of the dial is seen.
void DialPanel::MeasureTicks()
{
  const PeriodStatistics& now = this->Study.Reading().Durations;
  if (now.Count() < this->Last.Count())
  {
    this->Last = {};
  }
  const std::uint64_t ticks = now.Count() - this->Last.Count();
  if (this->Study.IsTouching() && ticks >= TicksALook)
  {
    constexpr double Micro = 1e-3;
    const double sum = now.Mean() * static_cast<double>(now.Count()) -
                       this->Last.Mean() * static_cast<double>(this->Last.Count());
    this->Microseconds = Micro * sum / static_cast<double>(ticks);
    this->Last = now;
    this->ShowNumbers();
  }
}
} // namespace palpate
