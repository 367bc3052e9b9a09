#include "DialPanel.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace palpate
{
namespace
{
constexpr std::uint64_t TicksALook = 500;
constexpr int MostLines = 8;

// In the order of the choices.
enum Choice
{
  ByHand,
  Automatic,
  Rungs
};

QLabel* MakeText(const char* name, QWidget* parent)
{
  auto* label = new QLabel(parent);
  label->setObjectName(name);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

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
      Rung(new QSlider(Qt::Horizontal, this)), Numbers(MakeText("dial-numbers", this)),
      Settings(MakeText("dial-settings", this))
{
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel("Faster", this));
  row->addWidget(this->Rung, 1);
  row->addWidget(new QLabel("Truer", this));
  column->addWidget(this->Mode);
  column->addLayout(row);
  column->addWidget(this->Numbers);
  column->addWidget(this->Settings);
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
                         "can tell. Each structure is measured for it, for some seconds, once.");
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
  QStringList lines;
  QStringList rungs;
  for (const StudyDialLine& line : this->Lines)
  {
    lines += QString::fromStdString(TextOf(line));
    rungs += QString::fromStdString(line.Title + "\n" + line.Rungs);
  }
  const int more = static_cast<int>(lines.size()) - MostLines;
  this->Settings->setToolTip(rungs.join("\n\n"));
  SetText(this->Settings, lines.mid(0, MostLines).join("\n") +
                              (more > 0 ? QString("\nand %1 more").arg(more) : QString()));
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
