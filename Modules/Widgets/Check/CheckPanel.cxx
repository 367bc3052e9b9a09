#include "CheckPanel.h"

#include "CheckGroupFile.h"
#include "CheckText.h"
#include "PlainLabel.h"
#include "ScreenString.h"

#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QSettings>
#include <QVBoxLayout>

#include <memory>

namespace palpate
{
namespace
{
constexpr const char* GroupKey = "check/group";
constexpr const char* FalseAlarmsKey = "check/false-alarms";
constexpr double LeastFalseAlarms = 0.1; // as the command line
constexpr double MostFalseAlarms = 50.0;

double KeptFalseAlarms()
{
  const double kept = QSettings().value(FalseAlarmsKey).toDouble();
  return kept >= LeastFalseAlarms && kept <= MostFalseAlarms ? kept : 5.0;
}

struct CheckedMasks
{
  MaskChecks Found;
  std::string Note; // why the group was not used
};

// The group's file may be empty; throws InputError.
CheckedMasks CheckMasks(const Segmentation& labels, const std::filesystem::path& groupFile,
                        double rate, const ProgressFunction& progress)
{
  CheckedMasks checked;
  CheckSettings settings;
  settings.Rate = rate;
  CheckGroup group;
  if (!groupFile.empty())
  {
    group = ReadCheckGroup(groupFile);
    checked.Note = TooFewCasesText(group, rate);
    settings.Group = checked.Note.empty() ? &group : nullptr;
  }
  checked.Found = MaskChecks::Of(labels, settings, progress);
  checked.Found.Cases.front().Doubtful.clear(); // for pictures of pages
  return checked;
}

// Of all structures as one, which have no row in the table.
QString SentenceOfWhole(const CaseCheck& found)
{
  for (std::size_t n = 0; n < found.Judgements.size(); ++n)
  {
    const OrganJudgement& judgement = found.Judgements[n];
    if (found.Patient.Organs[n].IsWhole && judgement.Is != OrganJudgement::Verdict::Plausible)
    {
      return ScreenString(found.Patient.Organs[n].Name + ": " + VerdictWord(judgement.Is) + ", " +
                          JudgementSentence(judgement)) +
             "\n";
    }
  }
  return {};
}
} // namespace

CheckPanel::CheckPanel(StudyController& study, StructureVerdicts& verdicts,
                       const FileQuestions& questions, QWidget* parent)
    : QWidget(parent), Verdicts(verdicts), Questions(questions),
      Checking(new QPushButton("Check structures", this)),
      Group(MakePlainLabel("check-group", this)), NoGroup(new QPushButton("No group", this)),
      FalseAlarms(new QDoubleSpinBox(this)), Line(new QLabel(this)),
      Job(new PanelJob(study, this->Checking, this->Line, this))
{
  this->Checking->setObjectName("check-start");
  this->NoGroup->setObjectName("check-no-group");
  this->Line->setObjectName("check-line");
  this->Line->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  this->FalseAlarms->setObjectName("check-false-alarms");
  this->FalseAlarms->setRange(LeastFalseAlarms, MostFalseAlarms);
  this->FalseAlarms->setDecimals(1);
  this->FalseAlarms->setSuffix(" %");
  this->FalseAlarms->setToolTip("Share of clean cases, not of structures, that may get a verdict "
                                "other than plausible; needs a group");
  this->FalseAlarms->setValue(KeptFalseAlarms());
  connect(this->FalseAlarms, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
          [](double percent) { QSettings().setValue(FalseAlarmsKey, percent); });
  auto* settings = new QFormLayout;
  settings->addRow(this->Checking);
  settings->addRow("Group", this->MakeGroup());
  settings->addRow("False alarms", this->FalseAlarms);
  auto* text = new QScrollArea(this); // there may be many lines
  text->setWidget(this->Line);
  this->Line->setMargin(4);
  text->setWidgetResizable(true);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(4, 2, 4, 2);
  row->addLayout(settings);
  row->addWidget(text, 1);
  connect(this->Job, &PanelJob::Asked, this, &CheckPanel::Check);
  this->ShowGroup();
  this->Job->End("Whether the masks of the open segmentation can be believed: holes, parts, leaks, "
                 "cuts, missing slices, swapped names, odd shapes. The table of structures marks "
                 "each; a click on a mark shows where.");
}

QLayout* CheckPanel::MakeGroup()
{
  auto* choose = new QPushButton("Choose...", this);
  choose->setObjectName("check-choose-group");
  choose->setToolTip("Clean cases to compare with, as palpate check --make-group wrote them");
  this->NoGroup->setToolTip("Judge by fixed limits; their rate of false alarms is unknown");
  connect(choose, &QPushButton::clicked, this, &CheckPanel::ChooseGroup);
  connect(this->NoGroup, &QPushButton::clicked, this, [this] { this->SetGroup({}); });
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(choose);
  buttons->addWidget(this->NoGroup);
  auto* column = new QVBoxLayout;
  column->addWidget(this->Group);
  column->addLayout(buttons);
  return column;
}

void CheckPanel::ChooseGroup()
{
  const QStringList files = this->Questions.ToOpen(this, "Group of clean cases", "Groups (*.json)");
  if (!files.isEmpty())
  {
    this->SetGroup(files.front());
  }
}

void CheckPanel::SetGroup(const QString& file)
{
  QSettings().setValue(GroupKey, file);
  this->ShowGroup();
}

void CheckPanel::ShowGroup()
{
  const QString file = QSettings().value(GroupKey).toString();
  const QString name = ScreenString(QFileInfo(file).fileName().toStdString());
  const int width = 24 * this->fontMetrics().averageCharWidth();
  this->Group->setText(file.isEmpty()
                           ? QString("none: fixed limits")
                           : this->fontMetrics().elidedText(name, Qt::ElideMiddle, width));
  this->Group->setToolTip(PlainToolTip(file));
  this->NoGroup->setEnabled(!file.isEmpty());
  this->FalseAlarms->setEnabled(!file.isEmpty());
}

void CheckPanel::Check()
{
  if (this->Job->IsRunning())
  {
    return;
  }
  const StructureVerdicts::Masks masks = this->Verdicts.Now();
  if (masks.Labels == nullptr)
  {
    this->Job->End("No segmentation is open: there is no mask to check.");
    return;
  }
  const std::string group = QSettings().value(GroupKey).toString().toStdString();
  const double rate = 0.01 * this->FalseAlarms->value();
  this->Job->Run(
      [this, masks, group, rate](const ProgressFunction& progress)
      {
        auto checked =
            std::make_shared<const CheckedMasks>(CheckMasks(*masks.Named, group, rate, progress));
        return [this, masks, checked]
        { this->Take(masks, checked->Found, ScreenString(checked->Note)); };
      });
}

void CheckPanel::Take(const StructureVerdicts::Masks& masks, const MaskChecks& found,
                      const QString& note)
{
  if (!this->Verdicts.Take(masks, found))
  {
    this->Job->End("The masks have changed meanwhile: check them again.");
    return;
  }
  const CaseCheck& checked = found.Cases.front();
  QString text = ScreenString(CheckTally(found) + ", " + CheckBasis(found)) + ".\n";
  text += note.isEmpty() ? QString() : note + ".\n";
  text += SentenceOfWhole(checked);
  for (const RefusedMask& mask : checked.Refused)
  {
    text += "not checked: " + ScreenString(mask.Message) + "\n";
  }
  this->Job->End(text);
}
} // namespace palpate
