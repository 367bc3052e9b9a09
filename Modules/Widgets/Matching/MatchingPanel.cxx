#include "MatchingPanel.h"

#include "PlainLabel.h"
#include "ScreenString.h"
#include "TransformFile.h"

#include <QGridLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr std::size_t EnoughPoints = 40; // from which on a predicted error is honest

QString Degrees(double radians)
{
  return QString::number(radians * 180.0 / M_PI, 'f', 1);
}
} // namespace

MatchingPanel::MatchingPanel(StudyController& study, const ViewContents& contents,
                             MatchingLink& link, const FileQuestions& questions, QWidget* parent)
    : QWidget(parent), Study(study), Contents(contents), Link(link), Questions(questions),
      Line(MakePlainLabel("match-line", this)),
      Moving(this->MakeChoice("match-moving", "The organ that is held and moved")),
      Fixed(this->MakeChoice("match-fixed", "The organ that it is brought onto")),
      With(this->MakeChoice("match-volume", "The volume that a kept match moves, too")),
      Size(new QCheckBox("Size too", this)),
      Mode(this->MakeButton("Hold (H)", "match-mode",
                            "Drag the organ in any view; with Ctrl, a drag in a slice turns it")),
      Tool(this->MakeButton("At the tool", "match-tool",
                            "Holds the organ at the tool, which feels how it fits (Shift+H, or "
                            "the device's second button)")),
      Back(this->MakeButton("Put back", "match-back", "Puts the organ back where it was")),
      Keeping(this->MakeButton("Keep...", "match-keep",
                               "Writes the transform to a file, which moves the organ, those of "
                               "its file and the volume from then on"))
{
  this->MakeRows();
  this->Mode->setCheckable(true);
  this->Tool->setCheckable(true);
  connect(this->Mode, &QPushButton::toggled, link.Mode(), &QAction::setChecked);
  connect(link.Mode(), &QAction::toggled, this->Mode, &QPushButton::setChecked);
  connect(this->Tool, &QPushButton::clicked, link.HoldTool(), &QAction::setChecked);
  connect(link.HoldTool(), &QAction::toggled, this->Tool, &QPushButton::setChecked);
  connect(this->Size, &QCheckBox::toggled, this,
          [this](bool isOn)
          {
            HoldRules rules = this->Link.Rules();
            rules.ChangesSize = isOn;
            this->Link.SetRules(rules);
          });
  connect(this->Back, &QPushButton::clicked, this, [this] { this->Link.PutBack(); });
  connect(this->Keeping, &QPushButton::clicked, this, &MatchingPanel::Keep);
  connect(&link, &MatchingLink::Changed, this, &MatchingPanel::Show);
  connect(&study, &StudyController::StateChanged, this, &MatchingPanel::ShowChoices);
  connect(&study, &StudyController::ProductsChanged, this, &MatchingPanel::ShowChoices);
  connect(&study, &StudyController::TouchChanged, this, &MatchingPanel::Show);
  connect(link.Mode(), &QAction::toggled, this, &MatchingPanel::Propose);
  this->ShowChoices();
}

QPushButton* MatchingPanel::MakeButton(const QString& text, const char* name, const QString& tip)
{
  auto* button = new QPushButton(text, this);
  button->setObjectName(name);
  button->setToolTip(tip);
  return button;
}

QComboBox* MatchingPanel::MakeChoice(const char* name, const QString& tip)
{
  auto* box = new QComboBox(this);
  box->setObjectName(name);
  box->setAccessibleName(tip);
  box->setToolTip(tip);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(8);
  connect(box, qOverload<int>(&QComboBox::activated), this, &MatchingPanel::TakeChoice);
  return box;
}

void MatchingPanel::MakeRows()
{
  this->Size->setObjectName("match-size");
  this->Size->setToolTip("Lets a match change the size of the organ, and of the volume");
  this->Line->setWordWrap(true);
  this->Line->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  this->Line->setFixedHeight(2 * this->fontMetrics().lineSpacing() + 2); // views must not move
  auto* grid = new QGridLayout;
  grid->setSpacing(2);
  int row = 0;
  for (const auto& [text, box] :
       {std::pair{"Bring", this->Moving}, {"onto", this->Fixed}, {"with", this->With}})
  {
    grid->addWidget(new QLabel(text, this), row, 0);
    grid->addWidget(box, row++, 1);
  }
  grid->setColumnStretch(1, 1);
  grid->addWidget(this->Mode, 0, 2);
  grid->addWidget(this->Tool, 0, 3);
  grid->addWidget(this->Size, 1, 2);
  grid->addWidget(this->Back, 1, 3);
  grid->addWidget(this->Keeping, 2, 3);
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(4, 2, 4, 2);
  rows->setSpacing(2);
  rows->addWidget(this->Line);
  rows->addLayout(grid);
  rows->addStretch(1);
}

// The structures that are displayed as surfaces, and the further volumes.
void MatchingPanel::ShowChoices()
{
  std::vector<std::pair<int, QString>> organs{{0, "(choose)"}};
  std::vector<std::pair<int, QString>> volumes{{0, "no volume"}};
  const StudyState& state = this->Study.State();
  for (const SceneStructure& structure : state.Structures)
  {
    if (this->Contents.Surfaces().count(structure.Id) > 0)
    {
      organs.emplace_back(structure.Id, ScreenString(TitleOf(structure)));
    }
  }
  for (const StudyVolume& volume : state.Volumes)
  {
    volumes.emplace_back(volume.Id, ScreenString(volume.File.filename().string()));
  }
  const MatchChoice& choice = this->Link.Choice();
  this->Offer(this->Moving, organs, choice.MovingId);
  this->Offer(this->Fixed, organs, choice.FixedId);
  this->Offer(this->With, volumes, choice.VolumeId);
  this->Show();
}

void MatchingPanel::Offer(QComboBox* box, const std::vector<std::pair<int, QString>>& offered,
                          int chosen)
{
  const QSignalBlocker quiet(box);
  const int count = static_cast<int>(offered.size());
  for (int row = 0; row < count; ++row)
  {
    const auto& [id, title] = offered[static_cast<std::size_t>(row)];
    if (row == box->count())
    {
      box->addItem(title, id);
    }
    else if (box->itemData(row) != id || box->itemText(row) != title)
    {
      box->setItemText(row, title); // an open list stays open
      box->setItemData(row, id);
    }
  }
  box->setMaxCount(count); // without those that are no more
  box->setMaxCount(std::numeric_limits<int>::max());
  box->setCurrentIndex(std::max(0, box->findData(chosen)));
}

void MatchingPanel::TakeChoice()
{
  this->Link.Choose({this->Moving->currentData().toInt(), this->Fixed->currentData().toInt(),
                     this->With->currentData().toInt()});
}

// The last organ onto the first one, with a volume if the organ is not of the first volume's
// segmentation.
void MatchingPanel::Propose()
{
  const bool isNew = this->Link.Mode()->isChecked() && this->Link.Choice().MovingId == 0 &&
                     this->Moving->count() > 2;
  if (!isNew)
  {
    return;
  }
  this->Moving->setCurrentIndex(this->Moving->count() - 1);
  this->Fixed->setCurrentIndex(1);
  const SceneStructure* moving =
      FindStructure(this->Study.State(), this->Moving->currentData().toInt());
  const bool isOther = moving != nullptr && moving->File != this->Study.State().SegmentationFile;
  this->With->setCurrentIndex(isOther && this->With->count() > 1 ? 1 : 0);
  this->TakeChoice();
}

void MatchingPanel::Show()
{
  using Phase = HeldOrgan::Phase;
  const Phase phase = this->Link.Organ().Is();
  this->Tool->setEnabled(phase != Phase::Absent && this->Study.IsTouching());
  this->Back->setEnabled(phase != Phase::Absent);
  this->Keeping->setEnabled(phase == Phase::Lying && this->Link.Organ().Match().has_value());
  const QString sentence = this->Sentence();
  if (sentence != this->Line->text())
  {
    this->Line->setText(sentence);
    this->Line->setToolTip(PlainToolTip(sentence));
  }
}

QString MatchingPanel::Sentence() const
{
  const HeldOrgan& organ = this->Link.Organ();
  switch (organ.Is())
  {
  case HeldOrgan::Phase::Absent:
    return this->Link.Mode()->isChecked()
               ? "Choose two organs that are displayed as surfaces: the one that moves, and the "
                 "one that it is brought onto."
               : "Two organs of two scans are brought onto each other by hand, and a match does "
                 "the rest: Hold begins.";
  case HeldOrgan::Phase::Pointed:
  case HeldOrgan::Phase::Carried:
    return QString("Held: it pulls with %1 N. Let go where it nearly fits.")
        .arg(organ.Felt().Force.norm(), 0, 'f', 1);
  case HeldOrgan::Phase::Matching:
    return "Matching...";
  case HeldOrgan::Phase::Moving:
  case HeldOrgan::Phase::Lying:
    break;
  }
  return organ.Match() ? this->SentenceOfMatch()
         : organ.Problem().empty()
             ? "Drag the organ in a view near the other one (Ctrl and a drag in a slice turn it) "
               "and let go; a device holds it at its tool."
             : "No match: " + ScreenString(organ.Problem());
}

QString MatchingPanel::SentenceOfMatch() const
{
  const SurfaceRegistration& match = *this->Link.Organ().Match();
  if (!match.HasConverged)
  {
    return "The match did not end: hold the organ closer to where it fits.";
  }
  const PredictedPoseError& error = match.Error;
  const QString turn = std::isfinite(error.Turn)
                           ? QString(" and %1 degrees").arg(Degrees(error.Turn))
                           : QString("; surfaces like these do not determine its turn");
  const QString few = this->Link.Organ().PointCount() < EnoughPoints
                          ? QString(" Fewer than 40 points: the error is larger than that.")
                          : QString();
  return QString("Matched: surfaces %1 mm apart (root mean square); sure to %2 mm%3 (one standard "
                 "deviation).%4")
      .arg(match.Rms, 0, 'f', 2)
      .arg(error.Shift, 0, 'f', 2)
      .arg(turn, few);
}

void MatchingPanel::Keep()
{
  QString endings;
  for (const std::string& ending : TransformEndings())
  {
    endings += (endings.isEmpty() ? "*" : " *") + QString::fromStdString(ending);
  }
  const QString file = this->Questions.ToSave(this, "Keep the match as a transform", "match.tfm",
                                              "Transforms (" + endings + ")");
  if (!file.isEmpty())
  {
    this->Link.Keep(file.toStdString());
  }
}
} // namespace palpate
