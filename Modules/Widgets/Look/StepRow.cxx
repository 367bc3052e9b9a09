#include "StepRow.h"

#include "ScreenString.h"
#include "TextContrast.h"

#include <QGridLayout>
#include <QStyle>

#include <array>
#include <cmath>

namespace palpate
{
namespace
{
// In the order of StudyStepState::Kind; the word repeats the colour's meaning, for the
// colour-blind.
struct StepLook
{
  const char* Sign;
  const char* Color;
  const char* Word;
};
constexpr std::array<StepLook, 6> Looks{{{"\u25CB", "gray", "not needed"},
                                         {"\u2714", "#009E73", "up to date"},
                                         {"\u21AA", "#0072B2", "replaced"},
                                         {"\u25CF", "#E69F00", "needs an update"},
                                         {"\u2716", "#D55E00", "failed"},
                                         {"\u25B6", "#56B4E9", "running"}}};
} // namespace

StepRow::StepRow(SceneStep step, QGridLayout* table, int row, QWidget* parent)
    : QObject(parent), Step(step), Sign(new QLabel(parent)), State(new QLabel(parent)),
      Progress(new QProgressBar(parent)), Button(new QPushButton(parent)),
      Name(new QLabel(NameOf(step), parent))
{
  this->State->setObjectName(QString("state-") + NameOf(step));
  this->Button->setObjectName(QString("act-") + NameOf(step));
  this->Progress->setTextVisible(false);
  this->Progress->setMaximumHeight(this->Name->fontMetrics().height());
  this->Button->setFlat(true);
  table->addWidget(this->Sign, row, 0);
  table->addWidget(this->Name, row, 1);
  table->addWidget(this->State, row, 2);
  table->addWidget(this->Progress, row, 2);
  table->addWidget(this->Button, row, 3);
  connect(this->Button, &QPushButton::clicked, this, &StepRow::Press);
  this->Show({});
}

void StepRow::Show(const StudyStepState& state)
{
  this->Shown = state.Is;
  const StepLook& look = Looks.at(static_cast<std::size_t>(state.Is));
  const bool isRunning = state.Is == StudyStepState::Kind::Running;
  this->Sign->setText(look.Sign);
  QPalette colors = this->State->palette();
  const QColor ground = colors.color(QPalette::Window);
  colors.setColor(QPalette::WindowText, ReadableOn(ground, QColor(look.Color)));
  this->Sign->setPalette(colors);
  this->State->setText(look.Word);
  this->State->setToolTip(PlainToolTip(ScreenString(state.Message)));
  const bool isShown = state.Is != StudyStepState::Kind::NotWanted;
  this->Sign->setVisible(isShown);
  this->Name->setVisible(isShown);
  this->State->setVisible(isShown && !isRunning);
  this->Progress->setVisible(isRunning);
  this->Progress->setToolTip(PlainToolTip(ScreenString(state.Stage)));
  this->Progress->setValue(static_cast<int>(std::lround(100.0 * state.Fraction)));
  this->Button->setText(isRunning ? "Cancel" : "Run again");
  this->Button->setVisible(isRunning || state.Is == StudyStepState::Kind::Failed ||
                           state.Is == StudyStepState::Kind::NeedsUpdate);
}

void StepRow::Press()
{
  if (this->Shown == StudyStepState::Kind::Running)
  {
    Q_EMIT CancelAsked(this->Step);
  }
  else
  {
    Q_EMIT RepeatAsked(this->Step);
  }
}
} // namespace palpate
